// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/slerp_bezier.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

SlerpBezierCurve::SlerpBezierCurve(Knots knots, std::span<const Eigen::Quaterniond> controls)
    : knots_(std::move(knots)) {
  ORISPLINE_EXPECT(controls.size() == 3 * knots_.segments() + 1);
  segments_.resize(knots_.segments());
  for (std::size_t i = 0; i + 1 < controls.size(); ++i) {
    segments_[i / 3].starts[i % 3] = controls[i];
    segments_[i / 3].increments[i % 3] = increment<double>(controls[i], controls[i + 1]);
  }
}

}}  // namespace orispline
