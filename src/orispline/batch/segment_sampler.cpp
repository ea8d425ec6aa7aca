// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/segment_sampler.hpp>

#include <orispline/batch/sample_layout.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

template <class T>
void SegmentSampler<T>::on_segment(std::size_t segment, const Clock& clock, std::size_t at,
                                   std::size_t count) noexcept {
  const Target<T> target = target_of(out_, at);
  const SegmentRecord<T>* const record = compiled_ ? compiled_->record(segment) : nullptr;
  const Written written =
      record ? by_kernel(*record, clock, count, target) : by_kernel(curve_, segment, clock, count, target);
  if (written == Written::all) return;
  const bool rates = wants_angular_rates(out_);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = time_of(clock, k);
    const Motion m = rates ? curve_.motion_on(segment, t) : Motion{.orientation = curve_.orientation_on(segment, t)};
    if (written == Written::nothing) put(out_, at + k, m);
    else put_rates(out_, at + k, m);
  }
}

template <class T>
Eigen::Quaterniond SegmentSampler<T>::orientation_at(double t) const noexcept {
  if (curve_.knots().segments() == 0) return curve_(t);
  const std::size_t segment = curve_.knots().segment_at(t);
  const auto at_end = [&](const SegmentRecord<T>& record) {
    return orientation_by(record, curve_, segment, t).template cast<double>();
  };
  const SegmentRecord<T>* const record = compiled_ ? compiled_->record(segment) : nullptr;
  return record ? at_end(*record) : at_end(record_of<T>(curve_, segment));
}

template class SegmentSampler<double>;
template class SegmentSampler<float>;

}}}  // namespace orispline::batch
