// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/pose_sampler.hpp>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include <orispline/base/parallel.hpp>
#include <orispline/batch/kernel/dispatch.hpp>
#include <orispline/batch/sample_layout.hpp>

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

namespace {

constexpr std::size_t samples_of_a_block = 128;  // of both factors, which stay in the cache of a thread

/// Samples of a factor, with rates up to the highest order that is asked of the product.
class Block {
 public:
  template <class T>
  void fill(const PoseSampler& factor, std::span<const double> times, const Samples<T>& asked) {
    const std::size_t count = times.size();
    const bool third = !asked.angular_jerks.empty(), second = third || !asked.angular_accelerations.empty();
    const auto rows = [count](std::array<double, 3 * samples_of_a_block>& room, bool are_wanted) {
      return std::span(room).first(are_wanted ? 3 * count : 0);
    };
    const Samples<double> samples{.orientations = std::span(orientations_).first(4 * count),
                                  .angular_velocities = rows(velocities_, wants_angular_rates(asked)),
                                  .angular_accelerations = rows(accelerations_, second),
                                  .angular_jerks = rows(jerks_, third)};
    [[maybe_unused]] const auto done = factor.sample_at<double>(times, samples);  // has all the room that it wants
    ORISPLINE_EXPECT(done.has_value());
  }
  [[nodiscard]] Eigen::Map<const Eigen::Quaterniond> orientation(std::size_t k) const {
    return Eigen::Map<const Eigen::Quaterniond>(orientations_.data() + 4 * k);
  }
  [[nodiscard]] Motion motion(std::size_t k) const {
    const auto at = [k](const std::array<double, 3 * samples_of_a_block>& rows) {
      return Eigen::Vector3d(rows.data() + 3 * k);
    };
    return {orientation(k), at(velocities_), at(accelerations_), at(jerks_)};
  }

 private:
  std::array<double, 4 * samples_of_a_block> orientations_;
  std::array<double, 3 * samples_of_a_block> velocities_{}, accelerations_{}, jerks_{};
};

/// What a block of a product takes; not of the stack, for factors may be products, and these in turn.
struct RoomOfBlock {
  std::array<double, samples_of_a_block> times_of_a, times_of_b;
  Block a, b;
};

}  // namespace

struct PoseSampler::Factors {
  PoseSampler a, b;
  ShiftedClock clock_a, clock_b;

  /// Held at rest outside the domain of the product.
  template <class T>
  [[nodiscard]] Expected<void> sample_at(const Domain& domain, std::span<const double> times, const Samples<T>& out,
                                         Work work) const {
    if (auto error = batch::check_room(out, times.size())) return tl::unexpected(std::move(*error));
    const std::size_t blocks = (times.size() + samples_of_a_block - 1) / samples_of_a_block;
    parallel_for(blocks, work.threads, [&](std::size_t block) {
      const std::size_t begin = block * samples_of_a_block;
      fill<T>(domain, times.subspan(begin, std::min(samples_of_a_block, times.size() - begin)), begin, out);
    });
    return {};
  }

 private:
  template <class T>
  void fill(const Domain& domain, std::span<const double> times, std::size_t begin, const Samples<T>& out) const {
    const auto room_of_block = std::make_unique_for_overwrite<RoomOfBlock>();
    auto& [times_of_a, times_of_b, left, right] = *room_of_block;
    const auto clocked = [&](std::array<double, samples_of_a_block>& room, const PoseSampler& factor,
                             const ShiftedClock& clock) {
      const Domain own = factor.curve().orientation.domain();
      for (std::size_t k = 0; k < times.size(); ++k)  // rounding alone may lead out of its own domain
        room[k] = std::clamp(clock(std::clamp(times[k], domain.start, domain.end)), own.start, own.end);
      return std::span<const double>(room).first(times.size());
    };
    left.fill(a, clocked(times_of_a, a, clock_a), out);
    right.fill(b, clocked(times_of_b, b, clock_b), out);
    if (!wants_angular_rates(out)) {
      for (std::size_t k = 0; k < times.size(); ++k)
        batch::put<4>(out, out.orientations, begin + k, (left.orientation(k) * right.orientation(k)).coeffs());
      return;
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Motion motion = orispline::product(left.motion(k), right.motion(k));
      const bool is_held = times[k] < domain.start || times[k] > domain.end;
      batch::put(out, begin + k, is_held ? Motion{.orientation = motion.orientation} : motion);
    }
  }
};

Expected<PoseSampler> PoseSampler::product(const PoseSampler& a, const PoseSampler& b, ClockOffsets offsets) {
  return product_of(a.curve().orientation, b.curve().orientation, offsets).map([&](AnyCurve curve) {
    PoseSampler sampler(PoseCurve{std::move(curve)});
    sampler.factors_ = std::make_shared<const Factors>(
        Factors{a, b, {a.curve().orientation, offsets.a}, {b.curve().orientation, offsets.b}});
    return sampler;
  });
}

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
    if (factors_) return factors_->sample_at<T>(curve_.orientation.domain(), times, out, work);
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
