// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/smooth.hpp>

#include <set>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// One for all rotations that cannot be smoothed.
std::vector<Warning> warnings_of_refused(const std::vector<ClipSmoothing>& clips) {
  std::size_t refused = 0;
  const Error* first = nullptr;
  for (const ClipSmoothing& clip : clips) {
    refused += clip.refused.size();
    if (!first && !clip.refused.empty()) first = &clip.refused.front();
  }
  if (!first) return {};
  return {{.code = "not_smoothed",
           .message = formatted("left as it is what cannot be smoothed: {}; {}", counted(refused, "rotation"),
                                describe(*first))}};
}

/// Where a rotation was changed most: motion that counts as an outlier is seen there.
std::string largest_change_line(const SmoothClipsOutcome& outcome) {
  const ClipSmoothing* clip = nullptr;
  const ClipSmoothing::OfJoint* worst = nullptr;
  for (const ClipSmoothing& other : outcome.clips)
    for (const ClipSmoothing::OfJoint& joint : other.joints)
      if (!worst || joint.largest_change > worst->largest_change) clip = &other, worst = &joint;
  if (!worst) return "";
  return formatted("largest change  {:.4g}° at {:.6g} s, {}\n", worst->largest_change * degrees, worst->change_at,
                   place_of(outcome.request.skeleton, clip->clip, worst->joint));
}

/// Where it correlates.
std::string shared_noise_line(const SmoothClipsOutcome& outcome) {
  for (const ClipSmoothing& clip : outcome.clips)
    for (const ClipSmoothing::OfJoint& joint : clip.joints)
      if (const auto& noise = joint.smoothing.correlated_noise)
        return formatted("noise           {:.4g}° per axis of all joints, correlated over {:.3g} s, {}\n",
                         noise->sigma * degrees, noise->time,
                         outcome.request.options.noise_time ? "as stated" : "which they share");
  return "";
}

std::string joints_table(const Skeleton& skeleton, const std::vector<ClipSmoothing::OfJoint>& joints) {
  if (joints.empty()) return "";
  std::string table =
      formatted("  {:<24}{:>14}{:>13}{:>10}{:>15}\n", "joint", "smoothing time", "noise", "rejected", "largest change");
  for (const auto& [joint, found, change, at] : joints)
    table += formatted("  {:<24}{:>12.4g} s{:>12.4g}°{:>10}{:>14.4g}°\n", printable(skeleton[joint].name),
                       found.smoothing_time, found.noise * degrees, found.rejected.size(), change * degrees);
  return table;
}

/// `frames 100 to 111, 1.66667 s to 1.85 s: Arm, Hand; they jump by up to 60.5°`
std::string run_text(const Skeleton& skeleton, const WrongRun& run) {
  std::string names;
  for (const std::size_t joint : run.joints)
    names += formatted("{}{}", names.empty() ? "" : ", ", printable(skeleton.shown_name(joint)));
  return formatted("frames {} to {}, {:.6g} s to {:.6g} s: {}; {} by up to {:.3g}°", run.first,
                   run.first + run.count - 1, run.start, run.end, names,
                   run.joints.size() == 1 ? "it jumps" : "they jump", run.jump * degrees);
}

/// One line for each run, and of many how many more there are.
std::string run_lines(const SmoothClipsOutcome& outcome) {
  constexpr std::size_t most = 20;
  std::string text;
  std::size_t runs = 0;
  for (const ClipSmoothing& clip : outcome.clips)
    for (const WrongRun& run : clip.runs)
      if (runs++ < most)
        text += formatted("bridged         {}{}\n",
                          outcome.clips.size() == 1 ? "" : formatted("clip {}, ", in_quotes(clip.clip.name)),
                          run_text(outcome.request.skeleton, run));
  if (runs > most) text += formatted("bridged         {} more\n", counted(runs - most, "run"));
  return text;
}

/// How many contacts were held, and what that does to the speed meanwhile, a mean over their frames.
std::string contacts_line(const SmoothClipsOutcome& outcome) {
  if (outcome.request.options.keep_contacts.empty()) return "";
  std::size_t contacts = 0, frames = 0;
  double before = 0.0, after = 0.0;
  std::set<std::size_t> joints;
  for (const ClipSmoothing& clip : outcome.clips)
    for (const Contact& contact : clip.contacts) {
      const auto count = static_cast<double>(contact.count);
      before += count * contact.slide_before, after += count * contact.slide_after;
      frames += contact.count, ++contacts;
      joints.insert(contact.joint);
    }
  if (contacts == 0) return "contacts        none found\n";
  const auto all = static_cast<double>(frames);
  return formatted("contacts        {} of {} held; meanwhile they go {:.4g}{} a second, {:.4g} before\n",
                   counted(contacts, "contact"), counted(joints.size(), "joint"), after / all,
                   outcome.request.has_no_unit ? "" : " m", before / all);
}

Json json_of(const Skeleton& skeleton, const Contact& contact) {
  return {{"joint", skeleton[contact.joint].name},
          {"first_frame", contact.first},
          {"frames", contact.count},
          {"start_s", contact.start},
          {"end_s", contact.end},
          {"slide", contact.slide_after},
          {"slide_before", contact.slide_before}};
}

Json json_of(const Skeleton& skeleton, const WrongRun& run) {
  Json joints = Json::array();
  for (const std::size_t joint : run.joints) joints.push_back(skeleton[joint].name);
  Json json{{"first_frame", run.first},
            {"frames", run.count},
            {"start_s", run.start},
            {"end_s", run.end},
            {"jump_max_deg", run.jump * degrees}};
  json["joints"] = std::move(joints);
  return json;
}

Json json_of(const Skeleton& skeleton, const ClipSmoothing& clip) {
  Json joints = Json::array();
  for (const auto& [joint, found, change, at] : clip.joints)
    joints.push_back({{"joint", skeleton[joint].name},
                      {"smoothing_time_s", found.smoothing_time},
                      {"noise_deg", found.noise * degrees},
                      {"rejected", found.rejected.size()},
                      {"change_max_deg", change * degrees},
                      {"change_max_time_s", at}});
  Json json{{"clip", clip.clip.name}, {"left", clip.left}, {"refused", clip.refused.size()}};
  json["joints"] = std::move(joints);
  Json runs = Json::array();
  for (const WrongRun& run : clip.runs) runs.push_back(json_of(skeleton, run));
  json["runs"] = std::move(runs);
  Json contacts = Json::array();
  for (const Contact& contact : clip.contacts) contacts.push_back(json_of(skeleton, contact));
  json["contacts"] = std::move(contacts);
  return json;
}

}  // namespace

Expected<SmoothClipsOutcome> smooth_clips(SmoothClipsRequest request) {
  auto clips = orispline::smooth_clips(request.skeleton, request.clips, request.options, request.threads);
  if (!clips) {
    clips.error().where.file = request.name;
    return tl::unexpected(std::move(clips.error()));
  }
  std::vector<Warning> warnings = warnings_of_refused(*clips);
  return SmoothClipsOutcome{std::move(request), std::move(*clips), std::move(warnings)};
}

Json document_of(const SmoothClipsOutcome& outcome) {
  Json clips = Json::array();
  for (const ClipSmoothing& clip : outcome.clips) clips.push_back(json_of(outcome.request.skeleton, clip));
  Json json;
  json["clips"] = std::move(clips);
  return json;
}

std::string summary_of(const SmoothClipsOutcome& outcome) {
  std::size_t joints = 0, left = 0;
  for (const ClipSmoothing& clip : outcome.clips) joints += clip.joints.size(), left += clip.left;
  const std::string& name = outcome.request.name;
  std::string text = formatted("{} of {}{} smoothed; {} left as they are: they rest or have too few keys\n",
                               counted(joints, "rotation"), counted(outcome.clips.size(), "clip"),
                               name.empty() ? "" : " from " + printable(name), left);
  text += shared_noise_line(outcome);
  text += run_lines(outcome) + contacts_line(outcome);
  if (outcome.clips.size() == 1) text += joints_table(outcome.request.skeleton, outcome.clips.front().joints);
  return text + largest_change_line(outcome);
}

}}}  // namespace orispline::jobs
