// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/base/expected.hpp>
#include <orispline/batch/compiled_curve.hpp>

namespace orispline {

/// How the components of samples lie in memory.
enum class Layout {
  interleaved,  ///< sample after sample: qx, qy, qz, qw (Eigen's order), or x, y, z
  planar,       ///< component after component: all qx, then all qy, …
};

/// Where samples go: memory of the caller, 4 numbers a sample for orientations, 3 for rates.
///
/// Orientations are always wanted, rates only where their span is not empty. Rates are in the **body** frame, [rad/s]
/// and [rad/s²].
template <class T>
struct Samples {
  std::span<T> orientations;
  std::span<T> angular_velocities{};
  std::span<T> angular_accelerations{};
  Layout layout = Layout::interleaved;

  [[nodiscard]] std::size_t size() const noexcept { return orientations.size() / 4; }
};

/// How sampling uses the machine; the samples do not depend on it.
struct Work {
  unsigned threads = 1;  ///< 0: one per core
};

// Curves of polynomial pieces (every cumulative family of up to three factors, every chart family) go through the
// vector kernel, at a few nanoseconds a sample; others through their own evaluator. All samples agree with motion() to
// rounding, have the same bits on every processor and with any number of threads, and at a knot are those of the
// right-hand segment. Before the first and after the last key the end orientation is held, at rest; a time that is NaN
// gives NaN. Nothing is allocated on one thread.
//
// Errors (bad_argument): spans whose sizes do not belong together; times that decrease, with the index of the first
// one that does.

/// Evenly spaced: sample k at k * dt + t0, computed as written. dt may not be negative.
template <class T>
[[nodiscard]] Expected<void> sample_uniform(const AnyCurve& curve, double t0, double dt, const Samples<T>& out,
                                            Work work = {});
template <class T>
[[nodiscard]] Expected<void> sample_uniform(const CompiledCurve<T>& curve, double t0, double dt, const Samples<T>& out,
                                            Work work = {});

/// At times that do not decrease.
template <class T>
[[nodiscard]] Expected<void> sample(const AnyCurve& curve, std::span<const double> times, const Samples<T>& out,
                                    Work work = {});
template <class T>
[[nodiscard]] Expected<void> sample(const CompiledCurve<T>& curve, std::span<const double> times, const Samples<T>& out,
                                    Work work = {});

/// At times in any order.
template <class T>
[[nodiscard]] Expected<void> sample_at(const CompiledCurve<T>& curve, std::span<const double> times,
                                       const Samples<T>& out, Work work = {});

/// Many curves at one time, a sample each.
template <class T>
[[nodiscard]] Expected<void> sample_many(std::span<const CompiledCurve<T>> curves, double t, const Samples<T>& out,
                                         Work work = {});

}  // namespace orispline
