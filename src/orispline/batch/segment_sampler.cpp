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
Target<T> SegmentSampler<T>::target_from(std::size_t at) const noexcept {
  return {.orientation = place_of(out_.orientations, out_.layout, 4, at),
          .angular_velocity = place_of(out_.angular_velocities, out_.layout, 3, at),
          .angular_acceleration = place_of(out_.angular_accelerations, out_.layout, 3, at),
          .angular_jerk = place_of(out_.angular_jerks, out_.layout, 3, at),
          .planes = plane_distance(out_)};
}

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
  if (by_kernel(record(segment), clock, count, target_from(at))) return;
  const bool rates = wants_angular_rates(out_);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = time_of(clock, k);
    store(rates ? curve_.motion_on(segment, t) : Motion{.orientation = curve_.orientation_on(segment, t)}, at + k);
  }
}

template <class T>
Eigen::Quaterniond SegmentSampler<T>::orientation_at(double t) noexcept {
  if (curve_.knots().segments() == 0) return curve_(t);
  const std::size_t segment = curve_.knots().segment_at(t);
  return orientation_by(record(segment), curve_, segment, t).template cast<double>();
}

template <class T>
void SegmentSampler<T>::held(const Eigen::Quaterniond& orientation, std::size_t at, std::size_t count) noexcept {
  Motion motion{.orientation = orientation};
  if (orientation.coeffs().hasNaN())
    motion.angular_velocity = motion.angular_acceleration = motion.angular_jerk = orientation.coeffs().head<3>();
  for (std::size_t k = 0; k < count; ++k) store(motion, at + k);
}

template <class T>
void SegmentSampler<T>::store(const Motion& motion, std::size_t at) noexcept {
  put<4>(out_, out_.orientations, at, motion.orientation.coeffs());
  put<3>(out_, out_.angular_velocities, at, motion.angular_velocity);
  put<3>(out_, out_.angular_accelerations, at, motion.angular_acceleration);
  put<3>(out_, out_.angular_jerks, at, motion.angular_jerk);
}

template class SegmentSampler<double>;
template class SegmentSampler<float>;

}  // namespace orispline::batch
