// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/curve_bundle.hpp>

#include <algorithm>

#include <orispline/batch/compile_segment.hpp>
#include <orispline/batch/kernel/dispatch.hpp>
#include <orispline/batch/sample_layout.hpp>
#include <orispline/batch/segment_sampler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t plane_step = 128;  // the kernel reads whole blocks
constexpr std::size_t components = 13;   // M, a, b, c

bool same_blending(const CumulativeForm& a, const CumulativeForm& b) {
  if (a.degree != b.degree) return false;
  for (std::size_t k = 0; k < a.blending.size(); ++k)
    if (a.blending[k].coefficients != b.blending[k].coefficients) return false;
  return true;
}

/// The numbers of one curve in a segment, in the order of the planes.
std::array<double, components> column_of(const batch::FactoredSegment& segment) {
  std::array<double, components> column{};
  std::ranges::copy(segment.middle.coeffs(), column.begin());
  for (std::size_t k = 0; k < 3; ++k)
    std::ranges::copy(segment.vectors[k], column.begin() + 4 + 3 * static_cast<std::ptrdiff_t>(k));
  return column;
}

double at(const std::array<double, batch::record_degree + 1>& powers, double s) {
  double sum = 0.0;
  for (std::size_t k = powers.size(); k-- > 0;) sum = sum * s + powers[k];
  return sum;
}

void call(const batch::BundleSegment<double>& segment, std::size_t count, const batch::Target<double>& target) {
  batch::kernels().bundle(segment, count, target);
}
void call(const batch::BundleSegment<float>& segment, std::size_t count, const batch::Target<float>& target) {
  batch::kernels().bundle_float(segment, count, target);
}

}  // namespace

template <class T>
Expected<CurveBundle<T>> CurveBundle<T>::make(std::vector<AnyCurve> curves) {
  if (curves.empty()) return failure(ErrorCode::bad_argument, "a bundle needs a curve, found none");
  const auto times = curves.front().knots().times();
  for (std::size_t i = 1; i < curves.size(); ++i)
    if (!std::ranges::equal(curves[i].knots().times(), times))
      return failure(ErrorCode::bad_argument, "the key times differ from those of the first curve, wanted the same",
                     {.curve = i});
  CurveBundle bundle(std::move(curves));
  bundle.plane_ = (bundle.size() + plane_step - 1) / plane_step * plane_step;
  for (std::size_t segment = 0; segment < bundle.curves_.front().knots().segments(); ++segment)
    if (auto error = bundle.add_segment(segment)) return tl::unexpected(std::move(*error));
  return bundle;
}

template <class T>
std::optional<Error> CurveBundle<T>::add_segment(std::size_t index) {
  Segment segment{.planes = std::vector<T>(components * plane_),
                  .factors = {},
                  .middle_time = 0.0,
                  .per_step = 0.0,
                  .within_range = true};
  std::optional<CumulativeForm> first;
  for (std::size_t i = 0; i < size(); ++i) {
    const SegmentForm form = curves_[i].form(index);
    const auto* cumulative = std::get_if<CumulativeForm>(&form);
    if (!cumulative)
      return Error{ErrorCode::bad_argument,
                   "a bundle takes curves of up to three cumulative factors, found another kind",
                   {.curve = i}};
    if (!first) first = *cumulative;
    if (!same_blending(*first, *cumulative))
      return Error{ErrorCode::bad_argument,
                   "the blending differs from that of the first curve, wanted the same tensions",
                   {.curve = i}};
    const batch::FactoredSegment factored = batch::factored(*cumulative, curves_[i].knots().span(index));
    for (std::size_t k = 0; k < 3; ++k)
      if (!(factored.vectors[k].norm() * factored.largest[k] <= 1.0)) segment.within_range = false;
    const auto column = column_of(factored);
    for (std::size_t k = 0; k < components; ++k) segment.planes[k * plane_ + i] = static_cast<T>(column[k]);
    segment.factors = factored.factors;
    segment.middle_time = factored.middle_time;
    segment.per_step = factored.per_step;
  }
  segments_.push_back(std::move(segment));
  return std::nullopt;
}

template <class T>
Expected<void> CurveBundle<T>::sample(double t, const Samples<T>& out) const {
  if (auto error = batch::check_room(out, size())) return tl::unexpected(std::move(*error));
  if (wants_angular_rates(out) || wants_positions(out))
    return failure(ErrorCode::bad_argument, "a bundle gives orientations only, found room for more");
  const Domain domain = curves_.front().domain();
  const std::size_t index = curves_.front().knots().segment_at(t);
  if (!domain.contains(t) || segments_.empty() || !segments_[index].within_range) {
    for (std::size_t i = 0; i < size(); ++i) batch::put_held(out, i, 1, curves_[i](t));
    return {};
  }
  const Segment& segment = segments_[index];
  const double s = (t - segment.middle_time) * segment.per_step;
  batch::BundleSegment<T> record{.planes = segment.planes.data(), .plane = plane_, .factors = {}};
  for (std::size_t k = 0; k < 3; ++k) record.factors[k] = static_cast<T>(at(segment.factors[k], s));
  call(record, size(), batch::target_of(out, 0));
  return {};
}

template class CurveBundle<double>;
template class CurveBundle<float>;

}}  // namespace orispline
