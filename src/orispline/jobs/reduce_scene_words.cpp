// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::string_view length_unit(const ReduceSceneOutcome& outcome) { return outcome.knows_metres() ? " m" : ""; }

std::string worst_place(const ReduceSceneOutcome& outcome, const ClipReduction& reduction,
                        const ClipReduction::Worst& worst) {
  return formatted("{}, at {:.6g} s", orispline::place_of(outcome.request.skeleton, reduction.clip, worst.joint),
                   worst.largest.time);
}

/// `rotation of joint 'hips' of clip 'run' (7.8°)`
std::string open_text(const ReduceSceneOutcome& outcome, const ClipReduction& reduction,
                      const ClipReduction::OpenTrack& track) {
  return formatted("{} of {} ({:.4g}{})", track.is_rotation ? "rotation" : "translation",
                   orispline::place_of(outcome.request.skeleton, reduction.clip, track.joint),
                   track.apart * (track.is_rotation ? degrees : outcome.metres()),
                   track.is_rotation ? "°" : length_unit(outcome));
}

/// With the tracks that stay open, of many the first few.
std::string closed_line(const ReduceSceneOutcome& outcome, const ClipTotals& totals) {
  constexpr std::size_t most = 4;
  std::vector<std::string> open;
  std::size_t count = 0;
  for (const ClipReduction& reduction : outcome.reductions)
    for (const ClipReduction::OpenTrack& track : reduction.open)
      if (++count <= most) open.push_back(open_text(outcome, reduction, track));
  std::string text = formatted("closed          {} of {} of rotations", totals.rotation_tracks - totals.open_tracks,
                               counted(totals.rotation_tracks, "track"));
  if (count > 0) text += formatted("; these do not end as they begin: {}", joined(open, ", "));
  if (count > most) text += formatted(" and {} more", count - most);
  return text + "\n";
}

std::string counts_lines(const ReduceSceneOutcome& outcome, const ClipTotals& totals) {
  std::string text;
  if (totals.rotation_tracks > 0)
    text +=
        formatted("rotations       {} of {} in {} of three keys and more ({:.1f} %)\n", totals.rotation_keys,
                  counted(totals.rotation_keys_before, "key"), counted(totals.rotation_tracks, "track"),
                  100.0 * static_cast<double>(totals.rotation_keys) / static_cast<double>(totals.rotation_keys_before));
  if (totals.translation_keys < totals.translation_keys_before)
    text += formatted("translations    {} of {}\n", totals.translation_keys,
                      counted(totals.translation_keys_before, "key"));
  if (outcome.options.closed) text += closed_line(outcome, totals);
  return text;
}

/// What lies between the keys, and how many cuts there were.
std::string between_line(const ReduceSceneOutcome& outcome, const ClipTotals& totals) {
  const bool is_smooth = outcome.options.between == BetweenSamples::smooth;
  const bool holds = std::ranges::find(outcome.warnings, std::string_view("single_precision"), &Warning::code) ==
                     outcome.warnings.end();
  std::string text = formatted("between keys    {}; {}, where the motion is {}", counted(totals.cuts, "cut"),
                               holds ? "holds between keys" : "single precision breaks a tolerance",
                               is_smooth ? "the curve auto through them" : "what the input says");
  if (totals.from_smooth && totals.from_stored)
    text +=
        is_smooth
            ? formatted("; {:.6g}° from what the input says", totals.from_stored->from_stored.largest.value * degrees)
            : formatted("; {:.6g}° from the curve auto", totals.from_smooth->from_smooth.largest.value * degrees);
  return text + "\n";
}

std::string errors_lines(const ReduceSceneOutcome& outcome, const ClipTotals& totals) {
  std::string text;
  if (totals.angle)
    text += formatted("largest angle   {:.6g}°, {}\n", totals.angle->angle.largest.value * degrees,
                      worst_place(outcome, *totals.angle, totals.angle->angle));
  if (totals.translation && std::isfinite(outcome.options.position_tolerance))
    text +=
        formatted("largest shift   {:.6g}{}, {}\n", totals.translation->translation.largest.value * outcome.metres(),
                  length_unit(outcome), worst_place(outcome, *totals.translation, totals.translation->translation));
  if (totals.distance)
    text += formatted("shell distance  {:.6g}{} in the world, {}; shell {:g}{}\n",
                      totals.distance->distance.largest.value * outcome.metres(), length_unit(outcome),
                      worst_place(outcome, *totals.distance, totals.distance->distance),
                      outcome.options.shell * outcome.metres(), length_unit(outcome));
  if (totals.angle || totals.translation) text += between_line(outcome, totals);
  return text;
}

bool has_rotation_splines(const ReduceSceneOutcome& outcome) {
  return std::ranges::any_of(outcome.reductions, [](const ClipReduction& reduction) {
    return std::ranges::any_of(reduction.clip.rotations, [](const RotationChannel& channel) {
      return channel.interpolation == ChannelInterpolation::cubicspline;
    });
  });
}

/// Where the file comes from tools whose next step would break what is written, and that is still to be told.
std::string next_tool_line(const ReduceSceneOutcome& outcome) {
  if (outcome.request.file.next_tool.empty() || !has_rotation_splines(outcome)) return {};
  return formatted(
      "next tool       the input names {}; gltf-transform's meshopt breaks splines of rotations, but not linear "
      "keys, which are written for=meshopt\n",
      outcome.request.file.next_tool);
}

Json worst_json(const ReduceSceneOutcome& outcome, const ClipReduction& reduction, const ClipReduction::Worst& worst,
                double unit) {
  return {{"largest", worst.largest.value * unit},
          {"clip", reduction.clip.name},
          {"joint", outcome.request.skeleton[worst.joint].name},
          {"time_s", worst.largest.time}};
}

Json open_json(const ReduceSceneOutcome& outcome) {
  Json list = Json::array();
  for (const ClipReduction& reduction : outcome.reductions)
    for (const ClipReduction::OpenTrack& track : reduction.open) {
      Json open{{"clip", reduction.clip.name}, {"joint", outcome.request.skeleton[track.joint].name}};
      if (track.is_rotation) open["angle_deg"] = track.apart * degrees;
      else open["translation_m"] = track.apart * outcome.metres();
      list.push_back(std::move(open));
    }
  return list;
}

}  // namespace

std::string summary_of(const ReduceSceneOutcome& outcome) {
  const ClipTotals totals = outcome.totals();
  return formatted("{} from {}, tolerance {}, method {}\n", counted(outcome.reductions.size(), "clip"),
                   printable(outcome.request.file.name),
                   tolerance_text(outcome.options, outcome.metres(), length_unit(outcome)),
                   outcome.options.method.name) +
         counts_lines(outcome, totals) + errors_lines(outcome, totals) + next_tool_line(outcome);
}

std::string line_of(const ReduceSceneOutcome& outcome) {
  const ClipTotals totals = outcome.totals();
  return formatted(
      "{} of {}, {:.6g}° and {:.6g}{} in the world off at most", totals.rotation_keys,
      counted(totals.rotation_keys_before, "key"), totals.angle ? totals.angle->angle.largest.value * degrees : 0.0,
      totals.distance ? totals.distance->distance.largest.value * outcome.metres() : 0.0, length_unit(outcome));
}

Json document_of(const ReduceSceneOutcome& outcome) {
  const ClipTotals totals = outcome.totals();
  const ClipReduceOptions& options = outcome.options;
  const double metres = outcome.metres();
  Json json{{"method", options.method.name}};
  if (std::isfinite(options.tolerance)) json["tolerance_deg"] = options.tolerance * degrees;
  if (std::isfinite(options.position_tolerance)) json["position_tolerance_m"] = options.position_tolerance * metres;
  if (std::isfinite(options.world_tolerance)) json["world_tolerance_m"] = options.world_tolerance * metres;
  json["shell_m"] = options.shell * metres;
  json["clips"] = outcome.reductions.size();
  json["rotation_tracks"] = totals.rotation_tracks;
  json["rotation_keys_before"] = totals.rotation_keys_before;
  json["rotation_keys"] = totals.rotation_keys;
  json["translation_keys_before"] = totals.translation_keys_before;
  json["translation_keys"] = totals.translation_keys;
  json["between"] = word_of(options.between);
  if (options.compression != KeyCompression::none) json["compress"] = word_of(options.compression);
  json["cuts"] = totals.cuts;
  if (options.closed) {
    json["open_tracks"] = totals.open_tracks;
    json["open"] = open_json(outcome);
  }
  if (totals.angle) json["angle_deg"] = worst_json(outcome, *totals.angle, totals.angle->angle, degrees);
  if (totals.translation && std::isfinite(options.position_tolerance))
    json["translation_m"] = worst_json(outcome, *totals.translation, totals.translation->translation, metres);
  if (totals.distance)
    json["shell_distance_m"] = worst_json(outcome, *totals.distance, totals.distance->distance, metres);
  if (totals.from_smooth && totals.from_stored) {
    json["from_smooth_deg"] = worst_json(outcome, *totals.from_smooth, totals.from_smooth->from_smooth, degrees);
    json["from_stored_deg"] = worst_json(outcome, *totals.from_stored, totals.from_stored->from_stored, degrees);
  }
  return json;
}

}}}  // namespace orispline::jobs
