// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_samples.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <orispline/curve/stretched_curve.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/report/drawing_error.hpp>
#include <orispline/report/rate_extremes.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr double aimed_share = 0.9;  ///< of the angle, since it is measured at some places only
constexpr double share_of_extent = 1.0 / 2000.0;
constexpr double growth = 1.5;                      ///< of a tolerance that takes too many nodes
constexpr double noisy = 0.5 * radians_per_degree;  ///< a curve that its rates cannot show so exactly is noise

/// A curve as nodes, and what is drawn between them.
struct DrawnNodes {
  std::vector<CurveNode> nodes{};
  DrawnWay way = DrawnWay::cubic;

  /// The largest angle between curve and drawing [rad].
  [[nodiscard]] double error() const {
    double largest = 0.0;
    for (const CurveNode& node : nodes) largest = std::max(largest, node.error_after.value_or(0.0));
    return largest;
  }
};

/// A curve as nodes, which become samples in the end.
class NodesOfCurve {
 public:
  NodesOfCurve(const PoseCurve& curve, const Fineness& fineness)
      : fineness_(fineness),
        runs_(runs_of(curve.orientation, fineness.covers)),
        survey_(survey_of(curve, runs_)),
        is_long_(4 * curve.orientation.knots().segments() > fineness.least),
        source_{curve, TimeSteps::of(curve.orientation.domain().start, curve.orientation.domain().end),
                HalfFloats::up_to(survey_.scale.rates[0])} {}

  [[nodiscard]] DrawnNodes found() const {
    auto near = near_curve();
    if (!near) return noisy_ones();
    std::vector<CurveNode> nodes = with_peaks(std::move(*near));
    auto again = refined(nodes, source_, tolerance(), fineness_.most);
    return {again ? std::move(*again) : with_errors(std::move(nodes), source_)};
  }

 private:
  /// Where there is a motion: some curves know their gaps themselves.
  static std::vector<SegmentRun> runs_of(const AnyCurve& curve, const Covers& covers) {
    const Knots& knots = curve.knots();
    std::vector<SegmentRun> runs;
    for (std::size_t i = 0; i < knots.segments(); ++i) {
      if ((covers && !covers(middle_of(knots, i))) || is_gap(curve, i)) continue;
      if (runs.empty() || runs.back().end < i) runs.push_back({i, i});
      runs.back().end = i + 1;
    }
    return runs;
  }

  /// Where noise leaves no room for all that its rates say: at even knots, drawn in the way that is nearer to the
  /// curve.
  [[nodiscard]] DrawnNodes noisy_ones() const {
    const std::size_t most = most_of_shape();
    const std::vector<CurveNode> nodes = with_peaks(first_nodes(source_.knots().segments() / most + 1));
    NodeSource straight = source_;
    straight.way = DrawnWay::straight;
    DrawnNodes by_rates{with_errors(nodes, source_)}, by_arcs{with_errors(nodes, straight), DrawnWay::straight};
    return by_arcs.error() < by_rates.error() ? by_arcs : by_rates;
  }

  /// Nodes more where the lines of rates need them.
  [[nodiscard]] std::vector<CurveNode> with_peaks(std::vector<CurveNode> nodes) const {
    const std::size_t room = fineness_.most / 10;  // for the nodes that those of rates make necessary
    const std::size_t wanted = std::max(fineness_.least, nodes.size() + fineness_.least / 4);
    return with_extremes(std::move(nodes), source_, survey_, std::min(wanted, fineness_.most - room));
  }

  /// The room that is left for peaks.
  [[nodiscard]] std::size_t most_of_shape() const { return fineness_.most - fineness_.most / 4; }

  [[nodiscard]] DrawingTolerance tolerance() const {
    const double angle = aimed_share * fineness_.angle * radians_per_degree;
    const double distance = share_of_extent * survey_.scale.extent;
    return {angle, distance > 0.0 ? distance : std::numeric_limits<double>::infinity()};
  }

  [[nodiscard]] CurveNode gap_node(std::size_t first, std::size_t end) const {
    const auto knots = source_.knots().times();
    const double middle = std::midpoint(knots[first], knots[end]);
    CurveNode node = source_.node({middle, std::min(source_.knots().segment_at(middle), end - 1)});
    const Eigen::Vector3d none = Eigen::Vector3d::Constant(std::nan(""));
    node.motion = {{none.x(), none.x(), none.x(), none.x()}, none, none, none};
    node.is_in_gap = true;
    return node;
  }

  /// Of many segments at every so manyth knot only.
  void append_run(std::vector<CurveNode>& nodes, const SegmentRun& run, std::size_t every) const {
    const Knots& knots = source_.knots();
    nodes.push_back(source_.node({knots.times()[run.first], run.first}));
    for (std::size_t i = run.first + every; i < run.end && is_long_; i += every)
      nodes.push_back(source_.node({knots.times()[i], i}));
    for (std::size_t i = run.first; i < run.end && !is_long_; ++i) {
      const double from = knots.times()[i], to = knots.times()[i + 1];
      if (i > run.first) std::ranges::move(sides_of_knot(i, source_, survey_.scale), std::back_inserter(nodes));
      const double share = (to - from) / (knots.back() - knots.front());
      const auto steps =
          static_cast<std::size_t>(std::max(3.0, std::ceil(share * static_cast<double>(fineness_.least))));
      for (std::size_t k = 1; k < steps; ++k) {
        const double time =
            source_.steps.rounded(std::lerp(from, to, static_cast<double>(k) / static_cast<double>(steps)));
        if (nodes.back().place.time < time && time < to) nodes.push_back(source_.node({time, i}));
      }
    }
    nodes.push_back(source_.node({knots.times()[run.end], run.end - 1}));
  }

  [[nodiscard]] std::vector<CurveNode> first_nodes(std::size_t every) const {
    std::vector<CurveNode> nodes;
    std::size_t end = 0;
    for (const SegmentRun& run : runs_) {
      if (end < run.first) nodes.push_back(gap_node(end, run.first));
      append_run(nodes, run, every);
      end = run.end;
    }
    if (end < source_.knots().segments()) nodes.push_back(gap_node(end, source_.knots().segments()));
    return nodes;
  }

  /// Within the tolerance. Of many segments nodes are chosen among those of a finer drawing: so each reaches far.
  [[nodiscard]] std::optional<std::vector<CurveNode>> near_curve(const std::vector<CurveNode>& nodes,
                                                                 const DrawingTolerance& wanted) const {
    const std::size_t most = most_of_shape();
    if (!is_long_) return refined(nodes, source_, wanted, most);
    auto found = refined(nodes, source_, {wanted.angle / 16.0, wanted.distance / 4.0}, 4 * most);
    if (!found) found = refined(nodes, source_, wanted, 4 * most);
    if (found) found = thinned(*found, source_, wanted);
    return found && found->size() <= most ? std::move(found) : std::nullopt;
  }

  /// Within the tolerance, or within the least multiple of it for which there is room.
  [[nodiscard]] std::optional<std::vector<CurveNode>> near_curve() const {
    const std::vector<CurveNode> nodes = first_nodes(source_.knots().segments());
    for (DrawingTolerance now = tolerance(); now.angle < noisy; now.angle *= growth, now.distance *= growth)
      if (auto found = near_curve(nodes, now)) return found;
    return std::nullopt;
  }

  const Fineness& fineness_;
  std::vector<SegmentRun> runs_;
  RateSurvey survey_;
  bool is_long_;  ///< too many segments to show the rates of each
  NodeSource source_;
};

PageSamples samples_of(const DrawnNodes& drawn, bool has_positions) {
  PageSamples samples{.is_straight = drawn.way == DrawnWay::straight, .exactness = drawn.error() / radians_per_degree};
  for (const CurveNode& node : drawn.nodes) {
    samples.path.times.push_back(node.place.time);
    samples.path.orientations.push_back(node.motion.orientation);
    samples.angular_velocities.push_back(node.motion.angular_velocity);
    samples.angular_accelerations.push_back(node.motion.angular_acceleration);
    samples.angular_jerks.push_back(node.motion.angular_jerk);
    if (has_positions) samples.positions.push_back(node.position);
  }
  return samples;
}

}  // namespace

PageSamples drawn_samples(const PoseCurve& curve, const Fineness& fineness) {
  const bool has_positions = curve.position.has_value();
  if (curve.orientation.knots().segments() == 0) {
    const double start = curve.orientation.domain().start;
    return samples_of({{NodeSource{curve, {start, 0.0}, {}}.node({start, 0})}}, has_positions);
  }
  return samples_of(NodesOfCurve(curve, fineness).found(), has_positions);
}

}}}  // namespace orispline::report
