// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orispline/curve/curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A family of curves that is not in the registry: one of one's own, held by the methods that are of it. Immutable, and
/// safe to share between threads.
class ORISPLINE_EXPORT OwnFamily : public std::enable_shared_from_this<OwnFamily> {
 public:
  OwnFamily() = default;
  OwnFamily(const OwnFamily&) = delete;
  OwnFamily& operator=(const OwnFamily&) = delete;
  virtual ~OwnFamily();

  /// What it says about itself; `own` is this family.
  [[nodiscard]] virtual const FamilyInfo& info() const noexcept = 0;
  /// The curve through at least two keys, of settings that were settled for them.
  [[nodiscard]] virtual Expected<AnyCurve> curve(const Keyframes& keys, const FamilySettings& settings) const = 0;
  /// The path through the positions of such keys.
  [[nodiscard]] virtual Expected<AnyPath> path(const Keyframes& keys, const FamilySettings& settings) const = 0;
};

/// What the rows of a family of one's own are coefficients of.
enum class BlendingBasis {
  bernstein,  ///< cumulative blending functions, one an increment, in the Bernstein basis
  power,      ///< the same as coefficients of 1, u, u², …
  bezier,     ///< blending functions of the control points themselves, in the Bernstein basis; they sum to 1
};

/// A number that shapes the curves of a family of one's own, with one value for all keys or one per key.
struct BlendingParameter {
  std::string name;
  double initial = 0.0;
  double lowest = -100.0, highest = 100.0;  ///< allowed range, inclusive

  bool operator==(const BlendingParameter&) const = default;
};

/// A family of curves stated as data: blending functions with parameters, q(u) = q₀ ∏ exp(β̃_k(u) φ_k), u from 0 to 1
/// on each segment. docs/own-blending.md.
struct BlendingData {
  std::string name;   ///< small letters, digits and `-`
  std::string title;  ///< a line for people
  std::vector<BlendingParameter> parameters{};
  /// A polynomial each, one an increment (1 to 5); a coefficient is an expression in the parameters `a`, `b`, … at the
  /// keys before and behind the segment and in the lengths `h`, … of intervals.
  std::vector<std::vector<std::string>> rows{};
  std::optional<int> first{};   ///< where the increments begin, 0 being the segment's own; absent: they are symmetric
  std::string ends = "repeat";  ///< the end rule that is used where none is named
  BlendingBasis basis = BlendingBasis::bernstein;

  bool operator==(const BlendingData&) const = default;
};

}}  // namespace orispline
