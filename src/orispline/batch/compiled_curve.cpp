// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/compiled_curve.hpp>

#include <orispline/batch/sample.hpp>

namespace orispline {
namespace batch {

template <class T>
SegmentRecord<T> record_of(const AnyCurve& curve, std::size_t segment) noexcept {
  if (curve.knots().segments() == 0) return {};
  const SegmentForm form = curve.form(segment);
  const KnotSpan span = curve.knots().span(segment);
  if (const auto* cumulative = std::get_if<CumulativeForm>(&form)) return compile_segment<T>(*cumulative, span);
  if (const auto* chart = std::get_if<ChartForm>(&form))
    if (const auto compiled = compile_segment<T>(*chart, span); compiled.half_angle <= largest_chart_half_angle)
      return compiled.record;
  return {};
}

template SegmentRecord<double> record_of<double>(const AnyCurve&, std::size_t) noexcept;
template SegmentRecord<float> record_of<float>(const AnyCurve&, std::size_t) noexcept;

}  // namespace batch

template <class T>
CompiledCurve<T>::CompiledCurve(AnyCurve curve) : curve_(std::move(curve)) {
  records_.reserve(curve_.knots().segments());
  for (std::size_t i = 0; i < curve_.knots().segments(); ++i) records_.push_back(batch::record_of<T>(curve_, i));
}

template <class T>
Eigen::Quaternion<T> CompiledCurve<T>::operator()(double t) const noexcept {
  Eigen::Quaternion<T> q;
  const auto sampled = sample_at<T>(*this, {&t, 1}, {.orientations = {q.coeffs().data(), 4}});
  ORISPLINE_EXPECT(sampled.has_value());
  return q;
}

template class CompiledCurve<double>;
template class CompiledCurve<float>;

}  // namespace orispline
