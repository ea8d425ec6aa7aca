// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/compiled_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI {
template <class T>
CompiledCurve<T>::CompiledCurve(AnyCurve curve) : curve_(std::move(curve)) {
  const Knots& knots = curve_.knots();
  records_.reserve(knots.segments());
  for (std::size_t i = 0; i < knots.segments(); ++i) records_.push_back(batch::record_of<T>(curve_, i));
}

template <class T>
Eigen::Quaternion<T> CompiledCurve<T>::operator()(double t) const noexcept {
  const Knots& knots = curve_.knots();
  if (std::isnan(t)) return Eigen::Quaternion<T>(Eigen::Vector4<T>::Constant(std::numeric_limits<T>::quiet_NaN()));
  t = std::clamp(t, knots.front(), knots.back());
  if (records_.empty()) return curve_(t).template cast<T>();
  const std::size_t segment = knots.segment_at(t);
  return batch::orientation_by(records_[segment], curve_, segment, t);
}

template class CompiledCurve<double>;
template class CompiledCurve<float>;

}}  // namespace orispline
