// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/drawing_error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr std::size_t places_of_span = 8, places_of_segment = 4;  ///< parts at whose ends the drawing is compared
constexpr double hidden_share = 0.1;  ///< of the tolerance, by which a jump of ω may mislead what is drawn

/// What is drawn between two nodes, beside the curve there.
class Comparison {
 public:
  Comparison(const CurveNode& from, const CurveNode& to, const NodeSource& source, const DrawingTolerance& tolerance)
      : from_(from), to_(to), source_(source), tolerance_(tolerance), span_(from.drawn, to.drawn, source.way) {
    const Knots& knots = source.knots();
    first_ = knots.segment_at(from.place.time);
    last_ = knots.segment_at(to.place.time, Side::left);
  }

  /// The largest angle at places between [rad]; where the tolerance is passed, nothing.
  [[nodiscard]] std::optional<double> largest() {
    for (std::size_t stride = places_of_span / 2; stride > 0; stride /= 2)  // the middle first: most fail there
      for (std::size_t k = stride; k < places_of_span; k += 2 * stride)
        if (!is_within(from_.place.time, to_.place.time, k, places_of_span)) return std::nullopt;
    if (first_ == last_) return largest_;
    const auto knots = source_.knots().times();
    for (std::size_t s = first_; s <= last_; ++s) {
      const double start = std::max(from_.place.time, knots[s]), end = std::min(to_.place.time, knots[s + 1]);
      for (std::size_t k = 1; k <= places_of_segment; ++k)
        if ((s < last_ || k < places_of_segment) && !is_within(start, end, k, places_of_segment)) return std::nullopt;
    }
    return largest_;
  }

  /// The place between at which a node is of most use: the knot next to the middle, else the middle; nothing where
  /// there is no time between.
  [[nodiscard]] std::optional<CurvePlace> middle() const {
    const double time = std::midpoint(from_.place.time, to_.place.time);
    const Knots& knots = source_.knots();
    if (first_ < last_) {
      std::size_t knot = std::clamp(knots.segment_at(time), first_ + 1, last_);
      if (knot < last_ && knots.times()[knot + 1] - time < time - knots.times()[knot]) ++knot;
      return CurvePlace{knots.times()[knot], knot};
    }
    const double written = source_.steps.rounded(time);
    if (!(from_.drawn.time < written && written < to_.drawn.time)) return std::nullopt;
    return CurvePlace{written, first_};
  }

 private:
  [[nodiscard]] bool is_within(double start, double end, std::size_t k, std::size_t parts) {
    const double time = std::lerp(start, end, static_cast<double>(k) / static_cast<double>(parts));
    if (!(from_.drawn.time < time && time < to_.drawn.time)) return true;
    const std::size_t segment = source_.knots().segment_at(time);
    const double angle = angular_distance(source_.curve.orientation.orientation_on(segment, time), span_(time));
    largest_ = std::max(largest_, angle);
    return !(angle > tolerance_.angle) && is_on_path(time);
  }

  [[nodiscard]] bool is_on_path(double time) const {
    if (!source_.curve.position || tolerance_.distance == endless) return true;
    const double share = (time - from_.drawn.time) / (to_.drawn.time - from_.drawn.time);
    const Eigen::Vector3d drawn = from_.position + share * (to_.position - from_.position);
    return !((source_.curve.position->linear_motion(time).position - drawn).norm() > tolerance_.distance);
  }

  const CurveNode &from_, &to_;
  const NodeSource& source_;
  const DrawingTolerance& tolerance_;
  DrawnSpan span_;
  std::size_t first_, last_;
  double largest_ = 0.0;
};

/// Whether the drawing shows that the orientation, or its rate, is another one behind the knot.
bool shows_jump(const CurveNode& before, const CurveNode& after, const NodeSource& source, double tolerance) {
  constexpr double largest_of_basis = 4.0 / 27.0;  // of u²(1 - u): what a rate at an end adds
  const auto knots = source.knots().times();
  const std::size_t knot = after.place.segment;
  const double step = std::min(knots[knot] - knots[knot - 1], knots[knot + 1] - knots[knot]);
  const double turn = largest_of_basis * step * (after.motion.angular_velocity - before.motion.angular_velocity).norm();
  return std::max(turn, angular_distance(before.motion.orientation, after.motion.orientation)) >
         hidden_share * tolerance;
}

/// The nodes at a place: two where that is a knot at which the drawing jumps.
void append(std::vector<CurveNode>& nodes, const CurvePlace& place, const NodeSource& source, double tolerance) {
  CurveNode node = source.node(place);
  if (place.segment > 0 && place.time == source.knots().times()[place.segment]) {
    CurveNode before = source.node({place.time, place.segment - 1});
    if (shows_jump(before, node, source, tolerance)) nodes.push_back(std::move(before));
  }
  nodes.push_back(std::move(node));
}

bool is_drawn_between(const CurveNode& from, const CurveNode& to) {
  return !from.is_in_gap && !to.is_in_gap && from.drawn.time < to.drawn.time;
}

}  // namespace

std::vector<CurveNode> with_errors(std::vector<CurveNode> nodes, const NodeSource& source) {
  const DrawingTolerance any{endless, endless};
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!nodes[i].error_after)
      nodes[i].error_after = i + 1 < nodes.size() && is_drawn_between(nodes[i], nodes[i + 1])
                                 ? Comparison(nodes[i], nodes[i + 1], source, any).largest()
                                 : 0.0;
  return nodes;
}

std::optional<std::vector<CurveNode>> refined(std::vector<CurveNode> nodes, const NodeSource& source,
                                              const DrawingTolerance& tolerance, std::size_t most) {
  for (bool has_grown = true; has_grown;) {
    if (nodes.size() > most) return std::nullopt;
    has_grown = false;
    std::vector<CurveNode> next;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      next.push_back(nodes[i]);
      if (nodes[i].error_after || i + 1 == nodes.size() || !is_drawn_between(nodes[i], nodes[i + 1])) continue;
      Comparison comparison(nodes[i], nodes[i + 1], source, tolerance);
      next.back().error_after = comparison.largest();
      if (next.back().error_after) continue;
      if (const auto place = comparison.middle()) {
        append(next, *place, source, tolerance.angle);
        has_grown = true;
      }
    }
    nodes = std::move(next);
  }
  return with_errors(std::move(nodes), source);
}

std::vector<CurveNode> thinned(const std::vector<CurveNode>& nodes, const NodeSource& source,
                               const DrawingTolerance& tolerance) {
  std::vector<CurveNode> few;
  for (std::size_t i = 0; i < nodes.size();) {
    few.push_back(nodes[i]);
    std::size_t next = i + 1;
    for (; next + 1 < nodes.size() && !nodes[next].is_in_gap && is_drawn_between(nodes[i], nodes[next + 1]); ++next) {
      const auto error = Comparison(nodes[i], nodes[next + 1], source, tolerance).largest();
      if (!error) break;
      few.back().error_after = error;
    }
    i = next;
  }
  return few;
}

}}}  // namespace orispline::report
