// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/compiled_curve.hpp>

#include <orispline/batch/compile_segment.hpp>
#include <orispline/batch/kernel/dispatch.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

namespace {

const auto& cumulative_kernel(const Kernels& k, double) noexcept { return k.cumulative; }
const auto& cumulative_kernel(const Kernels& k, float) noexcept { return k.cumulative_float; }
const auto& chart_kernel(const Kernels& k, double) noexcept { return k.chart; }
const auto& chart_kernel(const Kernels& k, float) noexcept { return k.chart_float; }
const auto& rational_kernel(const Kernels& k, double) noexcept { return k.polynomials->rational; }
const auto& rational_kernel(const Kernels& k, float) noexcept { return k.polynomials->rational_float; }

const auto& squad_kernel(const Kernels& k, double) noexcept { return k.squad; }
const auto& squad_kernel(const Kernels& k, float) noexcept { return k.squad_float; }

template <class T>
Written write(std::monostate, const Clock&, std::size_t, const Target<T>&) noexcept {
  return Written::nothing;
}
template <class T>
Written write(const CumulativeRecord<T>& record, const Clock& clock, std::size_t count,
              const Target<T>& target) noexcept {
  cumulative_kernel(kernels(), T())(record, clock, count, target);
  return Written::all;
}
template <class T>
Written write(const ChartRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) noexcept {
  chart_kernel(kernels(), T())(record, clock, count, target);
  return Written::all;
}
template <class T>
Written write(const RationalRecord<T>& record, const Clock& clock, std::size_t count,
              const Target<T>& target) noexcept {
  rational_kernel(kernels(), T())(record, clock, count, target);
  return Written::all;
}
template <class T>
Written write(const SquadRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) noexcept {
  squad_kernel(kernels(), T())(record, clock, count, target);
  const bool all = !target.angular_velocity && !target.angular_acceleration && !target.angular_jerk;
  return all ? Written::all : Written::orientations;
}

/// What `use` makes of a segment's record, which stays where it was made: a copy takes as long as some samples.
template <class T, class Use>
auto with_record(const AnyCurve& curve, std::size_t segment, Use use) noexcept {
  if (curve.knots().segments() == 0) return use(std::monostate());
  const SegmentForm form = curve.form(segment);
  const KnotSpan span = curve.knots().span(segment);
  if (const auto* cumulative = std::get_if<CumulativeForm>(&form))
    if (const auto compiled = compile_segment<T>(*cumulative, span);
        compiled.half_angle <= largest_cumulative_half_angle)
      return use(compiled.record);
  if (const auto* chart = std::get_if<ChartForm>(&form))
    if (const auto compiled = compile_segment<T>(*chart, span); compiled.half_angle <= largest_chart_half_angle)
      return use(compiled.record);
  if (const auto* rational = std::get_if<RationalForm>(&form))
    if (const auto compiled = compile_segment<T>(*rational, span); compiled.spread <= largest_rational_spread)
      return use(compiled.record);
  if (const auto* squad = std::get_if<SquadForm>(&form))
    if (const auto compiled = compile_segment<T>(*squad, span); compiled.half_angle <= largest_squad_half_angle)
      return use(compiled.record);
  return use(std::monostate());
}

}  // namespace

template <class T>
SegmentRecord<T> record_of(const AnyCurve& curve, std::size_t segment) noexcept {
  return with_record<T>(curve, segment, [](const auto& record) { return SegmentRecord<T>(record); });
}

template <class T>
Written by_kernel(const SegmentRecord<T>& record, const Clock& clock, std::size_t count,
                  const Target<T>& target) noexcept {
  return std::visit([&](const auto& r) { return write<T>(r, clock, count, target); }, record);
}

template <class T>
Written by_kernel(const AnyCurve& curve, std::size_t segment, const Clock& clock, std::size_t count,
                  const Target<T>& target) noexcept {
  return with_record<T>(curve, segment, [&](const auto& r) { return write<T>(r, clock, count, target); });
}

template <class T>
Eigen::Quaternion<T> orientation_by(const SegmentRecord<T>& record, const AnyCurve& curve, std::size_t segment,
                                    double t) noexcept {
  Eigen::Quaternion<T> q;
  const Clock clock{.times = &t, .start = 0.0, .step = 0.0, .first = 0.0};
  if (by_kernel(record, clock, 1, Target<T>{.orientation = q.coeffs().data()}) != Written::nothing) return q;
  return curve.orientation_on(segment, t).template cast<T>();
}

template SegmentRecord<double> record_of<double>(const AnyCurve&, std::size_t) noexcept;
template SegmentRecord<float> record_of<float>(const AnyCurve&, std::size_t) noexcept;
template Eigen::Quaternion<double> orientation_by<double>(const SegmentRecord<double>&, const AnyCurve&, std::size_t,
                                                          double) noexcept;
template Eigen::Quaternion<float> orientation_by<float>(const SegmentRecord<float>&, const AnyCurve&, std::size_t,
                                                        double) noexcept;
template Written by_kernel<double>(const SegmentRecord<double>&, const Clock&, std::size_t,
                                   const Target<double>&) noexcept;
template Written by_kernel<float>(const SegmentRecord<float>&, const Clock&, std::size_t,
                                  const Target<float>&) noexcept;
template Written by_kernel<double>(const AnyCurve&, std::size_t, const Clock&, std::size_t,
                                   const Target<double>&) noexcept;
template Written by_kernel<float>(const AnyCurve&, std::size_t, const Clock&, std::size_t,
                                  const Target<float>&) noexcept;

}}}  // namespace orispline::batch
