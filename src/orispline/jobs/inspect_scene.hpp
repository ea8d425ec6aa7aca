// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/edit/seam.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/jobs/difference.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct SkeletonPage;
}
namespace pages {
struct PageHead;
}

namespace jobs {

/// How much there is in a scene, or in one of its clips.
struct SceneCounts {
  std::size_t rotation_tracks = 0, rotation_keys = 0, constant_rotation_tracks = 0;
  std::size_t translation_tracks = 0, translation_keys = 0;
  std::size_t scale_tracks = 0, scale_keys = 0;
  std::size_t sign_flips = 0;       ///< steps of rotations whose two quaternions have a negative dot product
  double widest_step = 0.0;         ///< of rotations, from key to key [rad]
  std::string widest_step_joint{};  ///< its joint
  double widest_step_time = 0.0;    ///< of the key before it [s]
};

[[nodiscard]] ORISPLINE_EXPORT SceneCounts counts_of(const Skeleton& skeleton, std::span<const Clip> clips);
[[nodiscard]] ORISPLINE_EXPORT Json json_of(const SceneCounts& counts);

struct InspectSceneRequest {
  MotionFile file{};
};

/// What a file of skeletons holds.
struct InspectSceneOutcome {
  InspectSceneRequest request;
  SceneCounts counts{};
  std::vector<SceneCounts> clips{};  ///< of each
  std::vector<ClipSeam> seams{};     ///< of each
};

[[nodiscard]] ORISPLINE_EXPORT InspectSceneOutcome inspect_scene(InspectSceneRequest request);

/// Described in docs/skeletons.md, but for the file and its format.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const InspectSceneOutcome& outcome);
/// A page for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const InspectSceneOutcome& outcome);
/// With ORISPLINE_PAGE: the skeleton as the clips move it.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage page_of(const InspectSceneOutcome& outcome,
                                                            const pages::PageHead& head);

}  // namespace jobs

}}  // namespace orispline
