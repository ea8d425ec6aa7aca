// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/motion_file.hpp>

#include <cmath>
#include <utility>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Expected<void> check_metres(const ClipFormat& format, double metres) {
  if (!(std::isfinite(metres) && metres > 0.0))
    return bad_option("position_scale", formatted("found {}, wanted a number above 0", metres));
  if (!format.has_no_unit)
    return bad_option("position_scale",
                      formatted("found {}, whose lengths are in metres, wanted a file without a unit, such as BVH",
                                format.file.empty() ? "keys" : format.file));
  return {};
}

Expected<MotionFile> in_metres(MotionFile file, double metres) {
  if (auto sound = check_metres(file.format, metres); !sound) return tl::unexpected(std::move(sound.error()));
  std::vector<Joint> joints(file.skeleton.joints().begin(), file.skeleton.joints().end());
  for (Joint& joint : joints) joint.rest.translation *= metres;
  for (Clip& clip : file.clips)
    for (VectorChannel& channel : clip.translations)
      for (SharedList<Eigen::Vector3d>* const list : {&channel.values, &channel.in_tangents, &channel.out_tangents})
        for (std::size_t key = 0; key < list->size(); ++key) (*list)[key] *= metres;
  return Skeleton::make(std::move(joints)).map([&](Skeleton skeleton) {
    file.skeleton = std::move(skeleton);
    file.format.has_no_unit = false;
    return std::move(file);
  });
}

}}  // namespace orispline
