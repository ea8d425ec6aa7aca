// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/report/curve_nodes.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// How far a drawing may be from its curve.
struct DrawingTolerance {
  double angle = 0.0;     ///< [rad]
  double distance = 0.0;  ///< of positions [m]; straight lines are drawn between them
};

/// The nodes with others between them, so that what is drawn is within the tolerance; at knots first. Nothing where
/// more than `most` would be needed. Where ω jumps so much at a knot that the drawing shows it, there are nodes on both
/// sides.
[[nodiscard]] std::optional<std::vector<CurveNode>> refined(std::vector<CurveNode> nodes, const NodeSource& source,
                                                            const DrawingTolerance& tolerance, std::size_t most);

/// Without those that the drawing does not need to be within the tolerance.
[[nodiscard]] std::vector<CurveNode> thinned(const std::vector<CurveNode>& nodes, const NodeSource& source,
                                             const DrawingTolerance& tolerance);

/// The nodes as they are, with all errors known.
[[nodiscard]] std::vector<CurveNode> with_errors(std::vector<CurveNode> nodes, const NodeSource& source);

}}}  // namespace orispline::report
