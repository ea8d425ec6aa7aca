// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/scenes/bvh/source.hpp>
#include <orispline/scenes/bvh/turns.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// When the frames of a file are.
struct Frames {
  Decimal frame_time{};         ///< [s]
  std::vector<double> times{};  ///< of the clip [s], one at least; a key that belongs to a frame has its very time
};

/// Frames at the rate that is asked for, else at the even grid on which all keys lie within the rounding of their times
/// to `float`. The source, where there is one, says which of the frame times within that rounding is meant.
///
/// Errors: bad_data for keys on no such grid; bad_argument for the rate.
[[nodiscard]] Expected<Frames> frames_of(const Clip& clip, const SceneWriting& writing, const Source* source);

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

/// The numbers of a joint in all frames, one frame after the other.
struct JointNumbers {
  std::vector<Column> columns{};
  std::vector<double> numbers{};
  std::vector<std::size_t> near_lock{};  ///< frames whose angles were found within 1° of gimbal lock
  Detour detour{};                       ///< of angles that were found
};

/// Which angles of a source are kept where a joint turns as it did there.
enum class SourceAngles {
  all,
  without_jumps,  ///< those that run on from frame to frame
};

/// Finds the numbers that say where the joints of a clip are.
class NumberFinder {
 public:
  /// All are kept by reference; the source may be null.
  NumberFinder(const Skeleton& skeleton, const Clip& clip, const Frames& frames, const Source* source,
               SourceAngles kept);

  /// With the columns that are planned, or more where these cannot say it. A joint that turns as in the source keeps
  /// the angles of the source; `order` is for those that need three turns. Error (bad_data): a rotation that is none.
  [[nodiscard]] Expected<JointNumbers> of(const PlannedJoint& planned, const EulerOrder& order) const;

 private:
  struct Track;

  [[nodiscard]] Expected<Track> track_of(std::size_t joint) const;
  [[nodiscard]] JointNumbers turns_of(const PlannedJoint& planned, const Track& track, const EulerOrder& order) const;
  [[nodiscard]] std::vector<double> source_angles(std::size_t joint, const Track& track) const;

  const Skeleton& skeleton_;
  const Clip& clip_;
  const Frames& frames_;
  const Source* source_;
  SourceAngles kept_;
  std::vector<const RotationChannel*> rotations_;   // by their joints
  std::vector<const VectorChannel*> translations_;  // by their joints
  std::vector<std::size_t> first_columns_;          // of the joints in a frame of the source
};

/// A file with the one clip of the scene. Errors: bad_data for a scene without a joint, with another number of clips or
/// with keys at uneven times; bad_argument for the options.
[[nodiscard]] Expected<SceneWritten> write(const Scene& scene, const std::string& path, const SceneWriting& writing);

}}}  // namespace orispline::scenes::bvh
