// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/segment_sampler.hpp>

namespace orispline::batch {
namespace {

constexpr std::size_t no_segment = static_cast<std::size_t>(-1);

double time_of(const Clock& clock, std::size_t k) noexcept {
  return clock.times ? clock.times[k] : (clock.first + static_cast<double>(k)) * clock.step + clock.start;
}

/// One sample's components of a span in either layout.
template <class T, int Components, class Vector>
void put(std::span<T> to, Layout layout, std::size_t samples, std::size_t at, const Vector& v) noexcept {
  if (to.empty()) return;
  for (int k = 0; k < Components; ++k) {
    const auto component = static_cast<std::size_t>(k);
    const std::size_t index = layout == Layout::planar ? component * samples + at : Components * at + component;
    to[index] = static_cast<T>(v[k]);
  }
}

}  // namespace

template <class T>
SegmentSampler<T>::SegmentSampler(const AnyCurve& curve, const CompiledCurve<T>* compiled,
                                  const Samples<T>& out) noexcept
    : curve_(curve), compiled_(compiled), out_(out), segment_(no_segment) {}

template <class T>
Target<T> SegmentSampler<T>::target_from(std::size_t at) const noexcept {
  const bool planar = out_.layout == Layout::planar;
  const auto from = [&](std::span<T> span, std::size_t components) -> T* {
    return span.empty() ? nullptr : span.data() + (planar ? at : components * at);
  };
  return {.orientation = from(out_.orientations, 4),
          .angular_velocity = from(out_.angular_velocities, 3),
          .angular_acceleration = from(out_.angular_accelerations, 3),
          .planes = planar ? static_cast<std::ptrdiff_t>(out_.size()) : 0};
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
  const bool rates = !out_.angular_velocities.empty() || !out_.angular_accelerations.empty();
  for (std::size_t k = 0; k < count; ++k) {
    const double t = time_of(clock, k);
    store(rates ? curve_.motion_on(segment, t) : Motion{.orientation = curve_.orientation_on(segment, t)}, at + k);
  }
}

template <class T>
void SegmentSampler<T>::held(const Eigen::Quaterniond& orientation, std::size_t at, std::size_t count) noexcept {
  Motion motion{.orientation = orientation};
  if (orientation.coeffs().hasNaN())
    motion.angular_velocity = motion.angular_acceleration = orientation.coeffs().head<3>();
  for (std::size_t k = 0; k < count; ++k) store(motion, at + k);
}

template <class T>
void SegmentSampler<T>::store(const Motion& motion, std::size_t at) noexcept {
  put<T, 4>(out_.orientations, out_.layout, out_.size(), at, motion.orientation.coeffs());
  put<T, 3>(out_.angular_velocities, out_.layout, out_.size(), at, motion.angular_velocity);
  put<T, 3>(out_.angular_accelerations, out_.layout, out_.size(), at, motion.angular_acceleration);
}

template class SegmentSampler<double>;
template class SegmentSampler<float>;

}  // namespace orispline::batch
