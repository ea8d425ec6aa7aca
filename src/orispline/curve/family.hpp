// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/base/expect.hpp>
#include <orispline/base/expected.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a family uses the keys of a curve, beyond passing through all of them and blending its neighbours.
struct KeyUse {
  std::size_t first = 0;              ///< the curve begins at this key's time and ends as many keys before the last
  std::size_t stride = 1;             ///< keys from one joint to the next; the curve passes through these at least
  std::size_t further_times = 0;      ///< times on either side that a segment depends on beyond those of its keys
  bool parameters_reach_far = false;  ///< a parameter acts on every segment that its key acts on, not on two only
  bool feels_times = true;            ///< else the key times stretch segments that are formed without them
  double widest_turn = 10.0;  ///< between keys at uneven times [rad]: wider ones lead astray or may not converge
  int smoothest_with_parameters = 9;  ///< order of continuity that parameters other than the default ones leave

  /// Keys for a curve of that many segments.
  [[nodiscard]] constexpr std::size_t keys_for(std::size_t segments) const noexcept {
    return 2 * first + stride * segments + 1;
  }
  /// The largest number of keys that a curve takes, up to `keys`, which are enough for a segment.
  [[nodiscard]] constexpr std::size_t cut(std::size_t keys) const noexcept {
    return keys_for((keys - 2 * first - 1) / stride);
  }
};

/// A number that shapes a family's curves.
struct Parameter {
  std::string_view name;
  double initial;          ///< used when the caller says nothing
  double lowest, highest;  ///< allowed range, inclusive
  bool per_key = true;     ///< one value for all keys or one per key; else one value only
  int ghosts = 0;  ///< keys beyond either end that may be given values of their own, before and after the others
  bool tunable = false;
  bool tensor = false;         ///< or a symmetric matrix in the body frame: its diagonal, or that and xy, xz, yz
  bool rests_at_zero = false;  ///< at 0 the body rests at the key, where the path may have a corner
};

/// One whose values tuning can choose.
[[nodiscard]] constexpr Parameter tunable(Parameter parameter) {
  parameter.tunable = true;
  return parameter;
}

/// One that is the share of the rate at its key.
[[nodiscard]] constexpr Parameter resting_at_zero(Parameter parameter) {
  parameter.rests_at_zero = true;
  return parameter;
}

/// One that may be a symmetric matrix; one value is that multiple of the identity.
[[nodiscard]] constexpr Parameter tensor(Parameter parameter) {
  parameter.tensor = true;
  return parameter;
}

/// A choice between words that shapes a family's curves.
struct Choice {
  std::string_view name;
  std::span<const std::string_view> words;  ///< the first is the default
};

/// How a curve begins or ends, where its formula asks for a key beyond the last one.
enum class EndRule {
  none,       ///< the family needs no rule
  repeat,     ///< the end key once more (Tan 2018, Definition 1)
  natural,    ///< the last increment continued: no angular acceleration at the end
  quadratic,  ///< extrapolated through 3 keys
  cubic,      ///< extrapolated through 4 keys
  clamped,    ///< the given end rate
  rest,       ///< clamped at zero rate
  key,        ///< squad: the end's inner quaternion is the key itself
  phantom,    ///< squad: the end key repeated in the formula of the inner quaternion
  reflect,    ///< the last increment continued at the mirrored time
  handle,     ///< the end's Bézier handle points at the middle of the next one: no angular acceleration at the end
  secant,     ///< the rate of the end's increment
};

[[nodiscard]] ORISPLINE_EXPORT std::string_view name_of(EndRule rule) noexcept;

/// How many keys a rule extrapolates from, at least two.
[[nodiscard]] ORISPLINE_EXPORT std::size_t keys_needed(EndRule rule) noexcept;

/// For FamilyInfo::support_keys: a segment depends on every key, because the curve solves equations over all of them.
inline constexpr int all_keys = 0;

struct FamilySettings;
class OwnFamily;

/// What a family says about itself: all that is known of it elsewhere. Continuity is the order in **time** for non-zero
/// tensions; constant rates are kept at the default parameters, with natural ends where the family has them.
struct FamilyInfo {
  std::string_view name;     ///< that it is chosen by, as in make_curve
  std::string_view alias{};  ///< a former name, taken for it too
  std::string_view title;
  std::string_view source;     ///< paper and equation, or the section of our own derivation
  bool interpolates = true;    ///< passes through every key
  int continuity_uniform = 0;  ///< on evenly spaced key times
  int continuity_uneven = 0;   ///< on any key times
  /// Order of the shape (G^k), whatever the speed, on any key times and where the body moves at a key.
  /// Absent: that in time on even ones, which is what it is where uneven times only change the speed.
  std::optional<int> continuity_of_shape{};
  bool keeps_constant_rate_uniform = false;  ///< equal increments on even times give constant ω
  bool keeps_constant_rate_uneven = false;   ///< a constant rate on uneven times stays constant
  int support_keys = 2;                      ///< keys whose orientations one segment depends on, or all_keys
  int min_keys = 2;                          ///< fewer are an error (one key is always a constant curve)
  std::span<const Parameter> parameters{};
  std::span<const Choice> choices{};
  std::span<const EndRule> ends{};  ///< the first is the default; empty: no choice
  bool closes = false;              ///< can be a loop
  int rate_orders = 0;  ///< rates of the keys that it uses where they have them: 1 is ω, 2 also α, 3 also the jerk
  /// That it uses inner quaternions of the keys where they have them, and the order of continuity, in time and of the
  /// shape, that those leave. Absent: it uses none.
  std::optional<int> order_with_inner_quaternions{};
  KeyUse key_use{};
  /// Where settings change what a segment depends on: the keys on either side, or none for all. Null: as above.
  std::optional<std::size_t> (*keys_beside)(const FamilySettings& settings) = nullptr;
  const OwnFamily* own = nullptr;  ///< what it is of, where it is not in the registry

  [[nodiscard]] constexpr int shape_order() const noexcept { return continuity_of_shape.value_or(continuity_uniform); }
  [[nodiscard]] constexpr bool takes_inner_quaternions() const noexcept {
    return order_with_inner_quaternions.has_value();
  }
  [[nodiscard]] constexpr bool is_global() const noexcept { return support_keys == all_keys; }
  [[nodiscard]] constexpr bool passes_through(std::size_t key) const noexcept {
    return interpolates || (key_use.stride > 1 && key % key_use.stride == 0);
  }
  /// Keys whose orientations a segment of a local family depends on, on either side of those that it joins.
  [[nodiscard]] constexpr std::size_t reach() const noexcept {
    return (static_cast<std::size_t>(support_keys) - 1 - key_use.stride) / 2;
  }
};

/// One end of a curve.
struct End {
  EndRule rule = EndRule::none;                                ///< none: the family's default
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< for clamped [rad/s], body frame
};

/// A loop: after the last key the curve returns to the first one.
struct Loop {
  /// Time from the first key to its return [s]. Absent: the last key must be the first one again and closes the loop.
  std::optional<double> period{};
};

/// What the caller may say to any family.
struct CurveOptions {
  /// Values by parameter name: one for all keys, or exactly one per key. Absent: the family's default.
  std::map<std::string, std::vector<double>, std::less<>> parameters{};
  /// Words by the name of the choice. Absent: its first word.
  std::map<std::string, std::string, std::less<>> choices{};
  End start{};
  End end{};
  std::optional<Loop> loop{};  ///< absent: an open curve with two ends
};

/// A parameter's values, one for all keys or one per key. Immutable; copies share them.
class PerKey {
 public:
  explicit PerKey(std::vector<double> values)
      : values_(std::make_shared<const std::vector<double>>(std::move(values))) {}
  // Moving copies, which is cheap: what was moved from keeps its values.
  PerKey(const PerKey&) noexcept = default;
  PerKey& operator=(const PerKey&) noexcept = default;
  [[nodiscard]] double operator[](std::size_t key) const noexcept { return (*values_)[values_->size() == 1 ? 0 : key]; }
  [[nodiscard]] const std::vector<double>& values() const noexcept { return *values_; }
  /// The values of that many keys.
  [[nodiscard]] std::vector<double> all(std::size_t keys) const {
    return values_->size() == 1 ? std::vector(keys, values_->front()) : *values_;
  }
  /// Those of that many keys and of a ghost key beyond either end, which has its neighbour's unless it has its own.
  [[nodiscard]] std::vector<double> all_with_ghosts(std::size_t keys) const {
    std::vector<double> values = all(keys);
    if (values.size() == keys + 2) return values;
    values.insert(values.begin(), values.front());
    values.push_back(values.back());
    return values;
  }

 private:
  std::shared_ptr<const std::vector<double>> values_;
};

/// How a loop closes: the curve after one period is `sign` times the curve, +1 or -1.
struct Closure {
  double period;  ///< [s]
  double sign;
};

/// Options completed and checked against a family: every parameter present, the ends chosen.
struct ORISPLINE_EXPORT FamilySettings {
  std::string_view method{};  ///< the family's name
  std::map<std::string, PerKey, std::less<>> parameters{};
  std::map<std::string_view, std::string_view> choices{};
  End start{};
  End end{};
  std::optional<Closure> closure{};  ///< of a loop

  /// The values of one of the family's own parameters.
  [[nodiscard]] PerKey per_key(std::string_view name) const {
    const auto found = parameters.find(name);
    ORISPLINE_EXPECT(found != parameters.end());
    return found->second;
  }

  /// The word of one of the family's own choices.
  [[nodiscard]] std::string_view choice(std::string_view name) const {
    const auto found = choices.find(name);
    ORISPLINE_EXPECT(found != choices.end());
    return found->second;
  }

  /// A parameter that must be a whole number, such as a degree or an order; else bad_argument.
  [[nodiscard]] Expected<int> whole(std::string_view name) const;
};

/// Whether a list of parameters or choices has one of that name.
template <class Named>
[[nodiscard]] bool has_name(std::span<const Named> list, std::string_view name) {
  return std::ranges::find(list, name, &Named::name) != list.end();
}

/// The error with its place: the key of the value at that index, or in words the ghost key, which has no index.
///
/// There are as many values as keys, or those of ghost keys before and after them as well.
[[nodiscard]] ORISPLINE_EXPORT Error at_value(Error error, std::size_t value, std::size_t values, std::size_t keys);

/// Checks the options against what the family accepts and fills in its defaults.
///
/// Errors: bad_argument (with the key index where one value is at fault) for an unknown parameter or word, a wrong
/// number of values, a value out of range or not finite, an unknown end rule, an end rate out of range; bad_data for
/// too few keys for the family or the rule.
[[nodiscard]] ORISPLINE_EXPORT Expected<FamilySettings> settle(const FamilyInfo& family, const CurveOptions& options,
                                                               std::size_t keys);

/// Keys on either side of those that a segment joins which a curve must go through to have the bits of the whole one
/// there. Absent: all keys, for then equations over them are solved.
[[nodiscard]] ORISPLINE_EXPORT std::optional<std::size_t> keys_beside(const FamilyInfo& family,
                                                                      const FamilySettings& settings);

/// The end rule of that name, or an error that lists those of the family.
[[nodiscard]] ORISPLINE_EXPORT Expected<EndRule> end_rule_by_name(const FamilyInfo& family, std::string_view name);

}}  // namespace orispline
