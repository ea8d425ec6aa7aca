// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include <orispline/base/expected.hpp>
#include <orispline/batch/baked_curve.hpp>
#include <orispline/batch/compiled_curve.hpp>
#include <orispline/curve/extrapolation.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How the components of samples lie in memory.
enum class Layout {
  interleaved,  ///< sample after sample: qx, qy, qz, qw (Eigen's order), or x, y, z
  planar,       ///< component after component: all qx, then all qy, …
};

/// Where samples go: memory of the caller, 4 numbers a sample for orientations, 3 for all else. Empty: not wanted, but
/// for the orientations, which are always given.
///
/// Angular rates are in the **body** frame, [rad/s], [rad/s²] and [rad/s³]; positions with their rates, which only a
/// PoseCurve has, in the world frame, [m], [m/s], [m/s²] and [m/s³].
template <class T>
struct Samples {
  std::span<T> orientations;
  std::span<T> angular_velocities{};
  std::span<T> angular_accelerations{};
  std::span<T> angular_jerks{};
  std::span<T> positions{};
  std::span<T> velocities{};
  std::span<T> accelerations{};
  std::span<T> linear_jerks{};
  Layout layout = Layout::interleaved;
  /// From the first number of one component to that of the next one in a planar layout, such as the rows of a larger
  /// table of which the samples fill some; a span of n samples is then plane * (components - 1) + n long, and what lies
  /// between is not touched. 0: the number of samples.
  std::size_t plane = 0;

  [[nodiscard]] std::size_t size() const noexcept {
    return plane == 0 ? orientations.size() / 4 : orientations.size() - std::min(orientations.size(), 3 * plane);
  }
};

template <class T>
[[nodiscard]] bool wants_angular_rates(const Samples<T>& out) noexcept {
  return !out.angular_velocities.empty() || !out.angular_accelerations.empty() || !out.angular_jerks.empty();
}
template <class T>
[[nodiscard]] bool wants_positions(const Samples<T>& out) noexcept {
  return !out.positions.empty() || !out.velocities.empty() || !out.accelerations.empty() || !out.linear_jerks.empty();
}

/// How sampling uses the machine; the samples do not depend on it.
struct Work {
  unsigned threads = 1;  ///< 0: one per core
};

// Every kind of curve is sampled at every kind of times:
//
// |               | sample_uniform, sample, sample_at                                                  |
// |---------------|------------------------------------------------------------------------------------|
// | AnyCurve      | orientation, angular velocity, acceleration, jerk                                  |
// | CompiledCurve | the same                                                                           |
// | BakedCurve    | the same, of its polynomials                                                       |
// | PoseCurve     | the same, and position, velocity, acceleration, jerk where its keys have positions |
//
// Curves of polynomial pieces (every cumulative family of up to three factors, every chart family) go through the
// vector kernel, at a few nanoseconds a sample; others through their own evaluator. All samples agree with motion() to
// rounding, have the same bits on every processor and with any number of threads, and at a knot are those of the
// right-hand segment. Before the first and after the last key the end orientation is held, at rest; a time that is NaN
// gives NaN. Nothing is allocated on one thread.
//
// A PoseCurve gives positions too: paths of polynomials of degree 7 at most by the kernel, within some units of
// rounding of the largest coordinate [m] of its control points, others by the scalar evaluator.
//
// A BakedCurve gives orientations within its tolerance of the curve's own, as fast as it gets, and the exact rates of
// its polynomials: see bake().
//
// Errors (bad_argument): spans whose sizes do not belong together; what the curve does not give; times that decrease,
// with the index of the first one that does.

/// Evenly spaced: sample k at k * dt + t0, computed as written. dt may not be negative.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_uniform(const AnyCurve& curve, double t0, double dt,
                                                             const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_uniform(const CompiledCurve<T>& curve, double t0, double dt,
                                                             const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_uniform(const PoseCurve& curve, double t0, double dt,
                                                             const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_uniform(const BakedCurve<T>& curve, double t0, double dt,
                                                             const Samples<T>& out, Work work = {});

/// At times that do not decrease.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample(const AnyCurve& curve, std::span<const double> times,
                                                     const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample(const CompiledCurve<T>& curve, std::span<const double> times,
                                                     const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample(const PoseCurve& curve, std::span<const double> times,
                                                     const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample(const BakedCurve<T>& curve, std::span<const double> times,
                                                     const Samples<T>& out, Work work = {});

/// At times in any order; successive ones of one segment are as fast as sorted ones.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_at(const AnyCurve& curve, std::span<const double> times,
                                                        const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_at(const CompiledCurve<T>& curve, std::span<const double> times,
                                                        const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_at(const PoseCurve& curve, std::span<const double> times,
                                                        const Samples<T>& out, Work work = {});
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_at(const BakedCurve<T>& curve, std::span<const double> times,
                                                        const Samples<T>& out, Work work = {});

/// Many curves at one time, a sample each.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> sample_many(std::span<const CompiledCurve<T>> curves, double t,
                                                          const Samples<T>& out, Work work = {});

/// Writes the samples outside the curve again, which `sample…` holds at rest; those inside stay as they are.
///
/// Errors (bad_argument): room for another number of samples, or for positions that the keys do not have; where times
/// outside are an error, the first of them, with its index.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT Expected<void> extrapolate(const PoseCurve& curve, std::span<const double> times,
                                                          Extrapolation how, const Samples<T>& out, Work work = {});

/// The error (bad_argument, with its index) of the first time that is outside the curve. NaN is none.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_inside(const AnyCurve& curve, std::span<const double> times);

}}  // namespace orispline
