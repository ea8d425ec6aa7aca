// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

#include <orispline/batch/sample.hpp>
#include <orispline/curve/composition.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// In which frame angular rates are given.
enum class RateFrame { body, world };

/// A moving body that is sampled again and again, at any times.
///
/// Where few times fall on each segment, its compiled form is kept for the next ones. The bits of a sample do not
/// depend on the other times. Any number of threads may sample at once.
class ORISPLINE_EXPORT PoseSampler {
 public:
  explicit PoseSampler(PoseCurve curve);
  /// Of the orientations of product_of(), made of the samples of both. Errors: its own.
  [[nodiscard]] static Expected<PoseSampler> product(const PoseSampler& a, const PoseSampler& b,
                                                     ClockOffsets offsets = {});

  [[nodiscard]] const PoseCurve& curve() const noexcept { return curve_; }
  [[nodiscard]] const CompiledCurve<double>& compiled() const noexcept { return compiled_; }

  /// Samples at times in any order. Rates of the world take room for the orders below: the accelerations need the
  /// velocities, the jerks both. Errors: those of sample_at() and extrapolate().
  template <class T>
  [[nodiscard]] Expected<void> sample_at(std::span<const double> times, const Samples<T>& out,
                                         Extrapolation beyond = Extrapolation::hold, RateFrame frame = RateFrame::body,
                                         Work work = {}) const;

 private:
  struct Factors;

  PoseCurve curve_;
  CompiledCurve<double> compiled_;
  std::shared_ptr<const Factors> factors_{};
};

/// Turns rates of the body, with the orientations beside them, into those of the world.
template <class T>
ORISPLINE_EXPORT void turn_to_world(const Samples<T>& samples);

/// Samples that are best made together: so many as are still in the cache of a thread when they are looked at again, or
/// as keep all threads busy.
[[nodiscard]] ORISPLINE_EXPORT std::size_t samples_at_a_time(Work work);

/// Makes samples by `make(begin, count)`, those together that are best made together, until it fails. The time that an
/// error of it names is then that among all of them.
template <class Make>
[[nodiscard]] Expected<void> in_blocks(std::size_t size, Work work, Make make) {
  const std::size_t most = samples_at_a_time(work);
  for (std::size_t begin = 0; begin < size; begin += most) {
    Expected<void> made = make(begin, std::min(most, size - begin));
    if (made) continue;
    if (auto& index = made.error().where.time_index) *index += begin;
    return made;
  }
  return {};
}

}}  // namespace orispline
