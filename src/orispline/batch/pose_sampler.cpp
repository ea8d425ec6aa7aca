// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/pose_sampler.hpp>

#include <type_traits>
#include <utility>

#include <orispline/batch/kernel/dispatch.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t samples_of_a_cache = std::size_t{1} << 13, samples_of_a_thread = std::size_t{1} << 16;
constexpr std::size_t usual_threads = 8;  // of one per core, enough to keep busy as many as there are

/// Whether times in order are few on each segment that they touch, so that compiling it takes as long as they do.
bool are_few(std::span<const double> times, const Knots& knots) {
  constexpr std::size_t many = 8;
  return !times.empty() && times.size() < many * (knots.segment_at(times.back()) - knots.segment_at(times.front()) + 1);
}

}  // namespace

std::size_t samples_at_a_time(Work work) {
  if (work.threads == 1) return samples_of_a_cache;
  return samples_of_a_thread * (work.threads == 0 ? usual_threads : work.threads);
}

PoseSampler::PoseSampler(PoseCurve curve)
    : curve_(std::move(curve)), compiled_(curve_.orientation, Compiling::as_wanted) {}

template <class T>
Expected<void> PoseSampler::sample_at(std::span<const double> times, const Samples<T>& out, Extrapolation beyond,
                                      RateFrame frame, Work work) const {
  const auto made = [&]() -> Expected<void> {
    if (wants_positions(out)) return orispline::sample_at<T>(curve_, times, out, work);
    if constexpr (std::is_same_v<T, double>)
      if (!batch::kernels().are_in_order(times.data(), times.size()) || are_few(times, curve_.orientation.knots()))
        return orispline::sample_at<T>(compiled_, times, out, work);
    return orispline::sample_at<T>(curve_.orientation, times, out, work);
  };
  auto done = made().and_then([&] { return extrapolate<T>(curve_, times, beyond, out, work); });
  if (done && frame == RateFrame::world) turn_to_world(out);
  return done;
}

template <class T>
void turn_to_world(const Samples<T>& samples) {
  for (std::size_t k = 0; k < samples.size(); ++k) {
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

template Expected<void> PoseSampler::sample_at(std::span<const double>, const Samples<double>&, Extrapolation,
                                               RateFrame, Work) const;
template Expected<void> PoseSampler::sample_at(std::span<const double>, const Samples<float>&, Extrapolation, RateFrame,
                                               Work) const;
template void turn_to_world(const Samples<double>&);
template void turn_to_world(const Samples<float>&);

}}  // namespace orispline
