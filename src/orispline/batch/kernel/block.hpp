// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/kernel/record.hpp>
#include <orispline/batch/kernel/vector.hpp>

// Samples are computed in blocks of planes on the stack and then laid out as the caller wants them: loops over planes
// vectorise. In an anonymous namespace, so that every instruction set has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch { namespace {

constexpr int block = 128;
constexpr int lanes = 8;  // the last block is filled up to a multiple

template <class T>
using Plane = T[block];

/// Up to so many samples are computed one by one: faster than a block of `lanes`, and with the same bits.
constexpr std::size_t most_points = 3;

/// What a sample is to hold beside the orientation.
enum class Rates { none, first, second, third };

/// What the loops over a block write for the caller.
template <class T>
struct OutputPlanes {
  alignas(64) Plane<T> q[4], omega[3], alpha[3], jerk[3];

  template <Rates Wanted>
  [[gnu::always_inline]] void store(int i, const BodyRates<T>& rates) {
    store(i, rates.omega, omega);
    if constexpr (Wanted >= Rates::second) store(i, rates.alpha, alpha);
    if constexpr (Wanted >= Rates::third) store(i, rates.jerk, jerk);
  }

 private:
  [[gnu::always_inline]] static void store(int i, const Vector<T>& v, Plane<T> (&to)[3]) {
    to[0][i] = v.x;
    to[1][i] = v.y;
    to[2][i] = v.z;
  }
};

/// The local parameter of sample i.
template <class T, class Record>
[[gnu::always_inline]] inline T local_time(const Record& r, const Clock& clock, std::size_t i) {
  const double t = clock.times ? clock.times[i] : (clock.first + static_cast<double>(i)) * clock.step + clock.start;
  return static_cast<T>((t - r.middle) * r.per_step);
}

/// Local times of every sample of a block.
template <class T, class Record>
[[gnu::always_inline]] inline void local_times(const Record& r, const Clock& clock, std::size_t from, int count,
                                               int padded, Plane<T>& s) {
  const double middle = r.middle, per_step = r.per_step;
  if (clock.times) {
    const double* t = clock.times + from;
    for (int i = 0; i < count; ++i) s[i] = static_cast<T>((t[i] - middle) * per_step);
    for (int i = count; i < padded; ++i) s[i] = T(0);
  } else {
    const double first = clock.first + static_cast<double>(from), step = clock.step, start = clock.start;
    for (int i = 0; i < padded; ++i)
      s[i] = static_cast<T>(((first + static_cast<double>(i)) * step + start - middle) * per_step);
  }
}

/// From planes of one length to the caller's layout, if he wants them.
template <class T, int Components, int Length>
[[gnu::always_inline]] inline void lay_out(const T (&from)[Components][Length], int count, T* to, std::size_t at,
                                           std::ptrdiff_t planes) {
  if (!to) return;
  if (planes != 0) {
    for (int k = 0; k < Components; ++k) {
      T* plane = to + k * planes + at;
      for (int i = 0; i < count; ++i) plane[i] = from[k][i];
    }
    return;
  }
  T* out = to + Components * at;
  if (count == Length) {
#pragma GCC unroll 1  // a short loop too is to be vectorised as one
    for (int i = 0; i < Length; ++i)
      for (int k = 0; k < Components; ++k) out[Components * i + k] = from[k][i];
  } else {
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < Components; ++k) out[Components * i + k] = from[k][i];
  }
}

template <Rates Wanted, class T>
[[gnu::always_inline]] inline void lay_out(const OutputPlanes<T>& planes, int count, const Target<T>& target,
                                           std::size_t at) {
  lay_out(planes.q, count, target.orientation, at, target.planes);
  if constexpr (Wanted != Rates::none) lay_out(planes.omega, count, target.angular_velocity, at, target.planes);
  if constexpr (Wanted >= Rates::second) lay_out(planes.alpha, count, target.angular_acceleration, at, target.planes);
  if constexpr (Wanted >= Rates::third) lay_out(planes.jerk, count, target.angular_jerk, at, target.planes);
}

/// Writes one sample to that layout.
template <class T>
[[gnu::always_inline]] inline void put(const Lanes<T>& q, std::size_t at, const Target<T>& target) {
  if (!target.orientation) return;
  if (target.planes != 0) {
    for (int k = 0; k < 4; ++k) target.orientation[k * target.planes + static_cast<std::ptrdiff_t>(at)] = q[k];
  } else {
    __builtin_memcpy(target.orientation + 4 * at, &q, sizeof q);
  }
}
template <class T>
[[gnu::always_inline]] inline void put(const Vector<T>& v, T* to, std::size_t at, std::ptrdiff_t planes) {
  const std::ptrdiff_t next = planes != 0 ? planes : 1;
  to += planes != 0 ? at : 3 * at;
  to[0] = v.x;
  to[next] = v.y;
  to[2 * next] = v.z;
}
template <class T>
[[gnu::always_inline]] inline void put(const BodyRates<T>& rates, std::size_t at, const Target<T>& target) {
  if (target.angular_velocity) put(rates.omega, target.angular_velocity, at, target.planes);
  if (target.angular_acceleration) put(rates.alpha, target.angular_acceleration, at, target.planes);
  if (target.angular_jerk) put(rates.jerk, target.angular_jerk, at, target.planes);
}

/// Calls `compute(at, here, padded)` for each block of up to `block` samples.
template <class Compute>
[[gnu::always_inline]] inline void in_blocks(std::size_t count, Compute compute) {
  for (std::size_t at = 0; at < count; at += block) {
    const int here = count - at < block ? static_cast<int>(count - at) : block;
    compute(at, here, (here + lanes - 1) / lanes * lanes);
  }
}

/// What is asked for, as a template argument of `run`.
template <class T, class Run>
[[gnu::always_inline]] inline void by_rates(const Target<T>& target, Run run) {
  if (target.angular_jerk) run.template operator()<Rates::third>();
  else if (target.angular_acceleration) run.template operator()<Rates::second>();
  else if (target.angular_velocity) run.template operator()<Rates::first>();
  else run.template operator()<Rates::none>();
}

/// Runs the loop for the rates that single samples want; ω alone saves nothing there.
template <class T, class Run>
[[gnu::always_inline]] inline void by_rates_of_points(const Target<T>& target, Run run) {
  if (target.angular_jerk) run.template operator()<Rates::third>();
  else if (target.angular_velocity || target.angular_acceleration) run.template operator()<Rates::second>();
  else run.template operator()<Rates::none>();
}

}  // namespace

}}}  // namespace orispline::batch
