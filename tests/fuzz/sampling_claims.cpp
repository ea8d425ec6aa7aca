// SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include <batch/every_kernel.hpp>
#include <batch/sampled.hpp>
#include <batch/segment_size.hpp>
#include <fuzz/claim.hpp>
#include <fuzz/curve_claims.hpp>
#include <fuzz/segment_scale.hpp>
#include <support/specimens.hpp>

namespace orispline::fuzz {

namespace {

using namespace testing_support;

template <class T>
Sampled<T> sampled(const auto& curve, std::span<const double> times, Layout layout = Layout::interleaved) {
  Sampled<T> samples(times.size(), Wanted::jerk, layout);
  const auto done = sample<T>(curve, times, samples.spans());
  claim(done.has_value(), "samples are refused: {}", done ? "" : describe(done.error()));
  return samples;
}

/// Equal numbers, or both none: rates beyond the range of a float are.
bool are_same(const auto& a, const auto& b) {
  return ((a.array() == b.array()) || (a.array().isNaN() && b.array().isNaN())).all();
}

template <class T>
void claim_same_numbers(const Sampled<T>& a, const Sampled<T>& b, std::size_t count, const char* what) {
  for (std::size_t i = 0; i < count; ++i)
    claim(are_same(a.orientation(i), b.orientation(i)) && are_same(a.velocity(i), b.velocity(i)) &&
              are_same(a.acceleration(i), b.acceleration(i)) && are_same(a.jerk(i), b.jerk(i)),
          "{}: sample {} has other bits ({} bytes a number)", what, i, sizeof(T));
}

/// Orientation, velocity, acceleration and jerk of samples of a segment, 13 numbers each.
template <class T>
std::vector<T> by_kernels(const batch::Kernels& kernels, const batch::SegmentRecord<T>& record,
                          std::span<const double> times) {
  const std::size_t n = times.size();
  std::vector<T> numbers(13 * n);
  const batch::Target<T> to{.orientation = numbers.data(),
                            .angular_velocity = numbers.data() + 4 * n,
                            .angular_acceleration = numbers.data() + 7 * n,
                            .angular_jerk = numbers.data() + 10 * n};
  const batch::Clock clock{.times = times.data(), .start = 0.0, .step = 0.0, .first = 0.0};
  run<T>(kernels, record, clock, n, to);
  return numbers;
}

template <class T>
void claim_same_by_every_instruction_set(const AnyCurve& curve) {
  for (std::size_t i = 0; i < curve.knots().segments(); ++i) {
    const KnotSpan span = curve.knots().span(i);
    std::vector<double> times;
    for (int k = 0; k < 11; ++k) times.push_back(span.start() + span.step() * k / 11.0);
    const auto record = batch::record_of<T>(curve, i);
    const std::vector<T> best = by_kernels(batch::kernels(), record, times);
    for (const batch::Kernels* kernels : all_kernels()) {
      const std::vector<T> numbers = by_kernels(*kernels, record, times);
      claim(std::memcmp(numbers.data(), best.data(), sizeof(T) * best.size()) == 0, "segment {}: {} has other bits", i,
            kernels->name);
    }
  }
}

template <class T>
void claim_same_samples(const AnyCurve& curve, std::span<const double> times) {
  const auto samples = sampled<T>(curve, times);
  claim_same_numbers(sampled<T>(curve, times, Layout::planar), samples, times.size(), "planar");
  claim_same_numbers(sampled<T>(CompiledCurve<T>(curve), times), samples, times.size(), "compiled");
  Sampled<T> unsorted(times.size(), Wanted::jerk);
  claim(sample_at<T>(curve, times, unsorted.spans()).has_value(), "sample_at() refuses");
  claim_same_numbers(unsorted, samples, times.size(), "sample_at");
  claim_same_by_every_instruction_set<T>(curve);
}

/// As far as the samples may be from the scalar evaluator's: the limits of the agreement tests, with the rounding of
/// angles over the power of the segment's length in the place of their absolute 1.
template <class T>
std::array<double, 4> allowed(const AnyCurve& curve, std::size_t segment, const Motion& m) {
  const auto [q, w, a, j] = limits<T>();
  const SegmentSize size = size_of(curve, segment);
  const double h = curve.knots().span(segment).step(), angle = std::max(1.0, size.angle);
  return {q * angle, w * angle * std::max({1.0 / h, size.velocity, m.angular_velocity.norm()}),
          a * angle * std::max({1.0 / (h * h), size.acceleration, m.angular_acceleration.norm()}),
          j * angle * std::max({1.0 / (h * h * h), size.jerk, m.angular_jerk.norm()})};
}

template <class T>
constexpr double largest_error_of_norm = 64.0 * static_cast<double>(std::numeric_limits<T>::epsilon());

template <class T>
constexpr double largest_number = static_cast<double>(std::numeric_limits<T>::max());

/// Of an orientation [rad]: segments that turn by more than a million radians have no meaning in a float.
constexpr double largest_rounding = 0.1;

template <class T>
void claim_agreement_at(const AnyCurve& curve, std::span<const double> times) {
  const auto samples = sampled<T>(curve, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::size_t segment = curve.knots().segment_at(times[i]);
    const Motion m = curve.motion(times[i]);
    const std::array<double, 4> largest{1.0, m.angular_velocity.norm(), m.angular_acceleration.norm(),
                                        m.angular_jerk.norm()};
    const std::array<double, 4> off{
        (samples.orientation(i) - m.orientation.coeffs()).template lpNorm<Eigen::Infinity>(),
        (samples.velocity(i) - m.angular_velocity).template lpNorm<Eigen::Infinity>(),
        (samples.acceleration(i) - m.angular_acceleration).template lpNorm<Eigen::Infinity>(),
        (samples.jerk(i) - m.angular_jerk).template lpNorm<Eigen::Infinity>()};
    const double norm = samples.orientation(i).norm();
    claim(std::abs(norm - 1.0) <= largest_error_of_norm<T>, "a sample ({} bytes a number) at t = {} has norm {}",
          sizeof(T), times[i], norm);
    const auto limit = allowed<T>(curve, segment, m);
    if (limit[0] > largest_rounding) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (largest[k] > largest_number<T> / 16.0) break;  // the products on the way there are larger
      claim(off[k] <= limit[k], "order {} of a sample ({} bytes a number) at t = {} is off by {}, allowed {}", k,
            sizeof(T), times[i], off[k], limit[k]);
    }
  }
}

}  // namespace

void claim_same_bits(const AnyCurve& curve) {
  const std::vector<double> times = sample_times(curve.knots().times(), 7);
  claim_same_samples<double>(curve, times);
  claim_same_samples<float>(curve, times);
}

void claim_agreement(const AnyCurve& curve) {
  if (curve.knots().segments() == 0) return;
  const std::vector<double> times = sample_times(curve.knots().times(), 7);
  claim_agreement_at<double>(curve, times);
  claim_agreement_at<float>(curve, times);
}

void claim_baked(const AnyCurve& curve) {
  constexpr double tolerance = 1e-6;  // [rad]
  constexpr std::size_t most_pieces = 2048;
  const auto baked = bake(curve, tolerance, BakeOptions{.max_pieces = most_pieces});
  if (!baked) return claim_plain(baked.error());
  for (const double t : sample_times(curve.knots().times(), 13)) {
    const double off = 2.0 * ((*baked)(t).coeffs() - curve(t).coeffs()).norm();
    claim(off <= tolerance, "the baked curve is {} rad off at t = {}", off, t);
  }
}

}  // namespace orispline::fuzz
