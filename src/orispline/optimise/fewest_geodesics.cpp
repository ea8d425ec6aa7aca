// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/fewest_geodesics.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <orispline/optimise/span_test.hpp>

namespace orispline::optimise {
namespace {

/// The middles of the faces, edges and corners of a cube, one of each opposite two.
Eigen::Matrix<double, 13, 3> unit_directions() {
  Eigen::Matrix<double, 13, 3> directions;
  directions << 1, 0, 0, 0, 1, 0, 0, 0, 1,                      //
      0, 1, 1, 0, 1, -1, 1, 0, 1, 1, 0, -1, 1, 1, 0, 1, -1, 0,  //
      1, 1, 1, -1, 1, 1, 1, -1, 1, 1, 1, -1;
  return directions.rowwise().normalized();
}

/// Rates that no sample so far forbids [rad/s], or a few more: between planes across some directions.
class RateBounds {
 public:
  /// After a sample at the rotation vector `turn`, `elapsed` seconds later.
  void narrow(const Eigen::Vector3d& turn, double elapsed, double tolerance) {
    const double angle = turn.norm() + tolerance;
    if (!(angle < largest_angle)) return;
    const double half = 0.5 * angle;
    const double stretch = half / std::sin(half);
    const double radius = tolerance * stretch * (1.0 + rounding) / elapsed;
    const Array along = directions * (turn / elapsed);
    lowest_ = lowest_.max(along - radius);
    highest_ = highest_.min(along + radius);
  }
  [[nodiscard]] bool are_empty() const { return (lowest_ > highest_).any(); }
  /// How far a rate is outside, across the worst plane [rad/s].
  [[nodiscard]] double distance(const Eigen::Vector3d& rate) const {
    const Array along = directions * rate;
    return (lowest_ - along).max(along - highest_).maxCoeff();
  }

 private:
  using Array = Eigen::Array<double, 13, 1>;
  static constexpr double largest_angle = 0.999 * std::numbers::pi;  // below the cut of the logarithm
  static constexpr double rounding = 1e-9;                           // in favour of the rate
  static const inline Eigen::Matrix<double, 13, 3> directions = unit_directions();

  Array lowest_ = Array::Constant(-std::numeric_limits<double>::infinity());
  Array highest_ = Array::Constant(std::numeric_limits<double>::infinity());
};

/// Samples that no chain has reached yet, after any sample the next of them.
class Unreached {
 public:
  explicit Unreached(std::size_t size) : next_(size + 1) {
    for (std::size_t i = 0; i <= size; ++i) next_[i] = i;
  }
  /// The first one from i on; the size where there is none.
  [[nodiscard]] std::size_t from(std::size_t i) {
    while (next_[i] != i) i = next_[i] = next_[next_[i]];
    return i;
  }
  void reach(std::size_t i) { next_[i] = i + 1; }

 private:
  std::vector<std::size_t> next_;
};

class Chains {
 public:
  explicit Chains(const Recording& recording)
      : recording_(recording),
        spans_(recording),
        unreached_(recording.size()),
        before_(recording.size(), 0),
        turns_(recording.size()),
        turned_from_(recording.size(), recording.size()),
        path_(recording.size(), 0.0) {
    for (std::size_t i = 1; i < path_.size(); ++i)
      path_[i] = path_[i - 1] + angular_distance(orientation(i - 1), orientation(i));
  }

  std::vector<std::size_t> shortest() {
    unreached_.reach(0);
    const std::size_t last = recording_.size() - 1;
    std::vector<std::size_t> level{0};
    while (unreached_.from(last) == last) {
      std::vector<std::size_t> next;
      for (const std::size_t i : level) extend(i, next);
      std::sort(next.begin(), next.end());
      level = std::move(next);
    }
    std::vector<std::size_t> chain{last};
    while (chain.back() != 0) chain.push_back(before_[chain.back()]);
    return {chain.rbegin(), chain.rend()};
  }

 private:
  [[nodiscard]] double time(std::size_t i) const { return recording_.samples().times()[i]; }
  [[nodiscard]] Eigen::Quaterniond orientation(std::size_t i) const { return recording_.samples().orientations()[i]; }

  /// The shorter way from sample i to sample k [rad].
  [[nodiscard]] const Eigen::Vector3d& turn(std::size_t i, std::size_t k) {
    if (std::exchange(turned_from_[k], i) == i) return turns_[k];
    return turns_[k] = shorter_turn(orientation(i), orientation(k));
  }

  /// To the rates from sample i that pass near sample k.
  void narrow(RateBounds& bounds, std::size_t i, std::size_t k) {
    bounds.narrow(turn(i, k), time(k) - time(i), recording_.tolerance().angle);
  }

  /// Reaches what can be reached from sample i.
  void extend(std::size_t i, std::vector<std::size_t>& reached) {
    RateBounds bounds;
    std::size_t looked = i;
    for (std::size_t j = unreached_.from(i + 1); j < recording_.size();) {
      for (std::size_t next = looked_after(i, looked); next < j && !bounds.are_empty();
           next = looked_after(i, looked)) {
        looked = next;
        narrow(bounds, i, looked);
      }
      if (bounds.are_empty()) return;
      double lacking = bounds.distance(turn(i, j) / (time(j) - time(i)));
      if (lacking <= 0.0) {
        if (const auto violation = spans_.violation(i, j, turn(i, j))) {
          lacking = violation->beyond / (time(violation->sample) - time(i));
          narrow(bounds, i, violation->sample);
        } else {
          unreached_.reach(j);
          before_[j] = i;
          reached.push_back(j);
        }
      }
      j = unreached_.from(lacking > 0.0 ? next_worth_a_look(i, j, lacking) : j + 1);
    }
  }

  /// The sample that narrows the rates next: 16 for every doubling of the span; fewer leave the bounds wider, more cost
  /// logarithms.
  static std::size_t looked_after(std::size_t i, std::size_t looked) { return looked + 1 + (looked - i) / 16; }

  /// The first sample after j for which the mean rate from sample i may differ by `lacking` [rad/s] from that for j.
  [[nodiscard]] std::size_t next_worth_a_look(std::size_t i, std::size_t j, double lacking) const {
    constexpr double stretch = 1.1107207345395916;  // of the logarithm up to a quarter turn: (π/4)/sin(π/4)
    constexpr double rounding = 1e-9;
    const double angle = turns_[j].norm(), elapsed = time(j) - time(i);
    std::size_t passed = j;
    for (std::size_t step = 1; j + step < recording_.size(); step *= 2) {
      const double path = path_[j + step] - path_[j], later = time(j + step) - time(i);
      const double change = stretch * path / later + angle * (1.0 / elapsed - 1.0 / later);
      if (angle + path > 0.5 * std::numbers::pi || change * (1.0 + rounding) >= lacking) break;
      passed = j + step;
    }
    return passed + 1;
  }

  const Recording& recording_;
  SpanTest spans_;
  Unreached unreached_;
  std::vector<std::size_t> before_;       ///< the sample before in the shortest chain
  std::vector<Eigen::Vector3d> turns_;    ///< from the sample that was asked for last [rad]
  std::vector<std::size_t> turned_from_;  ///< that sample
  std::vector<double> path_;              ///< angle travelled up to each sample [rad]
};

}  // namespace

std::vector<std::size_t> fewest_geodesics(const Recording& recording) { return Chains(recording).shortest(); }

}  // namespace orispline::optimise
