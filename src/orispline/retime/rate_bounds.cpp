// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/rate_bounds.hpp>

#include <algorithm>
#include <limits>
#include <span>

#include <orispline/analysis/segment_hull.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/retime/path_hull.hpp>

// What a motion is at a time, and what it is nowhere above around that time: for orientations and for positions.

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// A part of a segment in its two units.
struct Stretch {
  double middle, radius;  ///< [s]
  double start, end;      ///< of u in [0, 1]
};

/// Turning on one segment: quantities at a time, and bounds of them around it.
class Turning {
 public:
  Turning(const AnyCurve& curve, std::size_t segment, const SegmentHull& hull, const MotionQuantities& quantities);

  void go_to(double t) { m_ = curve_.motion_on(segment_, t); }
  /// Of quantity k; 0 for one of positions.
  [[nodiscard]] double size(std::size_t k) const;
  /// Of all times in the part, in whose middle the motion is.
  [[nodiscard]] QuantitySizes bounds(const Stretch& part) const;
  /// What there is of rounding in these bounds: no shorter part has less.
  [[nodiscard]] QuantitySizes rounding() const;
  /// Adds what the rounding of the keys makes of the shortest step near the segment [s].
  void round(SegmentPeaks& peaks, double shortest) const;

 private:
  [[nodiscard]] double jerk_bound(const LimitedQuantity& quantity, const Stretch& part, const HullBounds& hull) const;
  [[nodiscard]] double torque_bound(const LimitedQuantity& quantity, double r, const HullBounds& hull) const;

  const AnyCurve& curve_;
  std::size_t segment_;
  const SegmentHull& hull_;
  HullBounds whole_, rounding_;
  std::span<const LimitedQuantity> quantities_;
  Eigen::Matrix3d inertia_;
  MomentBounds moments_;
  Motion m_{};
};

/// Moving on one segment: the same of the position.
class Moving {
 public:
  Moving(const AnyPath& path, std::size_t segment, const PathHull& hull, const MotionQuantities& quantities)
      : path_(path), segment_(segment), hull_(hull), quantities_(quantities.all) {}

  void go_to(double t) { m_ = path_.linear_motion_on(segment_, t); }
  [[nodiscard]] double size(std::size_t k) const;
  [[nodiscard]] QuantitySizes bounds(const Stretch& part) const;
  [[nodiscard]] QuantitySizes rounding() const;
  /// The bounds hold what there is of it.
  void round(SegmentPeaks&, double) const {}

 private:
  const AnyPath& path_;
  std::size_t segment_;
  const PathHull& hull_;
  std::span<const LimitedQuantity> quantities_;
  LinearMotion m_{};
};

using Limited = LimitedQuantity::Vector;

/// Of an increment so much is rounding [rad]: that of two keys, also when they are written, read and normalised again.
constexpr double rounding_of_keys = 16.0 * std::numeric_limits<double>::epsilon();

/// The larger size at the ends of the line a ± b r.
double largest(const LimitedQuantity& quantity, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double r) {
  return std::max(quantity.size_of(a + b * r), quantity.size_of(a - b * r));
}

Turning::Turning(const AnyCurve& curve, std::size_t segment, const SegmentHull& hull,
                 const MotionQuantities& quantities)
    : curve_(curve),
      segment_(segment),
      hull_(hull),
      whole_(hull.on(0.0, 1.0)),
      rounding_(hull.rounding(whole_)),
      quantities_(quantities.all),
      inertia_(quantities.inertia.value_or(Eigen::Matrix3d::Zero())),
      moments_(inertia_) {}

double Turning::size(std::size_t k) const {
  const LimitedQuantity& quantity = quantities_[k];
  switch (quantity.vector) {
    case Limited::rate:
      return quantity.size_of(m_.angular_velocity);
    case Limited::acceleration:
      return quantity.size_of(m_.angular_acceleration);
    case Limited::jerk:
      return quantity.size_of(m_.angular_jerk);
    case Limited::torque:
      return quantity.size_of(torque(m_, inertia_));
    default:
      return 0.0;
  }
}

QuantitySizes Turning::bounds(const Stretch& part) const {
  const HullBounds hull = hull_.on(part.start, part.end);
  const double r = part.radius, jerk = m_.angular_jerk.norm();
  const double bend_of_rate = (0.5 * jerk + hull.snap * r / 6.0) * r * r,
               bend_of_acceleration = 0.5 * hull.snap * r * r;
  QuantitySizes sizes{};
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    const LimitedQuantity& quantity = quantities_[k];
    if (quantity.vector == Limited::rate)
      sizes[k] =
          std::min(hull.rate, largest(quantity, m_.angular_velocity, m_.angular_acceleration, r) + bend_of_rate) +
          rounding_.rate;
    if (quantity.vector == Limited::acceleration)
      sizes[k] = std::min(hull.acceleration,
                          largest(quantity, m_.angular_acceleration, m_.angular_jerk, r) + bend_of_acceleration) +
                 rounding_.acceleration;
    if (quantity.vector == Limited::jerk)
      sizes[k] = std::min(hull.jerk, jerk_bound(quantity, part, hull)) + rounding_.jerk;
    if (quantity.vector == Limited::torque) sizes[k] = torque_bound(quantity, r, hull);
  }
  return sizes;
}

QuantitySizes Turning::rounding() const {
  QuantitySizes sizes{};
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    const Limited vector = quantities_[k].vector;
    if (vector == Limited::rate) sizes[k] = rounding_.rate;
    if (vector == Limited::acceleration) sizes[k] = rounding_.acceleration;
    if (vector == Limited::jerk) sizes[k] = rounding_.jerk;
    if (vector == Limited::torque) sizes[k] = moments_.rounding(whole_.rate, rounding_.rate, rounding_.acceleration);
  }
  return sizes;
}

void Turning::round(SegmentPeaks& peaks, double shortest) const {
  const double rate = rounding_of_keys / shortest, acceleration = rate / shortest;
  double fastest = 0.0;
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    const Limited vector = quantities_[k].vector;
    if (vector == Limited::rate) peaks[k].bound += rate;
    if (vector == Limited::acceleration) peaks[k].bound += acceleration;
    if (vector == Limited::jerk) peaks[k].bound += acceleration / shortest;
    if (vector == Limited::rate) fastest = std::max(fastest, peaks[k].bound);
  }
  for (std::size_t k = 0; k < quantities_.size(); ++k)
    if (quantities_[k].vector == Limited::torque)
      peaks[k].bound += moments_.rounding(std::max(fastest, whole_.rate), rate, acceleration);
}

double Turning::jerk_bound(const LimitedQuantity& quantity, const Stretch& part, const HullBounds& hull) const {
  const double r = part.radius;
  const auto at = [&](double t) { return quantity.size_of(curve_.motion_on(segment_, t).angular_jerk); };
  const double chord = std::max(at(part.middle - r), at(part.middle + r)) + 0.5 * hull.crackle * r * r;
  return std::min(quantity.size_of(m_.angular_jerk) + hull.snap * r, chord);
}

double Turning::torque_bound(const LimitedQuantity& quantity, double r, const HullBounds& hull) const {
  const double jerk = m_.angular_jerk.norm();
  const auto longest = [r](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::max((a + b * r).norm(), (a - b * r).norm());
  };
  const double rate = std::min(hull.rate, longest(m_.angular_velocity, m_.angular_acceleration) +
                                              (0.5 * jerk + hull.snap * r / 6.0) * r * r) +
                      rounding_.rate;
  const double acceleration =
      std::min(hull.acceleration, longest(m_.angular_acceleration, m_.angular_jerk) + 0.5 * hull.snap * r * r) +
      rounding_.acceleration;
  const HullBounds bounds{rate, acceleration, jerk + hull.snap * r, hull.snap, 0.0};
  const double along = largest(quantity, torque(m_, inertia_), torque_rate(m_, inertia_), r) +
                       0.5 * moments_.bend(bounds) * r * r +
                       moments_.rounding(rate, rounding_.rate, rounding_.acceleration);
  return std::min(along, moments_.torque(bounds));
}

double Moving::size(std::size_t k) const {
  const LimitedQuantity& quantity = quantities_[k];
  if (quantity.vector == Limited::speed) return quantity.size_of(m_.velocity);
  return quantity.vector == Limited::linear_acceleration ? quantity.size_of(m_.acceleration) : 0.0;
}

QuantitySizes Moving::bounds(const Stretch& part) const {
  QuantitySizes sizes{};
  for (std::size_t k = 0; k < quantities_.size(); ++k)
    if (quantities_[k].is_of_position()) sizes[k] = hull_.bound(quantities_[k], part.start, part.end);
  return sizes;
}

QuantitySizes Moving::rounding() const {
  QuantitySizes sizes{};
  for (std::size_t k = 0; k < quantities_.size(); ++k)
    if (quantities_[k].is_of_position()) sizes[k] = hull_.rounding(quantities_[k]);
  return sizes;
}

constexpr double gap = 1e-4;           // of a bound above the largest value found, relative
constexpr std::size_t first_cuts = 4;  // of a segment
/// Parts that the segments of a curve are cut into, all together, and those of each that it has in any case.
constexpr std::size_t most_parts = std::size_t{1} << 16, fewest_parts = std::size_t{1} << 10;

/// A part of a segment, and what the motion is nowhere above on it.
struct Part {
  double middle, radius;  ///< [s]
  QuantitySizes bounds;
  double excess;  ///< by which factor a bound is above what is near enough, when it was found
};

/// One segment, cut where its bounds are the farthest from what was found.
template <class Source>
class PeakSearch {
 public:
  PeakSearch(Source source, const Knots& knots, std::size_t segment, std::size_t quantities,
             const QuantitySizes& floors)
      : source_(std::move(source)),
        knots_(knots),
        segment_(segment),
        span_(knots.span(segment)),
        floors_(floors),
        rounding_(source_.rounding()),
        peaks_(quantities) {}

  /// `parts`: at most.
  SegmentPeaks run(std::size_t parts) {
    QuantitySizes any;
    any.fill(std::numeric_limits<double>::infinity());
    const double step = span_.step() / static_cast<double>(first_cuts);
    for (std::size_t i = 0; i < first_cuts; ++i) note(span_.start() + static_cast<double>(i) * step);
    note(span_.end());
    for (std::size_t i = 0; i < first_cuts; ++i)
      add(span_.start() + (static_cast<double>(i) + 0.5) * step, 0.5 * step, any);
    for (std::size_t made = first_cuts; !open_.empty() && made < parts; made += 2) halve_worst();
    for (const Part& part : open_) take(part.bounds);
    source_.round(peaks_, shortest_step_near(knots_, segment_));
    return std::move(peaks_);
  }

 private:
  void note(double t) {
    source_.go_to(t);
    for (std::size_t k = 0; k < peaks_.size(); ++k) {
      const double size = source_.size(k);
      CertifiedPeak& peak = peaks_[k];
      if (size > peak.found) peak.found = size, peak.time = t;
      peak.bound = std::max(peak.bound, size);
    }
  }

  /// `within`: bounds of a part that holds this one.
  void add(double middle, double radius, const QuantitySizes& within) {
    const double of_time = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(middle);
    const double r = radius + of_time;
    note(middle);
    const auto place = [&](double t) { return std::clamp(span_.normalised(t), 0.0, 1.0); };
    QuantitySizes found = source_.bounds({middle, r, place(middle - r), place(middle + r)});
    for (std::size_t k = 0; k < peaks_.size(); ++k) found[k] = std::min(found[k], within[k]);
    const double excess = excess_of(found);
    if (excess > 1.0 && radius > of_time) {
      open_.push_back({middle, radius, found, excess});
      std::ranges::push_heap(open_, {}, &Part::excess);
    } else {
      take(found);
    }
  }

  void halve_worst() {
    std::ranges::pop_heap(open_, {}, &Part::excess);
    const Part part = open_.back();
    open_.pop_back();
    if (!(excess_of(part.bounds) > 1.0)) return take(part.bounds);
    add(part.middle - 0.5 * part.radius, 0.5 * part.radius, part.bounds);
    add(part.middle + 0.5 * part.radius, 0.5 * part.radius, part.bounds);
  }

  void take(const QuantitySizes& bounds) {
    for (std::size_t k = 0; k < peaks_.size(); ++k) peaks_[k].bound = std::max(peaks_[k].bound, bounds[k]);
  }

  /// Twice the rounding is near enough too: cutting takes away none of it.
  [[nodiscard]] double excess_of(const QuantitySizes& bounds) const {
    double excess = 0.0;
    for (std::size_t k = 0; k < peaks_.size(); ++k) {
      const double near_enough = std::max(peaks_[k].found * (1.0 + gap), floors_[k]) + 2.0 * rounding_[k];
      if (bounds[k] > 0.0) excess = std::max(excess, bounds[k] / near_enough);
    }
    return excess;
  }

  Source source_;
  const Knots& knots_;
  std::size_t segment_;
  KnotSpan span_;
  QuantitySizes floors_, rounding_;
  SegmentPeaks peaks_;
  std::vector<Part> open_{};  ///< a heap, the worst first
};

/// The peaks of one segment, of turning and of the position; `parts`: at most, of each.
class SegmentSearch {
 public:
  SegmentSearch(const PoseCurve& curve, const MotionQuantities& quantities, const QuantitySizes& floors,
                std::size_t parts)
      : curve_(curve), quantities_(quantities), floors_(floors), parts_(parts) {}

  [[nodiscard]] SegmentPeaks peaks(std::size_t segment) const {
    const std::size_t count = quantities_.all.size();
    SegmentPeaks peaks(count);
    const AnyCurve& turning = curve_.orientation;
    const bool turns = std::ranges::any_of(quantities_.all, [](const auto& q) { return !q.is_of_position(); });
    const bool moves = std::ranges::any_of(quantities_.all, &LimitedQuantity::is_of_position);
    if (const auto hull = SegmentHull::of(turning.form(segment), turning.knots().span(segment).step()); hull && turns)
      peaks = PeakSearch(Turning(turning, segment, *hull, quantities_), turning.knots(), segment, count, floors_)
                  .run(parts_);
    if (!moves || !curve_.position) return peaks;
    const AnyPath& path = *curve_.position;
    if (const auto hull = PathHull::of(path, segment)) {
      const auto moving =
          PeakSearch(Moving(path, segment, *hull, quantities_), path.knots(), segment, count, floors_).run(parts_);
      for (std::size_t k = 0; k < count; ++k)
        if (quantities_.all[k].is_of_position()) peaks[k] = moving[k];
    }
    return peaks;
  }

 private:
  const PoseCurve& curve_;
  const MotionQuantities& quantities_;
  const QuantitySizes& floors_;
  std::size_t parts_;
};

/// Whether the segments of the curve, as far as they are asked for, are stated as polynomials.
bool is_of_polynomials(const PoseCurve& curve, std::span<const LimitedQuantity> quantities) {
  const bool moves = std::ranges::any_of(quantities, &LimitedQuantity::is_of_position);
  const Knots& knots = curve.orientation.knots();
  if (knots.segments() > 0 && !SegmentHull::of(curve.orientation.form(0), knots.span(0).step())) return false;
  return !moves || (curve.position && curve.position->degree() > 0 &&
                    curve.position->knots().segments() == curve.orientation.knots().segments());
}

}  // namespace

std::optional<std::vector<SegmentPeaks>> certified_peaks(const PoseCurve& curve, const MotionQuantities& quantities,
                                                         const QuantitySizes& floors) {
  constexpr std::size_t together = 64;  // segments
  if (!is_of_polynomials(curve, quantities.all)) return std::nullopt;
  const std::size_t segments = curve.orientation.knots().segments();
  const SegmentSearch search(curve, quantities, floors,
                             std::max(fewest_parts, most_parts / std::max<std::size_t>(segments, 1)));
  std::vector<SegmentPeaks> peaks(segments);
  parallel_for((segments + together - 1) / together, 0, [&](std::size_t part) {
    for (std::size_t s = part * together; s < std::min(segments, (part + 1) * together); ++s)
      peaks[s] = search.peaks(s);
  });
  return peaks;
}

}}  // namespace orispline
