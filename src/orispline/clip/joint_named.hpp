// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <orispline/base/expected.hpp>
#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The joint that a name means. Where several have that name, the names of joints above it with a `/` tell them apart,
/// as Skeleton::shown_name() writes them: `Armature/Bone`.
///
/// Errors (bad_data): no such joint, with a name that is near; several, with what tells them apart.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::size_t> joint_named(const Skeleton& skeleton, std::string_view name);

}}  // namespace orispline
