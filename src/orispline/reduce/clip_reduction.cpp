// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/clip_reduction.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/clip/single_precision.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/reduce/clip_search.hpp>
#include <orispline/reduce/hermite_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Clip as_stored(Clip clip, const ClipReduceOptions& options) {
  if (options.precision == options.precision_before || options.precision == KeyPrecision::float64) return clip;
  const auto store = [](auto& channels) {
    for (auto& channel : channels)
      if (channel.interpolation != ChannelInterpolation::step) channel = in_single_precision(channel);
  };
  store(clip.rotations), store(clip.translations), store(clip.scales);
  return clip;
}

namespace {

constexpr double widest_angle = std::numbers::pi * (1.0 + 1e-12);  // [rad], and the rounding of degrees
/// Of so many clips each has a thread; of fewer the channels of each are shared out.
constexpr std::size_t many_clips = 8;

}  // namespace

Expected<void> check(const ClipReduceOptions& options) {
  for (const double tolerance : {options.tolerance, options.position_tolerance, options.world_tolerance, options.shell})
    if (!(tolerance > 0.0))
      return failure(ErrorCode::bad_argument,
                     formatted("found a tolerance of {}, wanted one greater than 0", tolerance));
  if (std::isfinite(options.tolerance) && options.tolerance > widest_angle)
    return bad_option("tolerance",
                      formatted("found {:.6g}°, wanted 180° at most, which is as far as rotations can be apart",
                                options.tolerance * degrees));
  if (auto known = check(options.compression); !known) return known;
  if (options.next_tool == NextTool::meshopt && options.method.name != "slerp" &&
      options.method.name != smallest_method)
    return bad_option("for",
                      formatted("found the method {}, whose splines of rotations gltf-transform's meshopt breaks, "
                                "wanted slerp or {}",
                                text_of(options.method), smallest_method));
  if (options.closed && options.method.name != cubicspline_method && !seeks_rates(options.method))
    return bad_option("closed",
                      formatted("found the method {}, wanted {}, or {} in its form chart: their tangents are free",
                                text_of(options.method), cubicspline_method, "hermite-c1"));
  return {};
}

Expected<std::vector<ClipReduction>> reduce_clips(const Skeleton& skeleton, std::span<const Clip> clips,
                                                  const ClipReduceOptions& options, unsigned threads) {
  if (auto sound = check(options); !sound) return tl::unexpected(std::move(sound.error()));
  for (const Clip& clip : clips)
    if (auto sound = check_clip(skeleton, clip); !sound) return tl::unexpected(std::move(sound.error()));
  const bool are_many = clips.size() >= many_clips;
  std::vector<std::optional<Expected<ClipReduction>>> found(clips.size());
  parallel_for(clips.size(), are_many ? threads : 1, [&](std::size_t i) {
    found[i] = clip_with_fewest_keys(skeleton, clips[i], options, are_many ? 1 : threads);
  });
  std::vector<ClipReduction> reductions;
  for (auto& reduction : found) {
    if (!*reduction) return tl::unexpected(std::move(reduction->error()));
    reductions.push_back(**std::move(reduction));
  }
  return reductions;
}

}}  // namespace orispline
