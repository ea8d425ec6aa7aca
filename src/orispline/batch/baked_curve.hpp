// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/batch/kernel/record.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What bounds a bake, besides its tolerance.
struct BakeOptions {
  std::size_t max_pieces = std::size_t{1} << 20;  ///< of the whole curve; in double these take 360 MB
};

/// A curve of any kind turned into polynomials: for curves that are stored and replayed. `bake` makes one.
///
/// The four components of the quaternion are polynomials of degree 9 (`float`: 5) on pieces of the segments. They keep
/// the curve's own signs, and its ends are held as the curve's are. 344 bytes a piece in double, 120 in float; one
/// segment has 2^n pieces or fewer, by its own need.
template <class T = double>
class ORISPLINE_EXPORT BakedCurve {
 public:
  [[nodiscard]] Domain domain() const noexcept { return {knots_.front(), knots_.back()}; }
  /// The ends of the pieces [s].
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  [[nodiscard]] const batch::BakedRecord<T>& piece(std::size_t index) const noexcept { return pieces_[index]; }
  /// All of them, to be stored; of a single key there is one.
  [[nodiscard]] std::span<const batch::BakedRecord<T>> pieces() const noexcept { return pieces_; }
  /// The largest difference from the curve that was found while baking [rad], measured as the tolerance is.
  [[nodiscard]] double largest_difference() const noexcept { return largest_difference_; }

  /// A baked curve that was stored: the ends of its pieces [s], the pieces, and its largest difference. Error: bad_data
  /// for times that do not increase, for numbers that are not finite, for another number of pieces, and for a piece
  /// whose orientations are not finite all the way from its start to its end.
  [[nodiscard]] static Expected<BakedCurve> restored(std::vector<double> ends,
                                                     std::vector<batch::BakedRecord<T>> pieces,
                                                     double largest_difference);

  /// Orientation at time t [s], as a sample of it; outside the domain the end orientation, NaN for NaN.
  [[nodiscard]] Eigen::Quaternion<T> operator()(double t) const noexcept;

 private:
  template <class U>
  friend Expected<BakedCurve<U>> bake(const AnyCurve& curve, double tolerance, const BakeOptions& options,
                                      const Progress& progress);
  BakedCurve(Knots knots, std::vector<batch::BakedRecord<T>> pieces, double largest_difference)
      : knots_(std::move(knots)), pieces_(std::move(pieces)), largest_difference_(largest_difference) {}

  Knots knots_;
  std::vector<batch::BakedRecord<T>> pieces_;  ///< for a single key one that is constant
  double largest_difference_;
};

/// The least tolerance that can be asked for [rad].
template <class T>
inline constexpr double least_bake_tolerance = 1e-13;
template <>
inline constexpr double least_bake_tolerance<float> = 1e-6;

/// Bakes a curve so that no sample is farther from the curve's own than `tolerance` [rad]: twice the distance of the
/// two quaternions in R⁴, which is at least the angle between the orientations, and twice the error of the norm.
///
/// Segments are halved until that holds. It is checked, not proved: by samples of the piece itself at both ends and
/// wherever the error of an interpolation has its extremes when the next derivative varies little, with a reserve of a
/// factor of 2.
///
/// The rates of its samples are exact ones, of the orientations that its polynomials stand for. The tolerance does not
/// bound them: they differ from the curve's by some multiple of tolerance/h, tolerance/h² and tolerance/h³, h the
/// length of the piece, and at the ends of pieces they jump by as much. docs/performance.md has what was measured.
///
/// Errors: bad_argument for a tolerance that is not a number, infinite or below the least one, and for a segment, named
/// as the key, on which it cannot be reached, because the curve's own rounding or a jump is larger, or on which more
/// pieces would be needed than the options allow; cancelled.
template <class T = double>
[[nodiscard]] ORISPLINE_EXPORT Expected<BakedCurve<T>> bake(const AnyCurve& curve, double tolerance,
                                                            const BakeOptions& options = {},
                                                            const Progress& progress = {});

/// Bakes the method's curve through the keys in the same way. Errors: those above, and those of make_curve().
template <class T = double>
[[nodiscard]] ORISPLINE_EXPORT Expected<BakedCurve<T>> bake(const Method& method, const Keyframes& keys,
                                                            double tolerance, const BakeOptions& options = {},
                                                            const Progress& progress = {});

}}  // namespace orispline
