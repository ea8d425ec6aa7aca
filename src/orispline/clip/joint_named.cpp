// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/joint_named.hpp>

#include <algorithm>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/base/suggestion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Whether names with a `/` between them end at a joint and lead down to it.
bool leads_to(const Skeleton& skeleton, std::string_view path, std::size_t joint) {
  for (; joint != no_parent; joint = skeleton[joint].parent) {
    const std::string& name = skeleton[joint].name;
    if (path == name) return true;
    if (!path.ends_with(name)) return false;
    path.remove_suffix(name.size());
    if (!path.ends_with('/')) return false;
    path.remove_suffix(1);
  }
  return false;
}

std::vector<std::size_t> joints_of(const Skeleton& skeleton, std::string_view path) {
  constexpr std::string_view left_out = "…/";  // of a shown name
  if (path.starts_with(left_out)) path.remove_prefix(left_out.size());
  std::vector<std::size_t> joints;
  for (std::size_t joint = 0; joint < skeleton.size(); ++joint)
    if (leads_to(skeleton, path, joint)) joints.push_back(joint);
  return joints;
}

}  // namespace

Expected<std::size_t> joint_named(const Skeleton& skeleton, std::string_view name) {
  const std::vector<std::size_t> joints = joints_of(skeleton, name);
  if (joints.size() == 1) return joints.front();
  std::vector<std::string> shown, shown_names;
  for (const std::size_t joint : joints) {
    shown_names.push_back(skeleton.shown_name(joint));
    shown.push_back(in_quotes(shown_names.back()));
  }
  const bool tell_apart =
      std::ranges::all_of(shown_names, [&](const std::string& path) { return joints_of(skeleton, path).size() == 1; });
  if (!joints.empty())
    return failure(ErrorCode::bad_data,
                   formatted("found {} joints named {}, wanted {}", joints.size(), in_quotes(name),
                             tell_apart ? "one of " + joined(shown, ", ") : "a name of its own for each"));
  std::vector<std::string_view> names;
  for (const Joint& joint : skeleton.joints()) names.push_back(joint.name);
  const auto near = nearest_word(name, names);
  return failure(ErrorCode::bad_data, formatted("found {}, wanted the name of a joint{}", in_quotes(name),
                                                near ? "; did you mean " + in_quotes(*near) + "?" : ""));
}

}}  // namespace orispline
