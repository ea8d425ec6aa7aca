// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/scene_units.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

Expected<Scene> in_metres(const Scene& scene, double metres) {
  return orispline::in_metres(motion_file_of(scene), metres).map([&](const MotionFile& made) {
    return with_motion(scene, made);
  });
}

}}}  // namespace orispline::scenes
