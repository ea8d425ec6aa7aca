// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/scenes/bvh_source.hpp>
#include <orispline/scenes/scene_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// A joint of a file that is to be written.
struct PlannedJoint {
  std::string name{};
  std::size_t depth = 0;          ///< 0 for a ROOT
  std::size_t joint = no_parent;  ///< of the skeleton; `no_parent` for one that only the file has
  WrittenJoint written{};         ///< with the columns that it should have
};

/// Joints in the order of the file.
using Plan = std::vector<PlannedJoint>;

/// The joints as the source had them.
[[nodiscard]] Plan plan_of(const Source& source);
/// Those that are animated, with all above and below them, or all where none is. Error (bad_data): nested too deep.
[[nodiscard]] Expected<Plan> plan_of(const Skeleton& skeleton, const Clip& clip, const EulerOrder& order);

/// The columns of three turns.
[[nodiscard]] std::vector<Column> columns_of(const EulerOrder& order);
/// The columns of a position.
[[nodiscard]] std::vector<Column> position_columns();

/// The text of a hierarchy.
struct HierarchyText {
  std::string text{};
  std::size_t renamed = 0;  ///< joints whose names BVH cannot hold
};
[[nodiscard]] HierarchyText text_of(const Plan& plan, std::string_view line_end);

}}}  // namespace orispline::scenes::bvh
