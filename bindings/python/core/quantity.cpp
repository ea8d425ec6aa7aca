// SPDX-License-Identifier: Apache-2.0
#include "quantity.hpp"

#include <algorithm>
#include <thread>
#include <type_traits>

#include <orispline/batch/kernel/dispatch.hpp>

#include "errors.hpp"

namespace orispline::python {

namespace {

constexpr std::size_t samples_of_a_cache = std::size_t{1} << 13, samples_of_a_thread = std::size_t{1} << 16;

template <class T>
std::span<T>& target_of(Samples<T>& samples, What what) {
  switch (what) {
    case What::orientation:
      return samples.orientations;
    case What::angular_velocity:
      return samples.angular_velocities;
    case What::angular_acceleration:
      return samples.angular_accelerations;
    case What::angular_jerk:
      return samples.angular_jerks;
    case What::position:
      return samples.positions;
    case What::velocity:
      return samples.velocities;
    default:
      return samples.accelerations;
  }
}

/// Whether times in order are few on each segment that they touch, so that compiling it takes as long as they do.
bool are_few(std::span<const double> times, const Knots& knots) {
  constexpr std::size_t many = 8;
  return !times.empty() && times.size() < many * (knots.segment_at(times.back()) - knots.segment_at(times.front()) + 1);
}

}  // namespace

std::size_t samples_at_a_time(unsigned threads) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  return threads == 1 ? samples_of_a_cache : samples_of_a_thread * threads;
}

template <class T>
Expected<void> sample_into(const PythonCurve& curve, std::span<const double> times, const Samples<T>& out,
                           Extrapolation beyond, unsigned threads) {
  const auto made = [&]() -> Expected<void> {
    if (wants_positions(out)) return sample_at<T>(curve.pose(), times, out, {.threads = threads});
    if constexpr (std::is_same_v<T, double>)
      if (!batch::kernels().are_in_order(times.data(), times.size()) || are_few(times, curve.pose().orientation.knots()))
        return sample_at<T>(curve.compiled(), times, out, {.threads = threads});
    return sample_at<T>(curve.pose().orientation, times, out, {.threads = threads});
  };
  return made().and_then([&] { return extrapolate<T>(curve.pose(), times, beyond, out, {.threads = threads}); });
}

template <class T>
void turn_to_world(const Samples<T>& samples, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Map<const Eigen::Quaternion<T>> q(samples.orientations.data() + 4 * k);
    const auto at = [k](std::span<T> numbers) { return Eigen::Map<Eigen::Matrix<T, 3, 1>>(numbers.data() + 3 * k); };
    if (!samples.angular_jerks.empty())
      at(samples.angular_jerks) =
          (q * (at(samples.angular_jerks) + at(samples.angular_velocities).cross(at(samples.angular_accelerations))))
              .eval();
    if (!samples.angular_accelerations.empty())
      at(samples.angular_accelerations) = (q * at(samples.angular_accelerations)).eval();
    if (!samples.angular_velocities.empty())
      at(samples.angular_velocities) = (q * at(samples.angular_velocities)).eval();
  }
}

template <class T>
Quantity<T>::Quantity(const PythonCurve& curve, int asked, bool world, int beyond, unsigned threads)
    : curve_(curve),
      what_{asked},
      turns_(world && what_ >= What::angular_velocity && what_ <= What::angular_jerk),
      beyond_{beyond},
      threads_(threads) {
  if (what_ >= What::position && !curve.pose().position)
    raise({ErrorCode::bad_argument, "these keys have no positions, wanted positions= of Keys or Curve", {}});
}

template <class T>
Expected<void> Quantity<T>::at(std::span<const double> times, T* memory) {
  if (beyond_ == Extrapolation::error)
    if (auto inside = check_inside(curve_.pose().orientation, times); !inside) return inside;
  const std::size_t most = samples_at_a_time(threads_);
  for (std::size_t begin = 0; begin < times.size(); begin += most)
    if (auto done = part(times.subspan(begin, std::min(most, times.size() - begin)), memory + width() * begin); !done)
      return done;
  return {};
}

template <class T>
Expected<void> Quantity<T>::part(std::span<const double> times, T* memory) {
  const auto room = [count = times.size()](std::vector<T>& numbers, std::size_t columns) {
    numbers.resize(columns * count);
    return std::span<T>(numbers);
  };
  Samples<T> out;
  target_of(out, what_) = {memory, width() * times.size()};
  if (what_ != What::orientation) out.orientations = room(orientations_, 4);
  if (turns_ && what_ == What::angular_jerk) {
    out.angular_velocities = room(angular_velocities_, 3);
    out.angular_accelerations = room(angular_accelerations_, 3);
  }
  auto done = sample_into<T>(curve_, times, out, beyond_, threads_);
  if (done && turns_) turn_to_world(out, times.size());
  return done;
}

template Expected<void> sample_into(const PythonCurve&, std::span<const double>, const Samples<double>&, Extrapolation,
                                    unsigned);
template Expected<void> sample_into(const PythonCurve&, std::span<const double>, const Samples<float>&, Extrapolation,
                                    unsigned);
template void turn_to_world(const Samples<double>&, std::size_t);
template void turn_to_world(const Samples<float>&, std::size_t);
template class Quantity<double>;
template class Quantity<float>;

}  // namespace orispline::python
