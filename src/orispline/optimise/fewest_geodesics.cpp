// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/fewest_geodesics.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <orispline/math/geodesic.hpp>

namespace orispline::optimise {
namespace {

/// Rates that no sample so far forbids [rad/s].
class RateBox {
 public:
  /// After a sample at the rotation vector `turn`, `elapsed` seconds later.
  void narrow(const Eigen::Vector3d& turn, double elapsed, double tolerance) {
    const double angle = turn.norm() + tolerance;
    if (!(angle < largest_angle)) return;
    const double half = 0.5 * angle;
    const double stretch = half / std::sin(half);
    const double radius = tolerance * stretch * (1.0 + rounding) / elapsed;
    lowest_ = lowest_.cwiseMax((turn / elapsed).array() - radius);
    highest_ = highest_.cwiseMin((turn / elapsed).array() + radius);
  }
  [[nodiscard]] bool is_empty() const { return (lowest_ > highest_).any(); }
  [[nodiscard]] bool holds(const Eigen::Vector3d& rate) const {
    return (lowest_ <= rate.array() && rate.array() <= highest_).all();
  }

 private:
  static constexpr double largest_angle = 0.999 * std::numbers::pi;  // below the cut of the logarithm
  static constexpr double rounding = 1e-9;                           // in favour of the rate

  Eigen::Array3d lowest_ = Eigen::Array3d::Constant(-std::numeric_limits<double>::infinity());
  Eigen::Array3d highest_ = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
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
        unreached_(recording.size()),
        before_(recording.size(), 0),
        turns_(recording.size()),
        turned_from_(recording.size(), recording.size()) {}

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
    Eigen::Quaterniond to = orientation(k);
    if (orientation(i).dot(to) < 0.0) to.coeffs() = -to.coeffs();
    return turns_[k] = increment<double>(orientation(i), to);
  }

  /// Reaches what can be reached from sample i.
  void extend(std::size_t i, std::vector<std::size_t>& reached) {
    constexpr std::size_t looks_per_doubling = 16;  // fewer make the boxes wider, more cost logarithms
    RateBox box;
    std::size_t looked = i;
    for (std::size_t j = unreached_.from(i + 1); j < recording_.size(); j = unreached_.from(j + 1)) {
      for (; looked + stride_after(looked - i, looks_per_doubling) < j && !box.is_empty();) {
        looked += stride_after(looked - i, looks_per_doubling);
        box.narrow(turn(i, looked), time(looked) - time(i), recording_.tolerance().angle);
      }
      if (box.is_empty()) return;
      const Eigen::Vector3d whole = turn(i, j);
      if (!box.holds(whole / (time(j) - time(i))) || !holds_between(i, j, whole)) continue;
      unreached_.reach(j);
      before_[j] = i;
      reached.push_back(j);
    }
  }
  static std::size_t stride_after(std::size_t passed, std::size_t per_doubling) { return 1 + passed / per_doubling; }

  /// Whether the span from i to j passes near all samples between; the one that failed last comes first.
  bool holds_between(std::size_t i, std::size_t j, const Eigen::Vector3d& whole) {
    if (i < failed_ && failed_ < j && !holds_at(i, j, whole, failed_)) return false;
    constexpr std::size_t coarse = 16;
    for (std::size_t k = j - 1; k > i; k -= std::min(k - i, coarse))
      if (!holds_at(i, j, whole, k)) return failed_ = k, false;
    for (std::size_t k = i + 1; k < j; ++k)
      if (!holds_at(i, j, whole, k)) return failed_ = k, false;
    return true;
  }
  [[nodiscard]] bool holds_at(std::size_t i, std::size_t j, const Eigen::Vector3d& whole, std::size_t k) {
    const double share = (time(k) - time(i)) / (time(j) - time(i));
    // Rotations are not farther from each other than their rotation vectors: most samples need no sines.
    const double bound = recording_.tolerance().angle - 2.0 * angle_rounding;
    if ((whole * share - turn(i, k)).squaredNorm() > bound * bound &&
        recording_.excess(k, displaced<double>(orientation(i), whole * share)) > 1.0)
      return false;
    if (!recording_.bounds_positions()) return true;
    const auto positions = recording_.samples().positions();
    return recording_.excess(k, on_geodesic<double>(positions[i], positions[j], share)) <= 1.0;
  }

  const Recording& recording_;
  Unreached unreached_;
  std::vector<std::size_t> before_;       ///< the sample before in the shortest chain
  std::vector<Eigen::Vector3d> turns_;    ///< from the sample that was asked for last [rad]
  std::vector<std::size_t> turned_from_;  ///< that sample
  std::size_t failed_ = 0;
};

}  // namespace

std::vector<std::size_t> fewest_geodesics(const Recording& recording) { return Chains(recording).shortest(); }

}  // namespace orispline::optimise
