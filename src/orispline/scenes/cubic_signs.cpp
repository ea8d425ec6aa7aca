// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/cubic_signs.hpp>

#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

namespace {

bool goes_the_long_way(const RotationChannel& channel, std::size_t key) {
  return channel.values[key - 1].dot(channel.values[key]) < 0.0;
}

/// Whether nobody can have meant that: by more than 270°, where the other sign turns by less than 90°, and the tangents
/// lead the other way.
bool is_a_flip(const RotationChannel& channel, std::size_t key) {
  constexpr double cosine_of_the_way = -0.70710678118654752;
  const Eigen::Vector4d from = channel.values[key - 1].coeffs(), to = channel.values[key].coeffs();
  const Eigen::Vector4d leaving = channel.out_tangents[key - 1].coeffs(), arriving = channel.in_tangents[key].coeffs();
  const double cosine = from.dot(to);
  const double along = leaving.dot(to - cosine * from) - arriving.dot(from - cosine * to);
  return cosine < cosine_of_the_way && along <= 0.0;
}

void give_the_other_sign(RotationChannel& channel, std::size_t key) {
  for (SharedList<Eigen::Quaterniond>* const list : {&channel.values, &channel.in_tangents, &channel.out_tangents})
    (*list)[key].coeffs() *= -1.0;
}

}  // namespace

Scene with_cubic_signs(Scene scene, std::optional<Signs> signs) {
  if (signs == Signs::as_given) return scene;
  std::size_t steps = 0, first_key = 0;
  std::string first;
  for (Clip& clip : scene.clips)
    for (RotationChannel& channel : clip.rotations) {
      if (channel.interpolation != ChannelInterpolation::cubicspline) continue;
      for (std::size_t key = 1; key < channel.size(); ++key) {
        if (!goes_the_long_way(std::as_const(channel), key)) continue;
        if (signs) give_the_other_sign(channel, key);
        else if (is_a_flip(std::as_const(channel), key) && steps++ == 0)
          first = place_of(scene.skeleton, clip, channel.joint), first_key = key;
      }
    }
  if (steps > 0)
    scene.warnings.push_back(
        {.code = "cubic_signs",
         .message =
             formatted("{}: {} of cubic rotations, the first from key {}, {} the long way round, as the signs of "
                       "the quaternions say; if the short way is meant, set `signs` to shortest",
                       first, counted(steps, "step"), first_key - 1, steps == 1 ? "goes" : "go"),
         .where = {.file = scene.name, .key = first_key},
         .numbers = {{"steps", static_cast<double>(steps)}}});
  return scene;
}

}}}  // namespace orispline::scenes
