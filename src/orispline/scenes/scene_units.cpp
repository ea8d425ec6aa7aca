// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/scene_units.hpp>

#include <cmath>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

Expected<Scene> in_metres(Scene scene, double metres) {
  if (!(std::isfinite(metres) && metres > 0.0))
    return bad_option("position_scale", formatted("found {}, wanted a number above 0", metres));
  if (!scene.format || !scene.format->has_no_unit)
    return bad_option("position_scale",
                      formatted("found {}, whose lengths are in metres, wanted a file without a unit, such as BVH",
                                scene.format ? scene.format->file : "keys"));
  std::vector<Joint> joints(scene.skeleton.joints().begin(), scene.skeleton.joints().end());
  for (Joint& joint : joints) joint.rest.translation *= metres;
  for (Clip& clip : scene.clips)
    for (VectorChannel& channel : clip.translations)
      for (SharedList<Eigen::Vector3d>* const list : {&channel.values, &channel.in_tangents, &channel.out_tangents})
        for (std::size_t key = 0; key < list->size(); ++key) (*list)[key] *= metres;
  return Skeleton::make(std::move(joints)).map([&](Skeleton skeleton) {
    scene.skeleton = std::move(skeleton);
    return std::move(scene);
  });
}

}}}  // namespace orispline::scenes
