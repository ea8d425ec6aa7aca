// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/span_test.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

#include <orispline/math/geodesic.hpp>

namespace orispline::optimise {
namespace {

constexpr double rounding = 1e-12;  // of bounds, relative, against acceptance
constexpr double unknown = std::numeric_limits<double>::infinity();

/// Not less than (θ/2)/sin(θ/2), for sin x ≥ x - x³/6; infinite from θ = 2 on.
double stretch(double angle) { return angle < 2.0 ? 1.0 / (1.0 - angle * angle / 24.0) : unknown; }

/// The number between `first` and `last`, both excluded, that is a multiple of the highest power of 2.
std::size_t coarsest_between(std::size_t first, std::size_t last) {
  const auto bit = std::bit_floor(first ^ (last - 1));
  return (last - 1) & ~(bit - 1);
}

}  // namespace

/// One that is to be tested.
class SpanTest::Geodesic {
 public:
  Geodesic(const Recording& recording, std::size_t i, std::size_t j, const Eigen::Vector3d& turn)
      : recording_(recording),
        i_(i),
        j_(j),
        turn_(turn),
        start_(recording.samples().times()[i]),
        duration_(recording.samples().times()[j] - start_) {}

  /// Fails with how far the angle is beyond its tolerance.
  [[nodiscard]] tl::expected<Distance, double> distance(std::size_t k) const {
    const Keyframes& samples = recording_.samples();
    const double share = (samples.times()[k] - start_) / duration_;
    const Eigen::Quaterniond at = displaced<double>(samples.orientations()[i_], turn_ * share);
    const Eigen::Quaterniond& sample = samples.orientations()[k];
    if (recording_.excess(k, at) > 1.0)
      return tl::unexpected(std::max(0.0, angular_distance(at, sample) - recording_.tolerance().angle));
    const double sine = (at.conjugate() * sample).vec().norm();
    Distance found{.angle = 2.0 * sine / std::sqrt(std::max(0.0, 1.0 - sine * sine))};  // 2 tan(e/2) ≥ e
    if (!recording_.bounds_positions()) return found;
    const auto positions = samples.positions();
    const Eigen::Vector3d position = on_geodesic<double>(positions[i_], positions[j_], share);
    if (recording_.excess(k, position) > 1.0) return tl::unexpected(0.0);
    found.position = (position - positions[k]).norm();
    return found;
  }

 private:
  const Recording& recording_;
  std::size_t i_, j_;
  Eigen::Vector3d turn_;
  double start_, duration_;
};

SpanTest::SpanTest(const Recording& recording)
    : recording_(recording), largest_angle_(recording.tolerance().angle - 8.0 * angle_rounding) {
  for (std::size_t intervals = 2; intervals < recording.size(); intervals *= 2) {
    add_level(intervals);
    const bool useful = std::ranges::any_of(chords_.back(), [](const Chord& chord) { return chord.miss != unknown; });
    if (!useful) return;
  }
}

void SpanTest::add_level(std::size_t intervals) {
  const Chord none{.angle = unknown, .miss = unknown, .position_miss = unknown};
  std::vector<Chord> level((recording_.size() - 1) / intervals, none);
  for (std::size_t b = 0; b < level.size(); ++b) {
    const bool halves_known =
        chords_.empty() || (chords_.back()[2 * b].miss != unknown && chords_.back()[2 * b + 1].miss != unknown);
    if (!halves_known) continue;
    const Chord chord = chord_of(b * intervals, (b + 1) * intervals);
    if (chord.miss < recording_.tolerance().angle && chord.position_miss < recording_.tolerance().position)
      level[b] = chord;
  }
  chords_.push_back(std::move(level));
}

SpanTest::Chord SpanTest::chord_of(std::size_t first, std::size_t last) const {
  const Keyframes& samples = recording_.samples();
  const Eigen::Quaterniond &from = samples.orientations()[first], &to = samples.orientations()[last];
  const Eigen::Vector3d turn = shorter_turn(from, to);
  const double start = samples.times()[first], duration = samples.times()[last] - start;
  Chord chord{.angle = turn.norm(), .miss = 0.0, .position_miss = 0.0};
  for (std::size_t k = first + 1; k < last; ++k) {
    const double share = (samples.times()[k] - start) / duration;
    const Eigen::Quaterniond at = displaced<double>(from, turn * share);
    chord.miss = std::max(chord.miss, angular_distance(at, samples.orientations()[k]));
    if (!recording_.bounds_positions()) continue;
    const auto positions = samples.positions();
    const Eigen::Vector3d position = on_geodesic<double>(positions[first], positions[last], share);
    chord.position_miss = std::max(chord.position_miss, (position - positions[k]).norm());
  }
  return chord;
}

bool SpanTest::holds(const Piece& piece) const {
  const std::size_t intervals = piece.last - piece.first;
  if (intervals == 1) return true;
  const auto level = static_cast<std::size_t>(std::countr_zero(intervals)) - 1;
  if (!std::has_single_bit(intervals) || piece.first % intervals != 0 || level >= chords_.size()) return false;
  const Chord& chord = chords_[level][piece.first / intervals];
  const double ends = std::max(piece.at_first.angle, piece.at_last.angle);
  const double angle = chord.angle + piece.at_first.angle + piece.at_last.angle;
  const double position = std::max(piece.at_first.position, piece.at_last.position) + chord.position_miss;
  return (ends * stretch(angle) + chord.miss) * (1.0 + rounding) <= largest_angle_ &&
         (!recording_.bounds_positions() || position * (1.0 + rounding) <= recording_.tolerance().position);
}

std::optional<Violation> SpanTest::violation(std::size_t i, std::size_t j, const Eigen::Vector3d& turn) {
  const Geodesic geodesic(recording_, i, j, turn);
  const auto fails = [this](std::size_t k, double beyond) { return failed_ = k, Violation{k, beyond}; };
  if (i < failed_ && failed_ < j)
    if (const auto distance = geodesic.distance(failed_); !distance) return fails(failed_, distance.error());
  pieces_.assign(1, {i, j, {}, {}});
  for (std::size_t next = 0; next < pieces_.size(); ++next) {
    const Piece piece = pieces_[next];
    if (holds(piece)) continue;
    const std::size_t middle = coarsest_between(piece.first, piece.last);
    const auto distance = geodesic.distance(middle);
    if (!distance) return fails(middle, distance.error());
    pieces_.push_back({piece.first, middle, piece.at_first, *distance});
    pieces_.push_back({middle, piece.last, *distance, piece.at_last});
  }
  return std::nullopt;
}

}  // namespace orispline::optimise
