// SPDX-License-Identifier: Apache-2.0
#include "commands/difference/difference_report.hpp"

#include <algorithm>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline::cli {

namespace {

constexpr std::size_t clips_shown = 10;

/// The joint of a clip where one of the differences is largest.
struct Largest {
  const ClipDifference* clip = nullptr;
  std::size_t joint = 0;
  LargestInTime found{};
};

template <LargestInTime JointDifference::*Member>
Largest largest_in(const ClipDifference& clip) {
  Largest largest{.clip = &clip};
  for (std::size_t i = 0; i < clip.worst.size(); ++i)
    if (const LargestInTime& found = clip.worst[i].*Member; i == 0 || found.value > largest.found.value)
      largest.joint = i, largest.found = found;
  return largest;
}

template <LargestInTime JointDifference::*Member>
Largest largest_in(const DifferenceReport& report) {
  Largest largest;
  for (const ClipDifference& clip : report.clips)
    if (const Largest found = largest_in<Member>(clip);
        !clip.worst.empty() && (!largest.clip || found.found.value > largest.found.value))
      largest = found;
  return largest;
}

std::string place_of(const Largest& largest) {
  return formatted("clip {}, joint {}, at {:.6g} s", in_quotes(largest.clip->clip),
                   in_quotes(largest.clip->joints[largest.joint]), largest.found.time);
}

std::string line_of(const ClipDifference& clip, std::size_t width) {
  return formatted("  {:<{}}{:>8}{:>15.6g}°{:>16.6g}\n", printable(clip.clip), width, clip.times,
                   largest_in<&JointDifference::angle>(clip).found.value * degrees,
                   largest_in<&JointDifference::distance>(clip).found.value);
}

/// Clip by clip, those that differ most in the world first.
std::string lines_of(const DifferenceReport& report) {
  std::vector<const ClipDifference*> clips;
  std::size_t width = 4;
  for (const ClipDifference& clip : report.clips)
    if (!clip.worst.empty()) clips.push_back(&clip);
  std::ranges::stable_sort(clips, std::ranges::greater(), [](const ClipDifference* clip) {
    return largest_in<&JointDifference::distance>(*clip).found.value;
  });
  const std::size_t shown = std::min(clips.size(), clips_shown);
  for (std::size_t i = 0; i < shown; ++i) width = std::max(width, printable(clips[i]->clip).size());
  std::string text =
      formatted("\n  {:<{}}{:>8}{:>16}{:>16}\n", "clip", width, "times", "largest angle", "shell distance");
  for (std::size_t i = 0; i < shown; ++i) text += line_of(*clips[i], width);
  if (clips.size() > shown) text += formatted("  … and {} that differ less\n", counted(clips.size() - shown, "clip"));
  return text;
}

std::string missing(std::string_view file, const std::vector<std::string>& clips) {
  if (clips.empty()) return "";
  return formatted("only in {}: {}, such as {}\n", printable(file), counted(clips.size(), "clip"),
                   in_quotes(clips.front()));
}

std::size_t times_of(const DifferenceReport& report) {
  std::size_t times = 0;
  for (const ClipDifference& clip : report.clips) times += clip.times;
  return times;
}

Json json_of(const LargestInTime& largest, double unit) {
  return {{"largest", largest.value * unit}, {"time_s", largest.time}};
}

Json json_of(const ClipDifference& clip) {
  Json joints = Json::array();
  for (std::size_t i = 0; i < clip.joints.size(); ++i)
    joints.push_back({{"joint", clip.joints[i]},
                      {"angle_deg", json_of(clip.worst[i].angle, degrees)},
                      {"translation", json_of(clip.worst[i].translation, 1.0)},
                      {"shell_distance", json_of(clip.worst[i].distance, 1.0)}});
  Json json{{"clip", clip.clip}, {"times", clip.times}};
  json["joints"] = std::move(joints);
  return json;
}

}  // namespace

std::string text_of(const DifferenceReport& report) {
  std::string text = formatted("{} and {}: {} compared\n", printable(report.first), printable(report.second),
                               counted(report.clips.size(), "clip"));
  text += missing(report.first, report.only_in_first) + missing(report.second, report.only_in_second);
  if (report.joints_only_in_first > 0)
    text += formatted("only in {}: {}\n", printable(report.first), counted(report.joints_only_in_first, "joint"));
  const Largest angle = largest_in<&JointDifference::angle>(report),
                shift = largest_in<&JointDifference::translation>(report),
                distance = largest_in<&JointDifference::distance>(report);
  if (!angle.clip) return text + "no joint is in both of them\n";
  if (angle.found.value == 0.0 && shift.found.value == 0.0 && distance.found.value == 0.0)
    return text + formatted("no difference in {} at {}\n", counted(angle.clip->joints.size(), "joint"),
                            counted(times_of(report), "time"));
  text += formatted("largest angle        {:.6g}°, {}\n", angle.found.value * degrees, place_of(angle));
  text += formatted("largest translation  {:.6g}, {}\n", shift.found.value, place_of(shift));
  text += formatted("shell distance       {:.6g}, {}; shell {:g}\n", distance.found.value, place_of(distance),
                    report.shell);
  return report.clips.size() > 1 ? text + lines_of(report) : text;
}

Json json_of(const DifferenceReport& report) {
  Json clips = Json::array();
  for (const ClipDifference& clip : report.clips) clips.push_back(json_of(clip));
  Json json{{"first", report.first}, {"second", report.second}, {"shell", report.shell}};
  if (const Largest angle = largest_in<&JointDifference::angle>(report); angle.clip) {
    json["angle_max_deg"] = angle.found.value * degrees;
    json["translation_max"] = largest_in<&JointDifference::translation>(report).found.value;
    json["shell_distance_max"] = largest_in<&JointDifference::distance>(report).found.value;
  }
  json["only_in_first"] = report.only_in_first;
  json["only_in_second"] = report.only_in_second;
  json["joints_only_in_first"] = report.joints_only_in_first;
  json["clips"] = std::move(clips);
  return json;
}

}  // namespace orispline::cli
