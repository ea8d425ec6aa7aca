// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/rate_bounds.hpp>

#include <algorithm>
#include <limits>

#include <orispline/base/parallel.hpp>
#include <orispline/retime/bounded_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double gap = 1e-4;           // of a bound above the largest value found, relative
constexpr std::size_t keys_near = 3;   // so many segments away a short step still shapes the curve
constexpr std::size_t first_cuts = 4;  // of a segment
/// Parts that the segments of a curve are cut into, all together, and those of each that it has in any case.
constexpr std::size_t most_parts = std::size_t{1} << 20, fewest_parts = std::size_t{1} << 10;

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
    source_.round(peaks_, shortest_step_near());
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

  [[nodiscard]] double excess_of(const QuantitySizes& bounds) const {
    double excess = 0.0;
    for (std::size_t k = 0; k < peaks_.size(); ++k)
      if (bounds[k] > 0.0) excess = std::max(excess, bounds[k] / std::max(peaks_[k].found * (1.0 + gap), floors_[k]));
    return excess;
  }

  [[nodiscard]] double shortest_step_near() const {
    const auto t = knots_.times();
    double shortest = span_.step();
    for (std::size_t i = segment_ - std::min(segment_, keys_near); i <= segment_ + keys_near && i + 1 < t.size(); ++i)
      shortest = std::min(shortest, t[i + 1] - t[i]);
    return shortest;
  }

  Source source_;
  const Knots& knots_;
  std::size_t segment_;
  KnotSpan span_;
  QuantitySizes floors_;
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

std::optional<double> snap_bound(const SegmentForm& form, double duration) {
  const auto hull = SegmentHull::of(form, duration);
  return hull ? std::optional(hull->on(0.0, 1.0).snap) : std::nullopt;
}

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
