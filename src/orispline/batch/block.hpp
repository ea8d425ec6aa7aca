// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <orispline/batch/record.hpp>

// How the kernels' loops read times and write samples. In an anonymous namespace, so that every instruction set has its
// own.

namespace orispline::batch {
namespace {

/// Samples are computed in planes of this length on the stack and then laid out: the loops over a block vectorise.
constexpr int block = 128;
constexpr int lanes = 8;  // the last block is filled up to a multiple

template <class T>
using Plane = T[block];

/// The local parameter of every sample of a block.
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

/// From planes to the caller's layout.
template <class T, int Components>
[[gnu::always_inline]] inline void lay_out(const Plane<T> (&from)[Components], int count, T* to, std::size_t at,
                                           std::ptrdiff_t planes) {
  if (planes != 0) {
    for (int k = 0; k < Components; ++k) {
      T* plane = to + k * planes + at;
      for (int i = 0; i < count; ++i) plane[i] = from[k][i];
    }
    return;
  }
  T* out = to + Components * at;
  if (count == block) {
    for (int i = 0; i < block; ++i)
      for (int k = 0; k < Components; ++k) out[Components * i + k] = from[k][i];
  } else {
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < Components; ++k) out[Components * i + k] = from[k][i];
  }
}

}  // namespace
}  // namespace orispline::batch
