// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/skeleton.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Expected<void> check(const std::vector<Joint>& joints, std::size_t i) {
  const Joint& joint = joints[i];
  const auto fault = [&](std::string_view found, std::string_view wanted) {
    return failure(ErrorCode::bad_data,
                   formatted("joint {}: found {}, wanted {}", in_quotes(joint.name), found, wanted));
  };
  if (joint.parent != no_parent && joint.parent >= i)
    return fault(formatted("joint {} as its parent", joint.parent), "a parent that comes before it");
  if (!joint.rest.translation.allFinite() || !joint.rest.scale.allFinite() || !joint.rest.rotation.coeffs().allFinite())
    return fault("a rest pose with a number that is not finite", "finite numbers");
  if (const double norm = joint.rest.rotation.norm(); std::abs(norm - 1.0) > unit_norm_tolerance)
    return fault(formatted("a rest rotation of norm {}", norm), "a unit quaternion");
  return {};
}

}  // namespace

Expected<Skeleton> Skeleton::make(std::vector<Joint> joints) {
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (auto sound = check(joints, i); !sound) return tl::unexpected(std::move(sound.error()));
  for (Joint& joint : joints) joint.rest.rotation.normalize();
  return Skeleton(std::move(joints));
}

std::optional<std::size_t> Skeleton::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(joints_, name, &Joint::name);
  if (found == joints_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - joints_.begin());
}

}}  // namespace orispline
