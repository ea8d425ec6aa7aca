// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/scenes/bvh_frames.hpp>
#include <orispline/scenes/bvh_plan.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// The numbers of a joint in all frames, one frame after the other.
struct JointNumbers {
  std::vector<Column> columns{};
  std::vector<double> numbers{};
  std::vector<std::size_t> near_lock{};  ///< frames whose angles were found within 1° of gimbal lock
};

/// Finds the numbers that say where the joints of a clip are.
class NumberFinder {
 public:
  /// All are kept by reference; the source may be null.
  NumberFinder(const Skeleton& skeleton, const Clip& clip, const Frames& frames, const Source* source);

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
  std::vector<const RotationChannel*> rotations_;   // by their joints
  std::vector<const VectorChannel*> translations_;  // likewise
  std::vector<std::size_t> first_columns_;          // of the joints in a frame of the source
};

}}}  // namespace orispline::scenes::bvh
