// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

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

}}  // namespace orispline
