// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <orispline/batch/kernel/record.hpp>

// Plain data only, for the reason given in record.hpp.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

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
