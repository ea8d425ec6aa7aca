// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/jobs/difference.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

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
Largest largest_in(const DifferenceOutcome& outcome) {
  Largest largest;
  for (const ClipDifference& clip : outcome.clips)
    if (const Largest found = largest_in<Member>(clip);
        !clip.worst.empty() && (!largest.clip || found.found.value > largest.found.value))
      largest = found;
  return largest;
}

std::string largest_place(const DifferenceOutcome& outcome, const Largest& largest) {
  return formatted("clip {}, joint {}, at {:.6g} s", in_quotes(outcome.name_of(*largest.clip)),
                   in_quotes(outcome.name_of_joint(largest.clip->joints[largest.joint])), largest.found.time);
}

std::string clip_line(const DifferenceOutcome& outcome, const ClipDifference& clip, std::size_t width) {
  return formatted("  {:<{}}{:>8}{:>15.6g}°{:>16.6g}\n", printable(outcome.name_of(clip)), width, clip.times.size(),
                   largest_in<&JointDifference::angle>(clip).found.value * degrees,
                   largest_in<&JointDifference::distance>(clip).found.value);
}

/// Clip by clip, those that differ most in the world first.
std::string clips_lines(const DifferenceOutcome& outcome) {
  std::vector<const ClipDifference*> clips;
  std::size_t width = 4;
  for (const ClipDifference& clip : outcome.clips)
    if (!clip.worst.empty()) clips.push_back(&clip);
  std::ranges::stable_sort(clips, std::ranges::greater(), [](const ClipDifference* clip) {
    return largest_in<&JointDifference::distance>(*clip).found.value;
  });
  const std::size_t shown = std::min(clips.size(), clips_shown);
  for (std::size_t i = 0; i < shown; ++i) width = std::max(width, printable(outcome.name_of(*clips[i])).size());
  std::string text =
      formatted("\n  {:<{}}{:>8}{:>16}{:>16}\n", "clip", width, "times", "largest angle", "shell distance");
  for (std::size_t i = 0; i < shown; ++i) text += clip_line(outcome, *clips[i], width);
  if (clips.size() > shown) text += formatted("  … and {} that differ less\n", counted(clips.size() - shown, "clip"));
  return text;
}

/// A joint of the second skeleton that no joint of the first one is.
std::size_t first_left_out(const DifferenceOutcome& outcome) {
  std::vector<bool> is_found(outcome.request.second.skeleton.size());
  for (const std::size_t joint : outcome.counterparts.joints)
    if (joint != no_parent) is_found[joint] = true;
  return static_cast<std::size_t>(std::ranges::find(is_found, false) - is_found.begin());
}

std::string missing_line(std::string_view file, const std::vector<std::string>& clips) {
  if (clips.empty()) return "";
  return formatted("only in {}: {}, such as {}\n", printable(file), counted(clips.size(), "clip"),
                   in_quotes(clips.front()));
}

/// The joints that are not at the same place in both.
std::string joints_lines(const DifferenceOutcome& outcome) {
  const auto& [joints, only_in_first, only_in_second, by_name, guessed] = outcome.counterparts;
  std::string text;
  const auto add_alone = [&](const MotionFile& file, std::size_t count, std::size_t such_as) {
    if (count > 0)
      text += formatted("only in {}: {}, such as {}\n", printable(file.name), counted(count, "joint"),
                        in_quotes(file.skeleton.shown_name(such_as)));
  };
  const auto first_alone = std::ranges::find(joints, no_parent) - joints.begin();
  add_alone(outcome.request.first, only_in_first, static_cast<std::size_t>(first_alone));
  if (only_in_second > 0) add_alone(outcome.request.second, only_in_second, first_left_out(outcome));
  if (!by_name.empty())
    text += formatted("by name alone, below other joints: {}, such as {}\n", counted(by_name.size(), "joint"),
                      in_quotes(outcome.name_of_joint(by_name.front())));
  return text;
}

std::size_t all_times(const DifferenceOutcome& outcome) {
  std::size_t times = 0;
  for (const ClipDifference& clip : outcome.clips) times += clip.times.size();
  return times;
}

Json largest_json(const LargestInTime& largest, double unit) {
  return {{"largest", largest.value * unit}, {"time_s", largest.time}};
}

std::vector<std::string> names_of_joints(const DifferenceOutcome& outcome, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t joint : joints) names.push_back(outcome.name_of_joint(joint));
  return names;
}

Json clip_json(const DifferenceOutcome& outcome, const ClipDifference& clip) {
  Json joints = Json::array();
  for (std::size_t i = 0; i < clip.joints.size(); ++i)
    joints.push_back({{"joint", outcome.name_of_joint(clip.joints[i])},
                      {"angle_deg", largest_json(clip.worst[i].angle, degrees)},
                      {"translation", largest_json(clip.worst[i].translation, 1.0)},
                      {"shell_distance", largest_json(clip.worst[i].distance, 1.0)}});
  Json json{{"clip", outcome.name_of(clip)}, {"times", clip.times.size()}};
  json["joints"] = std::move(joints);
  return json;
}

}  // namespace

std::string summary_of(const DifferenceOutcome& outcome) {
  std::string text = formatted("{} and {}: {} compared\n", printable(outcome.request.first.name),
                               printable(outcome.request.second.name), counted(outcome.clips.size(), "clip"));
  text += missing_line(outcome.request.first.name, outcome.only_in_first) +
          missing_line(outcome.request.second.name, outcome.only_in_second);
  text += joints_lines(outcome);
  const Largest angle = largest_in<&JointDifference::angle>(outcome),
                shift = largest_in<&JointDifference::translation>(outcome),
                distance = largest_in<&JointDifference::distance>(outcome);
  if (!angle.clip) return text + "no joint is in both of them\n";
  if (angle.found.value == 0.0 && shift.found.value == 0.0 && distance.found.value == 0.0)
    return text + formatted("no difference in {} at {}\n", counted(angle.clip->joints.size(), "joint"),
                            counted(all_times(outcome), "time"));
  text += formatted("largest angle        {:.6g}°, {}\n", angle.found.value * degrees, largest_place(outcome, angle));
  text += formatted("largest translation  {:.6g}, {}\n", shift.found.value, largest_place(outcome, shift));
  text += formatted("shell distance       {:.6g}, {}; shell {:g}\n", distance.found.value,
                    largest_place(outcome, distance), outcome.request.shell);
  return outcome.clips.size() > 1 ? text + clips_lines(outcome) : text;
}

Json document_of(const DifferenceOutcome& outcome) {
  Json clips = Json::array();
  for (const ClipDifference& clip : outcome.clips) clips.push_back(clip_json(outcome, clip));
  Json json{
      {"first", outcome.request.first.name}, {"second", outcome.request.second.name}, {"shell", outcome.request.shell}};
  if (const Largest angle = largest_in<&JointDifference::angle>(outcome); angle.clip) {
    json["angle_max_deg"] = angle.found.value * degrees;
    json["translation_max"] = largest_in<&JointDifference::translation>(outcome).found.value;
    json["shell_distance_max"] = largest_in<&JointDifference::distance>(outcome).found.value;
  }
  json["only_in_first"] = outcome.only_in_first;
  json["only_in_second"] = outcome.only_in_second;
  json["joints_only_in_first"] = outcome.counterparts.only_in_first;
  json["joints_only_in_second"] = outcome.counterparts.only_in_second;
  json["joints_by_name"] = names_of_joints(outcome, outcome.counterparts.by_name);
  json["joints_guessed"] = names_of_joints(outcome, outcome.counterparts.guessed);
  json["clips"] = std::move(clips);
  return json;
}

}}}  // namespace orispline::jobs
