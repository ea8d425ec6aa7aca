// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/segment_sampler.hpp>

#include <orispline/batch/sample_layout.hpp>

namespace orispline::batch {
namespace {

constexpr std::size_t no_segment = static_cast<std::size_t>(-1);

}  // namespace

template <class T>
SegmentSampler<T>::SegmentSampler(const AnyCurve& curve, const CompiledCurve<T>* compiled,
                                  const Samples<T>& out) noexcept
    : curve_(curve), compiled_(compiled), out_(out), segment_(no_segment) {}

template <class T>
const SegmentRecord<T>& SegmentSampler<T>::record(std::size_t segment) noexcept {
  if (compiled_) return compiled_->record(segment);
  if (segment_ != segment) {
    own_ = record_of<T>(curve_, segment);
    segment_ = segment;
  }
  return own_;
}

template <class T>
void SegmentSampler<T>::on_segment(std::size_t segment, const Clock& clock, std::size_t at,
                                   std::size_t count) noexcept {
  if (by_kernel(record(segment), clock, count, target_of(out_, at))) return;
  const bool rates = wants_angular_rates(out_);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = time_of(clock, k);
    put(out_, at + k, rates ? curve_.motion_on(segment, t) : Motion{.orientation = curve_.orientation_on(segment, t)});
  }
}

template <class T>
Eigen::Quaterniond SegmentSampler<T>::orientation_at(double t) noexcept {
  if (curve_.knots().segments() == 0) return curve_(t);
  const std::size_t segment = curve_.knots().segment_at(t);
  return orientation_by(record(segment), curve_, segment, t).template cast<double>();
}

template class SegmentSampler<double>;
template class SegmentSampler<float>;

}  // namespace orispline::batch
