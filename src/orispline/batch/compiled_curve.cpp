// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/compiled_curve.hpp>

#include <cmath>
#include <limits>

namespace orispline {
template <class T>
CompiledCurve<T>::CompiledCurve(AnyCurve curve)
    : curve_(std::move(curve)),
      first_(curve_(curve_.domain().start).template cast<T>()),
      last_(curve_(curve_.domain().end).template cast<T>()) {
  records_.reserve(curve_.knots().segments());
  for (std::size_t i = 0; i < curve_.knots().segments(); ++i) records_.push_back(batch::record_of<T>(curve_, i));
}

template <class T>
Eigen::Quaternion<T> CompiledCurve<T>::operator()(double t) const noexcept {
  const Knots& knots = curve_.knots();
  if (t < knots.front()) return first_;
  if (t > knots.back()) return last_;
  if (std::isnan(t)) return Eigen::Quaternion<T>(Eigen::Vector4<T>::Constant(std::numeric_limits<T>::quiet_NaN()));
  if (records_.empty()) return first_;
  const std::size_t segment = knots.segment_at(t);
  Eigen::Quaternion<T> q;
  const batch::Clock clock{.times = &t, .start = 0.0, .step = 0.0, .first = 0.0};
  const batch::Target<T> target{.orientation = q.coeffs().data()};
  if (batch::by_kernel(records_[segment], clock, 1, target)) return q;
  return curve_.orientation_on(segment, t).template cast<T>();
}

template class CompiledCurve<double>;
template class CompiledCurve<float>;

}  // namespace orispline
