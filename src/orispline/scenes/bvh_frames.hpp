// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/scenes/bvh_source.hpp>
#include <orispline/scenes/scene_format.hpp>

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

}}}  // namespace orispline::scenes::bvh
