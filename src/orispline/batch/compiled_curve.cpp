// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/compiled_curve.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace batch {

template <class T>
class KeptRecords {
 public:
  explicit KeptRecords(std::size_t segments) : places_(segments) {}
  KeptRecords(const KeptRecords&) = delete;
  KeptRecords& operator=(const KeptRecords&) = delete;
  ~KeptRecords() {
    for (const auto& place : places_) delete place.load(std::memory_order_relaxed);
  }

  /// Null where there is no memory.
  [[nodiscard]] const SegmentRecord<T>* of(const AnyCurve& curve, std::size_t segment) noexcept {
    const SegmentRecord<T>* const kept = places_[segment].load(std::memory_order_acquire);
    return kept ? kept : make(curve, segment);
  }

 private:
  /// Of two threads that make it, one keeps that of the other.
  [[nodiscard]] const SegmentRecord<T>* make(const AnyCurve& curve, std::size_t segment) noexcept {
    std::unique_ptr<const SegmentRecord<T>> record(new (std::nothrow) SegmentRecord<T>(record_of<T>(curve, segment)));
    const SegmentRecord<T>* kept = nullptr;
    const bool is_first =
        record && places_[segment].compare_exchange_strong(kept, record.get(), std::memory_order_acq_rel);
    return is_first ? record.release() : kept;
  }

  std::vector<std::atomic<const SegmentRecord<T>*>> places_;
};

}  // namespace batch

template <class T>
CompiledCurve<T>::CompiledCurve(AnyCurve curve, Compiling when) : curve_(std::move(curve)) {
  const Knots& knots = curve_.knots();
  if (when == Compiling::as_wanted) {
    wanted_ = std::make_shared<batch::KeptRecords<T>>(knots.segments());
    return;
  }
  records_.reserve(knots.segments());
  for (std::size_t i = 0; i < knots.segments(); ++i) records_.push_back(batch::record_of<T>(curve_, i));
}

template <class T>
Eigen::Quaternion<T> CompiledCurve<T>::operator()(double t) const noexcept {
  const Knots& knots = curve_.knots();
  if (std::isnan(t)) return Eigen::Quaternion<T>(Eigen::Vector4<T>::Constant(std::numeric_limits<T>::quiet_NaN()));
  t = std::clamp(t, knots.front(), knots.back());
  if (knots.segments() == 0) return curve_(t).template cast<T>();
  const std::size_t segment = knots.segment_at(t);
  const auto* const kept = record(segment);
  return kept ? batch::orientation_by(*kept, curve_, segment, t)
              : batch::orientation_by(batch::record_of<T>(curve_, segment), curve_, segment, t);
}

template <class T>
const batch::SegmentRecord<T>* CompiledCurve<T>::made(std::size_t segment) const noexcept {
  return wanted_->of(curve_, segment);
}

template class CompiledCurve<double>;
template class CompiledCurve<float>;

}}  // namespace orispline
