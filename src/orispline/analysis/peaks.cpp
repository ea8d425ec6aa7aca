// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <orispline/analysis/rate_reach.hpp>
#include <orispline/analysis/segment_motions.hpp>
#include <orispline/curve/motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double gap = 9e-4;            // of a bound above the largest value found, relative
constexpr double resolution = 1e-7;     // the same of an estimate
constexpr double worth_climbing = 0.8;  // of the largest square found: below it no step rises so far above its ends
/// |ω|² is resolved where it is so near to the cubics between the steps, of the largest on the part; where |ω| is below
/// so much of the largest found, the body rests, and differences are rounding.
constexpr double resolved = 3e-3, rate_at_rest = 1e-6;
/// Nor is it where the body turns farther on a step [rad]: rates rise and fall within a part of a turn. A curve that
/// may turn this far has too many turns to look at each.
constexpr double resolved_turn = 0.2, most_turn = 1e4;
constexpr int most_bisections = 60;
constexpr double least_share = 1e-9;  // of a segment, that is still cut
constexpr double least_steps = 64.0;  // of time's rounding, the same
/// Parts that are cut, beside one a segment.
constexpr std::size_t most_parts = std::size_t{1} << 15;

/// The rates of a curve on its segments.
struct Searched {
  const AnyCurve& curve;
  const Eigen::Matrix3d& inertia;
  std::size_t rates = inertia == Eigen::Matrix3d::Identity() ? 2 : 3;  // of unit inertia the torque is α

  /// Vectors and no Motion: copies of one cost more than the rest.
  [[nodiscard]] RateSample of(double t, const Eigen::Vector3d& velocity, const Eigen::Vector3d& acceleration,
                              const Eigen::Vector3d& jerk) const {
    const auto height = [](const Eigen::Vector3d& rate, const Eigen::Vector3d& derivative) {
      return RateHeight{rate.squaredNorm(), rate.dot(derivative)};
    };
    RateSample sample{t, {height(velocity, acceleration), height(acceleration, jerk)}, jerk.squaredNorm()};
    if (rates < 3) return sample;
    const Motion m{.angular_velocity = velocity, .angular_acceleration = acceleration, .angular_jerk = jerk};
    sample.heights[2] = height(torque(m, inertia), torque_rate(m, inertia));
    return sample;
  }
  [[nodiscard]] RateSample at(std::size_t segment, double t) const {
    const Motion m = curve.motion_on(segment, t);
    return of(t, m.angular_velocity, m.angular_acceleration, m.angular_jerk);
  }
  [[nodiscard]] RateSamples between(SegmentMotions& motions, double start, double end) const {
    std::array<double, times_of_part> times;
    for (std::size_t i = 0; i < steps_of_part; ++i)
      times[i] = start + (end - start) * (static_cast<double>(i) / double{steps_of_part});
    times.back() = end;
    motions.evaluate(times);
    RateSamples samples;
    for (std::size_t i = 0; i < times.size(); ++i)
      samples[i] = of(times[i], motions.angular_velocity(i), motions.angular_acceleration(i), motions.angular_jerk(i));
    return samples;
  }
};

/// A step at whose ends a rate rises and falls: a maximum lies between.
struct Summit {
  std::size_t segment, rate;
  double start, end;
  double square, reach;  ///< the larger one at the ends, and the size that it may reach
};

/// A part of a segment, and what the rates may reach there.
struct Part {
  std::size_t segment;
  double start, end;  ///< [s]
  StepReach reach;
  RateSizes rounding;
  double near_enough;     ///< above the largest value found, relative
  double priority = 0.0;  ///< when it was found; 0: it need not be cut
};

class LargestRates {
 public:
  explicit LargestRates(const Searched& searched)
      : searched_(searched), moments_(searched.inertia), knots_(searched.curve.knots().times()) {}

  void look_at(std::size_t segment);
  void refine();
  [[nodiscard]] Peak peak(std::size_t rate) const {
    const Best& best = best_[rate];
    const double value = best.size(), bound = std::max(best.bound, value);
    return {value, best.time, are_bounds_ && std::isfinite(bound) ? std::optional(bound) : std::nullopt};
  }

 private:
  struct Best {
    double square = -1.0, time = 0.0, bound = 0.0;
    [[nodiscard]] double size() const { return std::sqrt(std::max(square, 0.0)); }
  };

  void see(const RateSample& sample, std::size_t rate) {
    if (!(sample.heights[rate].square > best_[rate].square)) return;
    best_[rate].square = sample.heights[rate].square;
    best_[rate].time = sample.time;
  }
  void see(const RateSamples& samples) {
    for (const RateSample& sample : samples)
      for (std::size_t k = 0; k < searched_.rates; ++k) see(sample, k);
  }
  void note_summit(std::size_t segment, const RateSample& a, const RateSample& b, const RateSizes& reach);
  [[nodiscard]] bool is_worth_climbing(const Summit& summit) const {
    const Best& best = best_[summit.rate];
    return summit.square >= worth_climbing * best.square && summit.reach > best.size();
  }
  void climb();
  void take(const Part& part) {
    for (std::size_t k = 0; k < searched_.rates; ++k) best_[k].bound = std::max(best_[k].bound, part.reach.sizes[k]);
  }
  void cut(std::size_t segment, double start, double end);
  void cut_towards_ends(std::size_t segment);
  void add(Part part);
  [[nodiscard]] double priority_of(const Part& part) const;

  const Searched& searched_;
  MomentBounds moments_;
  std::span<const double> knots_;
  std::array<Best, 3> best_{};
  std::vector<Summit> summits_{};
  std::vector<std::size_t> uneven_{};  ///< segments without bounds beside far shorter ones
  std::vector<Part> open_{};           ///< a heap, the worst first
  bool are_bounds_ = true;
};

void LargestRates::look_at(std::size_t segment) {
  SegmentMotions motions(searched_.curve, segment, MotionPart::rates);
  if (motions.is_gap()) return;
  const double start = knots_[segment], end = knots_[segment + 1];
  const SegmentForm form = searched_.curve.form(segment);
  const RateReach reach(form, searched_.curve.knots().span(segment), moments_);
  const RateSamples samples = searched_.between(motions, start, end);
  see(samples);
  const StepReach reached = reach.of_segment(samples);
  for (std::size_t i = 0; i < steps_of_part; ++i) note_summit(segment, samples[i], samples[i + 1], reached.sizes);
  if (!reach.is_bound()) {
    are_bounds_ = false;
    if (shortest_step_near(searched_.curve.knots(), segment) * double{steps_of_part} < end - start)
      uneven_.push_back(segment);
  }
  add({segment, start, end, reached, reach.rounding(), reach.is_bound() ? gap : resolution});
}

void LargestRates::note_summit(std::size_t segment, const RateSample& a, const RateSample& b, const RateSizes& reach) {
  for (std::size_t k = 0; k < searched_.rates; ++k) {
    if (!(a.heights[k].slope > 0.0 && b.heights[k].slope < 0.0)) continue;
    const Summit summit{segment, k, a.time, b.time, std::max(a.heights[k].square, b.heights[k].square), reach[k]};
    if (is_worth_climbing(summit)) summits_.push_back(summit);
  }
}

void LargestRates::climb() {
  for (const Summit& summit : summits_) {
    if (!is_worth_climbing(summit)) continue;
    double low = summit.start, high = summit.end;
    for (int i = 0; i < most_bisections; ++i) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (searched_.at(summit.segment, middle).heights[summit.rate].slope > 0.0 ? low : high) = middle;
    }
    see(searched_.at(summit.segment, low), summit.rate);
  }
  summits_.clear();
}

double LargestRates::priority_of(const Part& part) const {
  double excess = 0.0;
  for (std::size_t k = 0; k < searched_.rates; ++k) {
    const double enough = best_[k].size() * (1.0 + part.near_enough) + 2.0 * part.rounding[k];
    const double reach = part.reach.sizes[k];
    if (reach > 0.0) excess = std::max(excess, std::isinf(reach) ? reach : reach / enough);
  }
  if (excess > 1.0) return excess;
  const bool rests = part.reach.sizes[0] < rate_at_rest * best_[0].size();
  const bool turns = part.reach.turn > resolved_turn && best_[0].size() * (knots_.back() - knots_.front()) < most_turn;
  const double wanting =
      std::max(part.reach.unresolved > resolved && !rests ? part.reach.unresolved : 0.0, turns ? part.reach.turn : 0.0);
  return wanting / (1.0 + wanting);
}

void LargestRates::add(Part part) {
  part.priority = priority_of(part);
  const double shortest = std::max(least_share * (knots_[part.segment + 1] - knots_[part.segment]),
                                   least_steps * std::numeric_limits<double>::epsilon() * std::abs(part.end));
  if (part.priority > 0.0 && part.end - part.start > shortest) {
    open_.push_back(part);
    std::ranges::push_heap(open_, {}, &Part::priority);
  } else {
    take(part);
  }
}

void LargestRates::cut(std::size_t segment, double start, double end) {
  SegmentMotions motions(searched_.curve, segment, MotionPart::rates);
  const SegmentForm form = searched_.curve.form(segment);
  RateReach reach(form, searched_.curve.knots().span(segment), moments_);
  reach.refine();
  const RateSamples samples = searched_.between(motions, start, end);
  const auto steps = reach.of_steps(samples);
  see(samples);
  for (std::size_t i = 0; i < steps_of_part; ++i) note_summit(segment, samples[i], samples[i + 1], steps[i].sizes);
  climb();
  const bool are_finite = std::ranges::all_of(reach.rounding(), [](double size) { return std::isfinite(size); });
  for (std::size_t i = 0; i < steps_of_part; ++i) {
    const Part part{segment,  samples[i].time,  samples[i + 1].time,
                    steps[i], reach.rounding(), reach.is_bound() ? gap : resolution};
    are_finite ? add(part) : take(part);
  }
}

/// Where keys are far nearer to each other than in the middle: down to their steps.
void LargestRates::cut_towards_ends(std::size_t segment) {
  const double start = knots_[segment], end = knots_[segment + 1], step = end - start;
  const double shortest = std::max(shortest_step_near(searched_.curve.knots(), segment), least_share * step);
  for (double share = step; share > shortest;) {
    share /= double{steps_of_part};
    cut(segment, start, start + share);
    cut(segment, end - share, end);
  }
}

void LargestRates::refine() {
  climb();
  for (const std::size_t segment : uneven_) cut_towards_ends(segment);
  for (std::size_t left = most_parts + knots_.size(); !open_.empty();) {
    std::ranges::pop_heap(open_, {}, &Part::priority);
    const Part part = open_.back();
    open_.pop_back();
    if (left == 0 || priority_of(part) == 0.0) {
      take(part);
      continue;
    }
    --left;
    cut(part.segment, part.start, part.end);
  }
}

}  // namespace

Peaks peaks(const AnyCurve& curve, const Eigen::Matrix3d& inertia) {
  const Searched searched{curve, inertia};
  const auto knots = curve.knots().times();
  LargestRates search(searched);
  if (knots.size() < 2) {
    const Peak none{0.0, knots.front(), 0.0};
    return {none, none, none};
  }
  for (std::size_t segment = 0; segment + 1 < knots.size(); ++segment) search.look_at(segment);
  search.refine();
  const Peak acceleration = search.peak(1);
  return {search.peak(0), acceleration, searched.rates < 3 ? acceleration : search.peak(2)};
}

}}  // namespace orispline
