// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/rate_extremes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr std::size_t columns = 4096;           ///< of time, of which each keeps its extremes
constexpr std::size_t most_places = 2'000'000;  ///< places of a curve
constexpr double visible_share = 1.0 / 250.0, visible_jump = 1.0 / 1000.0;  ///< of the largest rate
constexpr double visible_turn = 1e-5;                                       ///< [rad], of an orientation that jumps

/// The places in one column of time where the three rates are least and largest.
class ExtremesOfColumn {
 public:
  void see(const PlacedRates& here, const std::array<double, 3>& sizes) {
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (!seen_ || sizes[i] < least_[i].first) least_[i] = {sizes[i], here};
      if (!seen_ || sizes[i] > largest_[i].first) largest_[i] = {sizes[i], here};
    }
    seen_ = true;
  }

  void flush(std::vector<PlacedRates>& extremes) {
    if (!std::exchange(seen_, false)) return;
    std::vector<PlacedRates> found;
    for (const auto& sizes : {least_, largest_})
      for (const auto& [size, place] : sizes)
        if (std::isfinite(size)) found.push_back(place);
    std::ranges::sort(found, {}, &PlacedRates::place);
    for (const PlacedRates& one : found)
      if (extremes.empty() || extremes.back().place != one.place) extremes.push_back(one);
  }

 private:
  std::array<std::pair<double, PlacedRates>, 3> least_{}, largest_{};
  bool seen_ = false;
};

std::array<double, 3> sizes_of(const Motion& motion) {
  return {motion.angular_velocity.norm(), motion.angular_acceleration.norm(), motion.angular_jerk.norm()};
}

/// Sees every place of a curve once, in order.
class Survey {
 public:
  explicit Survey(const PoseCurve& curve) : curve_(curve) {
    const Knots& knots = curve.orientation.knots();
    places_ = std::clamp<std::size_t>(most_places / knots.segments(), 2, 8);
    columns_per_second_ = static_cast<double>(columns) / (knots.back() - knots.front());
  }

  void see_segment(std::size_t segment) {
    const auto knots = curve_.orientation.knots().times();
    for (std::size_t k = 0; k <= places_; ++k)
      see({std::lerp(knots[segment], knots[segment + 1], static_cast<double>(k) / static_cast<double>(places_)),
           segment});
  }

  [[nodiscard]] RateSurvey finished() {
    column_.flush(survey_.extremes);
    if (curve_.position && !box_.isEmpty()) survey_.scale.extent = box_.sizes().maxCoeff();
    return std::move(survey_);
  }

 private:
  void see(const CurvePlace& place) {
    const Motion motion = curve_.orientation.motion_on(place.segment, place.time);
    const auto sizes = sizes_of(motion);
    const auto column =
        static_cast<std::size_t>((place.time - curve_.orientation.domain().start) * columns_per_second_);
    if (column != current_) column_.flush(survey_.extremes);
    current_ = column;
    column_.see({place, motion}, sizes);
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (std::isfinite(sizes[i])) survey_.scale.rates[i] = std::max(survey_.scale.rates[i], sizes[i]);
    if (curve_.position) box_.extend(curve_.position->linear_motion(place.time).position);
  }

  const PoseCurve& curve_;
  RateSurvey survey_{};
  ExtremesOfColumn column_{};
  Eigen::AlignedBox3d box_{};
  std::size_t places_, current_ = 0;
  double columns_per_second_;
};

/// Places between two that are kept, with the one that is farthest from the straight lines between these.
struct Stretch {
  double deviation = 0.0;  ///< as a share of the largest rate
  std::size_t from = 0, farthest = 0, to = 0;

  [[nodiscard]] friend bool operator<(const Stretch& a, const Stretch& b) {
    return std::pair(a.deviation, b.from) < std::pair(b.deviation, a.from);
  }
};

Stretch stretch_of(const std::vector<PlacedRates>& places, std::size_t from, std::size_t to, const MotionScale& scale) {
  const PlacedRates &first = places[from], &last = places[to];
  const double step = last.place.time - first.place.time;
  Stretch stretch{.from = from, .farthest = from, .to = to};
  for (std::size_t i = from + 1; i < to; ++i) {
    const auto share = static_cast<float>(step > 0.0 ? (places[i].place.time - first.place.time) / step : 0.5);
    double deviation = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      if (scale.rates[k] > 0.0) {
        const Eigen::Vector3f line = first.rates[k] + share * (last.rates[k] - first.rates[k]);
        deviation = std::max(deviation, static_cast<double>((places[i].rates[k] - line).norm()) / scale.rates[k]);
      }
    if (deviation > stretch.deviation) stretch.deviation = deviation, stretch.farthest = i;
  }
  return stretch;
}

/// The nodes at a place: at a knot those that tell both its sides.
std::vector<CurveNode> nodes_at(const CurvePlace& place, const NodeSource& source, const MotionScale& scale) {
  const auto knots = source.knots().times();
  const std::size_t segment = place.time == knots[place.segment + 1] ? place.segment + 1 : place.segment;
  if (place.time == knots[segment] && 0 < segment && segment < source.knots().segments())
    return sides_of_knot(segment, source, scale);
  return {source.node(place)};
}

/// All of them in order, each place once.
std::vector<CurveNode> merged(std::vector<CurveNode> nodes, std::vector<CurveNode> added) {
  std::vector<CurveNode> all;
  std::ranges::sort(added, {}, &CurveNode::place);
  std::ranges::merge(nodes, added, std::back_inserter(all), {}, &CurveNode::place, &CurveNode::place);
  all.erase(
      std::unique(all.begin(), all.end(), [](const CurveNode& a, const CurveNode& b) { return a.place == b.place; }),
      all.end());
  for (std::size_t i = 1; i < all.size(); ++i)  // what is drawn up to a new node is new
    if (!all[i].error_after) all[i - 1].error_after.reset();
  return all;
}

}  // namespace

RateSurvey survey_of(const PoseCurve& curve, const std::vector<SegmentRun>& runs) {
  Survey survey(curve);
  for (const auto& [first, end] : runs)
    for (std::size_t segment = first; segment < end; ++segment) survey.see_segment(segment);
  return survey.finished();
}

std::vector<CurveNode> sides_of_knot(std::size_t segment, const NodeSource& source, const MotionScale& scale) {
  const double time = source.knots().times()[segment];
  std::vector<CurveNode> sides{source.node({time, segment - 1}), source.node({time, segment})};
  const Motion &left = sides[0].motion, &right = sides[1].motion;
  const std::array jumps{(right.angular_velocity - left.angular_velocity).norm(),
                         (right.angular_acceleration - left.angular_acceleration).norm(),
                         (right.angular_jerk - left.angular_jerk).norm()};
  for (std::size_t i = 0; i < jumps.size(); ++i)
    if (jumps[i] > visible_jump * scale.rates[i]) return sides;
  if (angular_distance(left.orientation, right.orientation) > visible_turn) return sides;
  sides.erase(sides.begin());
  return sides;
}

std::vector<CurveNode> with_extremes(std::vector<CurveNode> nodes, const NodeSource& source, const RateSurvey& survey,
                                     std::size_t most) {
  std::vector<PlacedRates> kept, places;
  for (const CurveNode& node : nodes) kept.emplace_back(node.place, node.motion);
  std::ranges::set_union(kept, survey.extremes, std::back_inserter(places), {}, &PlacedRates::place,
                         &PlacedRates::place);
  std::priority_queue<Stretch> stretches;
  for (std::size_t i = 0, from = 0, next = 0; i < places.size() && next < kept.size(); ++i) {
    if (places[i].place != kept[next].place) continue;
    if (next > 0) stretches.push(stretch_of(places, from, i, survey.scale));
    from = i;
    ++next;
  }
  std::vector<CurveNode> added;
  while (!stretches.empty() && stretches.top().deviation > visible_share && nodes.size() + added.size() < most) {
    const Stretch widest = stretches.top();
    stretches.pop();
    std::ranges::move(nodes_at(places[widest.farthest].place, source, survey.scale), std::back_inserter(added));
    stretches.push(stretch_of(places, widest.from, widest.farthest, survey.scale));
    stretches.push(stretch_of(places, widest.farthest, widest.to, survey.scale));
  }
  return merged(std::move(nodes), std::move(added));
}

}}}  // namespace orispline::report
