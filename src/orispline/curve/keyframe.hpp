// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/base/expected.hpp>
#include <orispline/math/eigen.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What stands for a rate that a key leaves free, so that a method chooses or estimates it there: three NaN.
[[nodiscard]] inline Eigen::Vector3d free_rate() noexcept {
  return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

[[nodiscard]] inline bool is_free(const Eigen::Vector3d& rate) noexcept { return rate.array().isNaN().all(); }

/// Whether some key has a rate: there are rates, and not all of them are free.
[[nodiscard]] inline bool any_given(std::span<const Eigen::Vector3d> rates) noexcept {
  return !std::ranges::all_of(rates, is_free);
}

/// What stands for an inner quaternion that a key leaves free, so that a method chooses it: four NaN.
[[nodiscard]] inline Eigen::Quaterniond free_inner() noexcept {
  return Eigen::Quaterniond(Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN()));
}

[[nodiscard]] inline bool is_free_inner(const Eigen::Quaterniond& inner) noexcept {
  return inner.coeffs().array().isNaN().all();
}

/// Whether some key has an inner quaternion: there are some, and not all of them are free.
[[nodiscard]] inline bool any_given(std::span<const Eigen::Quaterniond> inner) noexcept {
  return !std::ranges::all_of(inner, is_free_inner);
}

/// How the signs of the key quaternions are chosen; q and -q are the same orientation.
enum class Signs {
  shortest,  ///< key i is negated when its dot product with key i-1 (after its own flip) is negative
  as_given,  ///< the signs say which way round the motion goes, up to 2π per step
};

/// What the caller holds: one entry per key in every vector that is not empty. A rate may be free_rate(), three NaN, an
/// inner quaternion free_inner(), four.
struct KeyframeData {
  std::vector<double> times{};                           ///< [s], finite, strictly increasing but for `jumps`
  std::vector<Eigen::Quaterniond> orientations{};        ///< body to world, norm within 1e-3 of 1
  std::vector<Eigen::Vector3d> positions{};              ///< [m], optional
  std::vector<Eigen::Vector3d> angular_velocities{};     ///< [rad/s], body frame, optional
  std::vector<Eigen::Vector3d> angular_accelerations{};  ///< [rad/s²], body frame, optional
  std::vector<Eigen::Vector3d> angular_jerks{};          ///< [rad/s³], body frame, optional
  /// The control points aₙ of `squad` on the segment that leaves the key, body to world, norm within 1e-3 of 1,
  /// optional: docs/families/squad.md.
  std::vector<Eigen::Quaterniond> inner_leaving{};
  std::vector<Eigen::Quaterniond> inner_arriving{};  ///< those, bₙ, on the segment that arrives at it
  /// Two keys may have one time, where the motion jumps: a stretch ends there, and the next one begins. Of Keyframes,
  /// whether some have.
  bool jumps = false;
};

/// What validation changed or noticed.
struct KeyframeReport {
  std::size_t sign_flips = 0;       ///< steps whose two quaternions, as given, have a negative dot product
  std::size_t non_unit_keys = 0;    ///< keys whose norm was off by more than `unit_norm_tolerance`
  double largest_norm_error = 0.0;  ///< largest |‖q‖ - 1|
  /// Steps that turn by 180° but for `half_turn_margin`, where the signs are not as given: they may as well go the
  /// other way round.
  std::size_t near_half_turns = 0;
  std::size_t first_near_half_turn = 0;  ///< index of the key before the first of them

  friend bool operator==(const KeyframeReport&, const KeyframeReport&) = default;
};

/// How far from 180° such steps may be [rad].
inline constexpr double half_turn_margin = std::numbers::pi / 180.0;

/// Norms this near to 1 pass as unit: the rounding of float32 files.
inline constexpr double unit_norm_tolerance = 1e-6;
/// Norms farther than this from 1 are an error, not rounding.
inline constexpr double norm_error_limit = 1e-3 + 1e-12;  // 0.999 and 1.001 themselves pass

// Between these limits every method's curve and its rates are finite (docs/conventions.md, *Limits of keys*).

/// Steps between key times [s].
inline constexpr double shortest_step = 1e-18, longest_step = 1e18;
/// How many keys in a row a method may look at together, and how many times the shortest step between them the longest
/// may be.
inline constexpr std::size_t keys_seen_together = 7;
inline constexpr double widest_step_ratio = 1e14;
/// Components of positions [m], of rates of keys [rad/s], [rad/s²], [rad/s³], and of the rates of clamped ends.
inline constexpr double largest_component = 1e18;

/// Successive keys are at rest where they are no farther apart than this: rounding of files and of encoders [rad], [m].
inline constexpr double rest_angle = 1e-5, rest_length = 1e-6;

/// Orientations at times, validated at the door: every curve is built from these.
///
/// Times are finite and strictly increasing but where the motion jumps, orientations are unit quaternions with the
/// signs that the curve will follow, inner quaternions those with the sign that is nearer to their key.
class ORISPLINE_EXPORT Keyframes {
 public:
  /// No keys: size() is 0, all lists are empty. No curve goes through them.
  Keyframes() noexcept;
  // Moving copies, which is cheap: what was moved from keeps its keys.
  Keyframes(const Keyframes&) noexcept = default;
  Keyframes& operator=(const Keyframes&) noexcept = default;

  /// Validates, normalises, aligns the signs.
  ///
  /// Errors (bad_data, with the key index): no keys, vectors of different length, a time that is not finite or does not
  /// increase or steps out of range, steps too uneven, a component that is too large or not finite and not of a
  /// free rate or inner quaternion, a norm farther than `norm_error_limit` from 1.
  [[nodiscard]] static Expected<Keyframes> make(KeyframeData data, Signs signs = Signs::shortest);

  /// The first `count` of these keys, 1 ≤ count ≤ size().
  [[nodiscard]] Keyframes first(std::size_t count) const;

  /// Whether the body stands still from key i to the next, position and all: they are no farther apart than
  /// `rest_angle` and `rest_length`. Precondition: i + 1 < size().
  [[nodiscard]] bool rests_after(std::size_t i) const;
  /// The keys after which the body rests, in order.
  [[nodiscard]] std::vector<std::size_t> rests() const;

  /// The keys at these rising indices, at least one, with their signs aligned anew for the shortest way.
  [[nodiscard]] Keyframes at(std::span<const std::size_t> indices) const;

  /// These keys at other times [s].
  ///
  /// Errors (bad_data): not one time per key; times that Keyframes::make() refuses.
  [[nodiscard]] Expected<Keyframes> with_times(std::vector<double> times) const;

  /// These keys with angular rates of theirs, such as smoothed ones; an empty vector takes away those that were there.
  ///
  /// Errors (bad_data): not one rate per key, or one that Keyframes::make() refuses.
  [[nodiscard]] Expected<Keyframes> with_rates(std::vector<Eigen::Vector3d> angular_velocities,
                                               std::vector<Eigen::Vector3d> angular_accelerations = {},
                                               std::vector<Eigen::Vector3d> angular_jerks = {}) const;

  /// All that they hold, as it was checked: what make() takes for the same keys, with Signs::as_given.
  [[nodiscard]] const KeyframeData& data() const noexcept { return *data_; }
  [[nodiscard]] std::size_t size() const noexcept { return data_->times.size(); }
  [[nodiscard]] std::span<const double> times() const noexcept { return data_->times; }
  [[nodiscard]] std::span<const Eigen::Quaterniond> orientations() const noexcept { return data_->orientations; }
  /// Empty when the keys carry no positions.
  [[nodiscard]] std::span<const Eigen::Vector3d> positions() const noexcept { return data_->positions; }
  /// The orientations or the positions.
  template <CurvePoint P>
  [[nodiscard]] std::span<const P> points() const noexcept {
    if constexpr (std::same_as<P, Eigen::Quaterniond>) return orientations();
    else return positions();
  }
  /// Empty when the keys carry no angular velocities. [rad/s], body frame.
  [[nodiscard]] std::span<const Eigen::Vector3d> angular_velocities() const noexcept {
    return data_->angular_velocities;
  }
  /// Empty when the keys carry no angular accelerations. [rad/s²], body frame.
  [[nodiscard]] std::span<const Eigen::Vector3d> angular_accelerations() const noexcept {
    return data_->angular_accelerations;
  }
  /// Empty when the keys carry no angular jerks. [rad/s³], body frame.
  [[nodiscard]] std::span<const Eigen::Vector3d> angular_jerks() const noexcept { return data_->angular_jerks; }
  /// Empty when the keys carry no inner quaternions for the segments that leave them.
  [[nodiscard]] std::span<const Eigen::Quaterniond> inner_leaving() const noexcept { return data_->inner_leaving; }
  /// Empty when the keys carry no inner quaternions for the segments that arrive at them.
  [[nodiscard]] std::span<const Eigen::Quaterniond> inner_arriving() const noexcept { return data_->inner_arriving; }
  /// Whether some of them are not free.
  [[nodiscard]] bool have_inner_quaternions() const noexcept {
    return any_given(inner_leaving()) || any_given(inner_arriving());
  }
  [[nodiscard]] const KeyframeReport& report() const noexcept { return report_; }

 private:
  /// These keys with other data, which are known to be good.
  [[nodiscard]] Keyframes with(KeyframeData data) const;

  std::shared_ptr<const KeyframeData> data_;  // never null; immutable: copies share it
  KeyframeReport report_;
};

}}  // namespace orispline
