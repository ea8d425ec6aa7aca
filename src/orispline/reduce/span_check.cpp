// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/span_check.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double rounding_of_bounds = 1e-12;  // of bounds, relative, against acceptance
constexpr double unknown = std::numeric_limits<double>::infinity();

/// Not less than (θ/2)/sin(θ/2), for sin x ≥ x - x³/6; infinite from θ = 2 on.
double logarithm_growth(double angle) { return angle < 2.0 ? 1.0 / (1.0 - angle * angle / 24.0) : unknown; }

/// Not less than the angle of the rotation from one to the other [rad]; infinite for half a turn.
double bound_of_angle(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  const double sine = (from.conjugate() * to).vec().norm();
  return 2.0 * sine / std::sqrt(std::max(0.0, 1.0 - sine * sine));  // 2 tan(e/2) ≥ e
}

/// The number between `first` and `last`, both excluded, that is a multiple of the highest power of 2.
std::size_t coarsest_between(std::size_t first, std::size_t last) {
  const auto bit = std::bit_floor(first ^ (last - 1));
  return (last - 1) & ~(bit - 1);
}

}  // namespace

/// One that is to be tested.
class SpanTest::Geodesic {
 public:
  Geodesic(const ToleranceCheck& recording, std::size_t i, std::size_t j, const Eigen::Vector3d& turn)
      : recording_(recording),
        i_(i),
        j_(j),
        turn_(turn),
        start_(recording.samples().times()[i]),
        duration_(recording.samples().times()[j] - start_) {}

  [[nodiscard]] Pose at(std::size_t k) const {
    const Keyframes& samples = recording_.samples();
    const double share = (samples.times()[k] - start_) / duration_;
    Pose pose{.orientation = displaced<double>(samples.orientations()[i_], turn_ * share)};
    if (recording_.bounds_positions())
      pose.position = on_geodesic<double>(samples.positions()[i_], samples.positions()[j_], share);
    return pose;
  }

  /// How far the angle is beyond its tolerance, where the pose is.
  [[nodiscard]] std::optional<Violation> violation(std::size_t k, const Pose& pose) const {
    if (recording_.excess(k, pose.orientation) > 1.0) {
      const double angle = angular_distance(pose.orientation, recording_.samples().orientations()[k]);
      return Violation{k, std::max(0.0, angle - recording_.tolerance().angle)};
    }
    if (recording_.bounds_positions() && recording_.excess(k, pose.position) > 1.0) return Violation{k, 0.0};
    return std::nullopt;
  }

 private:
  const ToleranceCheck& recording_;
  std::size_t i_, j_;
  Eigen::Vector3d turn_;
  double start_, duration_;
};

SpanTest::SpanTest(const ToleranceCheck& recording)
    : recording_(recording), largest_angle_(recording.tolerance().angle - 8.0 * angle_rounding) {
  for (std::size_t intervals = 2; intervals < recording.size(); intervals *= 2) {
    add_level(intervals);
    if (std::ranges::none_of(levels_.back().blocks, &Block::known)) return;
  }
}

void SpanTest::add_level(std::size_t intervals) {
  Level level{.intervals = intervals, .blocks = {}, .largest = {}};
  level.blocks.resize((recording_.size() - 1) / intervals);
  level.largest.resize(level.blocks.size() * level.kept());
  for (std::size_t b = 0; b < level.blocks.size(); ++b) {
    const bool halves_known =
        levels_.empty() || (levels_.back().blocks[2 * b].known && levels_.back().blocks[2 * b + 1].known);
    if (!halves_known || recording_.stopped()) continue;
    const std::size_t first = b * intervals, last = first + intervals;
    level.blocks[b] = fitted(first, last);
    const std::vector<Miss> found = misses(level.blocks[b], first, last);
    const auto kept = level.largest.begin() + static_cast<std::ptrdiff_t>(b * level.kept());
    std::partial_sort_copy(found.begin(), found.end(), kept, kept + static_cast<std::ptrdiff_t>(level.kept()),
                           [](const Miss& a, const Miss& c) { return a.miss > c.miss; });
    level.blocks[b].known = kept->miss < 1.0;
  }
  levels_.push_back(std::move(level));
}

SpanTest::Block SpanTest::fitted(std::size_t first, std::size_t last) const {
  const Keyframes& samples = recording_.samples();
  const std::size_t middle = first + (last - first) / 2;
  const double count = static_cast<double>(last - first + 1);
  Eigen::Matrix<double, 6, 1> mean = Eigen::Matrix<double, 6, 1>::Zero(), slope = mean;
  double square = 0.0, total = 0.0;
  const auto elapsed = [&](std::size_t k) { return samples.times()[k] - samples.times()[middle]; };
  for (std::size_t k = first; k <= last; ++k) total += elapsed(k);
  for (std::size_t k = first; k <= last; ++k) {
    Eigen::Matrix<double, 6, 1> from_middle = Eigen::Matrix<double, 6, 1>::Zero();
    from_middle.head<3>() = shorter_turn(samples.orientations()[middle], samples.orientations()[k]);
    if (recording_.bounds_positions()) from_middle.tail<3>() = samples.positions()[k] - samples.positions()[middle];
    const double offset = elapsed(k) - total / count;
    mean += from_middle / count;
    slope += from_middle * offset;
    square += offset * offset;
  }
  const auto pose = [&](std::size_t k) {
    const Eigen::Matrix<double, 6, 1> line = mean + slope * ((elapsed(k) - total / count) / square);
    Pose at{.orientation = displaced<double>(samples.orientations()[middle], line.head<3>())};
    if (recording_.bounds_positions()) at.position = samples.positions()[middle] + line.tail<3>();
    return at;
  };
  Block block{.first = pose(first), .last = pose(last)};
  block.angle = shorter_turn(block.first.orientation, block.last.orientation).norm();
  return block;
}

std::vector<SpanTest::Miss> SpanTest::misses(const Block& block, std::size_t first, std::size_t last) const {
  const Keyframes& samples = recording_.samples();
  const Eigen::Vector3d turn = shorter_turn(block.first.orientation, block.last.orientation);
  const double start = samples.times()[first], duration = samples.times()[last] - start;
  std::vector<Miss> found;
  for (std::size_t k = first + 1; k < last; ++k) {
    const double share = (samples.times()[k] - start) / duration;
    const Eigen::Quaterniond at = displaced<double>(block.first.orientation, turn * share);
    Miss& miss = found.emplace_back(Miss{angular_distance(at, samples.orientations()[k]) / largest_angle_, k});
    if (!recording_.bounds_positions()) continue;
    const Eigen::Vector3d position = on_geodesic<double>(block.first.position, block.last.position, share);
    miss.miss = std::max(miss.miss, (position - samples.positions()[k]).norm() / recording_.tolerance().position);
  }
  return found;
}

const SpanTest::Level* SpanTest::level_of(const Piece& piece) const {
  const std::size_t intervals = piece.last - piece.first;
  if (!std::has_single_bit(intervals) || intervals == 1 || piece.first % intervals != 0) return nullptr;
  const auto level = static_cast<std::size_t>(std::countr_zero(intervals)) - 1;
  return level < levels_.size() ? &levels_[level] : nullptr;
}

std::vector<std::size_t> SpanTest::farthest_from_block(std::size_t first, std::size_t intervals,
                                                       std::size_t count) const {
  const auto level = static_cast<std::size_t>(std::countr_zero(intervals)) - 1;
  const std::size_t b = first / intervals;
  std::vector<std::size_t> samples;
  if (level < levels_.size() && levels_[level].blocks[b].known) {
    const auto largest = std::span(levels_[level].largest).subspan(b * levels_[level].kept());
    for (std::size_t n = 0; n < std::min(count, levels_[level].kept()); ++n) samples.push_back(largest[n].sample);
  } else {
    const std::size_t step = std::max<std::size_t>(1, intervals / count);
    for (std::size_t k = first + (step + 1) / 2; k < first + intervals; k += step) samples.push_back(k);
  }
  return samples;
}

double SpanTest::distance(const Block& block, const Piece& piece) const {
  const double at_first = bound_of_angle(block.first.orientation, piece.at_first.orientation);
  const double at_last = bound_of_angle(block.last.orientation, piece.at_last.orientation);
  const double angle =
      std::max(at_first, at_last) * logarithm_growth(block.angle + at_first + at_last) / largest_angle_;
  if (!recording_.bounds_positions()) return angle;
  const double position = std::max((block.first.position - piece.at_first.position).norm(),
                                   (block.last.position - piece.at_last.position).norm());
  return std::max(angle, position / recording_.tolerance().position);
}

std::optional<std::span<const SpanTest::Miss>> SpanTest::doubtful(const Piece& piece) const {
  const Level* level = level_of(piece);
  if (!level) return std::nullopt;
  const std::size_t b = piece.first / level->intervals;
  if (!level->blocks[b].known) return std::nullopt;
  const double held = 1.0 - rounding_of_bounds - distance(level->blocks[b], piece);
  const auto largest = std::span(level->largest).subspan(b * level->kept(), level->kept());
  const auto end = std::ranges::partition_point(largest, [held](const Miss& miss) { return !(miss.miss <= held); });
  const auto count = static_cast<std::size_t>(end - largest.begin());
  if (count == largest.size() && count < level->intervals - 1) return std::nullopt;
  return largest.first(count);
}

std::optional<Violation> SpanTest::violation(std::size_t i, std::size_t j, const Eigen::Vector3d& turn) {
  const Geodesic geodesic(recording_, i, j, turn);
  const auto looked_at = [&](std::size_t k, const Pose& pose) {
    const auto found = geodesic.violation(k, pose);
    if (found) failed_ = k;
    return found;
  };
  if (i < failed_ && failed_ < j)
    if (const auto found = looked_at(failed_, geodesic.at(failed_))) return found;
  pieces_.assign(1, {i, j, geodesic.at(i), geodesic.at(j)});
  for (std::size_t next = 0; next < pieces_.size(); ++next) {
    const Piece piece = pieces_[next];
    if (piece.last - piece.first == 1) continue;
    if (const auto samples = doubtful(piece)) {
      for (const Miss& miss : *samples)
        if (const auto found = looked_at(miss.sample, geodesic.at(miss.sample))) return found;
      continue;
    }
    const std::size_t middle = coarsest_between(piece.first, piece.last);
    const Pose pose = geodesic.at(middle);
    if (const auto found = looked_at(middle, pose)) return found;
    pieces_.push_back({piece.first, middle, piece.at_first, pose});
    pieces_.push_back({middle, piece.last, pose, piece.at_last});
  }
  return std::nullopt;
}

}}  // namespace orispline
