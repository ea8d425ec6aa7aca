// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <orispline/base/abi.hpp>

// Plain data only: this header is read by translation units that are compiled for different instruction sets, and an
// inline function that the linker merges across them would run where it cannot.
// Plain data only, for the reason given in record.hpp.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// How large the half angles of a segment get: which series of sine and cosine will do.
enum class AngleRange : unsigned char {
  narrow,  ///< the outer two within 0.25 rad, the inner one within 1 rad
  wide,    ///< all within 1 rad
  any,     ///< folded into a quadrant first
};

/// Largest polynomial degree of a record; coefficients beyond a segment's own degree are zero.
inline constexpr int record_degree = 7;

/// One segment of a cumulative curve with up to three factors, made ready for the kernel.
///
/// q(s) = M exp(a x_a) exp(b x_b) exp(c x_c) with unit axes, M in the segment's middle, half angles x that are
/// polynomials in s = (t - middle)/h. The product is linear in the sines and cosines of each angle, so that eight
/// constant quaternions times products of them give q. Derivation: docs/performance.md.
template <class T>
struct alignas(64) CumulativeRecord {
  T products[8][4];  ///< M {1,a} {1,b} {1,c}, components qx, qy, qz, qw; bit k of the index takes factor k
  T angles[record_degree + 1][4];  ///< row k: the coefficients of s^k in x_a, x_b, x_c [rad], and 0
  T carried[3][3];  ///< axis a in the frame after b: carried₀ + cos 2x_b carried₁ + sin 2x_b carried₂
  T axis_b[3], axis_c[3];
  double middle, per_step;  ///< [s], [1/s]
  AngleRange range;
  bool short_degree;  ///< degree at most 5
};

/// One segment of a chart curve: q(s) = base exp(φ(s)), φ a rotation vector of polynomials in s, ‖φ‖ ≤ 2 rad.
template <class T>
struct alignas(64) ChartRecord {
  T base[4];                                ///< qx, qy, qz, qw
  T rotation_vector[record_degree + 1][4];  ///< row k: the coefficients of s^k in φ [rad], and 0
  double middle, per_step;
  bool short_degree;
};

/// A great arc of R⁴: start cos(u half_angle) + across sin(u half_angle), u in [0, 1]; both qx, qy, qz, qw.
template <class T>
struct ArcRecord {
  T start[4], across[4];
  T half_angle;  ///< [rad], at most 1
};

/// One segment of a chain of spherical quadrangles, of which the kernel makes orientations alone: at u the slerp
/// between two arcs by 2u(1-u), less than 1 rad of R⁴ apart.
template <class T>
struct alignas(64) SquadRecord {
  ArcRecord<T> outer, inner;
  double middle, per_step;  ///< u = (t - middle) * per_step: the start of the segment [s], [1/s]
};

/// When samples are taken: at the times given, or sample k at k * step + start.
struct Clock {
  const double* times;  ///< null for even times
  double start, step;
  double first;  ///< index of the first sample
};

/// Where samples go. Null: not wanted. Sample i has its components at i * sample, component k at k * component beyond.
template <class T>
struct Target {
  T* orientation;
  T* angular_velocity = nullptr;
  T* angular_acceleration = nullptr;
  T* angular_jerk = nullptr;
  std::ptrdiff_t planes = 0;  ///< 0: the components of a sample side by side; else the distance between planes
};

/// A segment that many curves share but for their orientations: component after component, each as long as there are
/// curves. q = M exp(a s_a) exp(b s_b) exp(c s_c).
template <class T>
struct BundleSegment {
  const T* planes;    ///< M (qx, qy, qz, qw) and the half rotation vectors a, b, c (x, y, z): 13 planes
  std::size_t plane;  ///< the length of a plane, a multiple of 8 and at least the number of curves
  T factors[3];       ///< s_a, s_b, s_c at the time of the samples; all angles stay within 1 rad
};

/// Sample k is at (k * factor + offset) / divisor.
struct EvenTimes {
  double factor, offset, divisor;
};

/// Sample k is at the double nearest to high + low and the shortest decimal of k * factor / divisor together.
struct DecimalTimes {
  double factor, divisor;
  double high, low;  ///< an exact time, low to 2^-53 of itself
};

struct PolynomialKernels;

/// The loops of one instruction set. Each writes `count` samples, of one segment or of as many curves.
struct Kernels {
  const char* name;
  void (*cumulative)(const CumulativeRecord<double>&, const Clock&, std::size_t count, const Target<double>&);
  void (*cumulative_float)(const CumulativeRecord<float>&, const Clock&, std::size_t count, const Target<float>&);
  void (*chart)(const ChartRecord<double>&, const Clock&, std::size_t count, const Target<double>&);
  void (*chart_float)(const ChartRecord<float>&, const Clock&, std::size_t count, const Target<float>&);
  void (*squad)(const SquadRecord<double>&, const Clock&, std::size_t count, const Target<double>&);
  void (*squad_float)(const SquadRecord<float>&, const Clock&, std::size_t count, const Target<float>&);
  void (*bundle)(const BundleSegment<double>&, std::size_t count, const Target<double>&);
  void (*bundle_float)(const BundleSegment<float>&, std::size_t count, const Target<float>&);
  bool (*are_in_order)(const double* times, std::size_t count);  ///< whether they rise or stay, none being NaN
  /// From sample `first` on, a whole number like all k: exact up to 2⁵³.
  void (*write_even_times)(const EvenTimes&, double first, std::size_t count, double* times);
  /// The same where all offsets are from 10^decade on to below ten times that; NaN where it is not sure which double is
  /// the nearest. Returns how many these are.
  std::size_t (*write_decimal_times)(const DecimalTimes&, int decade, double first, std::size_t count, double* times);
  const PolynomialKernels* polynomials;
};

/// A piece of a curve whose components are polynomials in s = (t - middle) * per_step, with rising powers.
template <class T, int Components, int Degree>
struct PolynomialRecord {
  T coefficients[static_cast<std::size_t>(Components)][static_cast<std::size_t>(Degree) + 1];
  double middle, per_step;  ///< [s], [1/s]
};

template <class T>
inline constexpr int baked_degree = 9;
template <>
inline constexpr int baked_degree<float> = 5;

/// A piece of a baked curve: qx, qy, qz, qw; s in [-1, 1].
template <class T>
using BakedRecord = PolynomialRecord<T, 4, baked_degree<T>>;

/// A cubic segment of R⁴, to be normalised: qx, qy, qz, qw; s in [-1/2, 1/2].
template <class T>
using RationalRecord = PolynomialRecord<T, 4, 3>;

/// A segment of a path: x, y, z [m]; s in [-1, 1].
template <class T>
using PathRecord = PolynomialRecord<T, 3, 7>;

/// Where samples of a path go, as Target for orientations.
template <class T>
struct PathTarget {
  T* position;
  T* velocity;
  T* acceleration;
  T* jerk;
  std::ptrdiff_t planes;
};

/// The loops over polynomials of one instruction set. Each writes `count` samples of one piece.
struct PolynomialKernels {
  void (*baked)(const BakedRecord<double>&, const Clock&, std::size_t count, const Target<double>&);
  void (*baked_float)(const BakedRecord<float>&, const Clock&, std::size_t count, const Target<float>&);
  void (*rational)(const RationalRecord<double>&, const Clock&, std::size_t count, const Target<double>&);
  void (*rational_float)(const RationalRecord<float>&, const Clock&, std::size_t count, const Target<float>&);
  void (*path)(const PathRecord<double>&, const Clock&, std::size_t count, const PathTarget<double>&);
  void (*path_float)(const PathRecord<float>&, const Clock&, std::size_t count, const PathTarget<float>&);
};

}}}  // namespace orispline::batch
