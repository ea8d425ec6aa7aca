// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/clip.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/first_error.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/joint_named.hpp>
#include <orispline/edit/root_motion.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::string_view length_unit(const ClipOutcome& outcome) { return outcome.request.file.format.has_no_unit ? "" : " m"; }

/// The joint that a name means; `no_parent` where none is stated.
Expected<std::size_t> joint_of(const MotionFile& file, const std::string& name, std::string_view option) {
  if (name.empty()) return no_parent;
  return joint_named(file.skeleton, name).map_error([&](Error error) {
    return bad_option(option, std::move(error.message)).value();
  });
}

/// Only what the format of the file passes on knows of them.
std::vector<Warning> warnings_of_values_beside(const MotionFile& file) {
  const auto count = static_cast<std::size_t>(
      std::ranges::count_if(file.clips, [](const Clip& clip) { return clip.passed_on.has_value(); }));
  if (count == 0) return {};
  return {{.code = "values_not_edited",
           .message =
               formatted("{} has values beside its joints and weights, which stay as they are", counted(count, "clip")),
           .where = {.file = file.name},
           .numbers = {{"clips", static_cast<double>(count)}}}};
}

std::string name_of_joint(const ClipOutcome& outcome, std::size_t joint) {
  return in_quotes(outcome.request.file.skeleton.shown_name(joint));
}

/// A time [s], whatever the clock of the file is.
std::string seconds(double t) {
  constexpr double long_ago = 1e4;
  return std::abs(t) < long_ago ? formatted("{:.6g} s", t) : formatted("{:.3f} s", t);
}

std::string seam_text(const ClipOutcome& outcome, const ClipSeam& seam) {
  if (seam.pose.joint == no_parent && seam.rate.joint == no_parent) return "nothing jumps";
  std::string text;
  if (seam.pose.joint != no_parent)
    text += formatted("{:.4g}° of joint {}", seam.pose.value * degrees, name_of_joint(outcome, seam.pose.joint));
  if (seam.rate.joint != no_parent)
    text += formatted("{}{:.4g} °/s of joint {}", text.empty() ? "" : ", ", seam.rate.value * degrees,
                      name_of_joint(outcome, seam.rate.joint));
  return text;
}

std::string change_text(const ClipOutcome& outcome, const ClipLoop& loop) {
  if (loop.closing == LoopClosing::none) return "it went round already, nothing is bent";
  if (loop.closing == LoopClosing::frame) return "it got its closing key, nothing is bent";
  std::vector<std::string> texts;
  const auto add = [&](const LoopChange& change, double unit, std::string_view name) {
    if (change.joint != no_parent)
      texts.push_back(formatted("{:.4g}{} of joint {} at {}", change.largest.value * unit, name,
                                name_of_joint(outcome, change.joint), seconds(change.largest.time)));
  };
  add(loop.rotation, degrees, "°");
  add(loop.translation, 1.0, length_unit(outcome));
  add(loop.scale, 1.0, " of the scale");
  return texts.empty() ? "none" : joined(texts, ", ");
}

/// Of the way of a joint that went into a node or nowhere.
std::string taken_text(const ClipOutcome& outcome, const Travel& taken) {
  const ClipRequest& request = outcome.request;
  return formatted("the way of joint {}, which comes {:.4g}{} far and turns {:.4g}°",
                   in_quotes(request.in_place.empty() ? request.extract_root : request.in_place), taken.way,
                   length_unit(outcome), taken.turn * degrees);
}

std::string lines_of(const ClipOutcome& outcome, std::size_t i) {
  const ClipEdit& edit = outcome.clips[i];
  const Domain after = edit.clip.domain();
  std::string text =
      formatted("{}: {} to {}, from {} to {} of the input\n", in_quotes(edit.clip.name), seconds(after.start),
                seconds(after.end), seconds(edit.part.start), seconds(edit.part.end));
  if (edit.blend)
    text += formatted("  blend           {} to {}; the appended clip is turned by {:.4g}°\n",
                      seconds(edit.blend->start), seconds(edit.blend->end), edit.appended_turn * degrees);
  if (edit.taken) text += formatted("  taken out       {}\n", taken_text(outcome, *edit.taken));
  if (!edit.loop) return text;
  text += formatted("  largest change  {}\n", change_text(outcome, *edit.loop));
  if (edit.loop->travel > 0.0 || edit.loop->turn != 0.0)
    text += formatted("  root            goes {:.4g}{} and turns {:.4g}° in one round\n", edit.loop->travel,
                      length_unit(outcome), edit.loop->turn * degrees);
  return text + formatted("  seam            {}\n", seam_text(outcome, outcome.seams[i]));
}

Json largest_json(const ClipOutcome& outcome, const LoopChange& change, double unit) {
  if (change.joint == no_parent) return nullptr;
  return {{"largest", change.largest.value * unit},
          {"joint", outcome.request.file.skeleton[change.joint].name},
          {"time_s", change.largest.time}};
}

Json json_of(const ClipOutcome& outcome, const ClipEdit& edit) {
  const Domain after = edit.clip.domain();
  Json json{{"clip", edit.clip.name},
            {"from_s", edit.part.start},
            {"to_s", edit.part.end},
            {"start_s", after.start},
            {"end_s", after.end}};
  if (edit.blend)
    json["blend"] =
        Json{{"start_s", edit.blend->start}, {"end_s", edit.blend->end}, {"turn_deg", edit.appended_turn * degrees}};
  if (edit.taken) json["taken"] = Json{{"travel", edit.taken->way}, {"turn_deg", edit.taken->turn * degrees}};
  if (!edit.loop) return json;
  json["loop"] = Json{{"closing", word_of(edit.loop->closing)},
                      {"rotation_change_deg", largest_json(outcome, edit.loop->rotation, degrees)},
                      {"translation_change", largest_json(outcome, edit.loop->translation, 1.0)},
                      {"scale_change", largest_json(outcome, edit.loop->scale, 1.0)},
                      {"travel", edit.loop->travel},
                      {"turn_deg", edit.loop->turn * degrees}};
  return json;
}

/// Settings that contradict each other.
Expected<void> check(const ClipRequest& request) {
  if (request.file.clips.empty()) return failure(ErrorCode::bad_data, "found no clip, wanted one");
  if (!request.root.empty() && !request.edits.loop && !request.appended)
    return bad_option("root", "found a joint whose way goes on, wanted `loop` or `append` too");
  if (request.edits.blend && !request.appended) return bad_option("blend", "found it without `append`, wanted both");
  if (!request.append_clip.empty() && !request.appended)
    return bad_option("append_clip", "found it without `append`, wanted both");
  if (!request.root_node.empty() && request.extract_root.empty())
    return bad_option("root_node", "found it without `extract_root`, wanted both");
  if (!request.in_place.empty() && !request.extract_root.empty())
    return bad_option("in_place", "found it beside `extract_root`, wanted one of them");
  if (request.appended && request.file.clips.size() > 1)
    return mended_by("clip",
                     formatted("found {} clips to append another one to, wanted one", request.file.clips.size()));
  return {};
}

/// The first few: `'walk', 'run'`.
std::string names_of(const std::vector<Clip>& clips) {
  constexpr std::size_t shown = 12;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(shown, clips.size()); ++i) names.push_back(in_quotes(clips[i].name));
  return joined(names, ", ") + (clips.size() > shown ? formatted(" and {} more", clips.size() - shown) : "");
}

/// The clip of the second file; null where there is none.
Expected<const Clip*> appended_clip(const ClipRequest& request) {
  if (!request.appended) return nullptr;
  const MotionFile& file = *request.appended;
  const auto found = std::ranges::find(file.clips, request.append_clip, &Clip::name);
  if (found != file.clips.end()) return &*found;
  if (request.append_clip.empty() && file.clips.size() == 1) return &file.clips.front();
  if (request.append_clip.empty())
    return failure(
        ErrorCode::bad_data,
        formatted("found {} clips, wanted one, or one of {} by `append_clip`", file.clips.size(), names_of(file.clips)),
        {.file = file.name});
  return failure(ErrorCode::bad_data,
                 formatted("found no clip {}, wanted one of {}", in_quotes(request.append_clip), names_of(file.clips)),
                 {.file = file.name});
}

Expected<EditedJoints> joints_in(const ClipRequest& request) {
  FirstError checked;
  const auto joint = [&](const std::string& name, std::string_view option) {
    return checked(joint_of(request.file, name, option));
  };
  return std::move(checked).or_else(EditedJoints{.root = joint(request.root, "root"),
                                                 .extracted = joint(request.extract_root, "extract_root"),
                                                 .node = joint(request.root_node, "root_node"),
                                                 .in_place = joint(request.in_place, "in_place")});
}

/// Where the joint whose way is extracted has no joint above it, one is made. Returns its name; empty: none is made.
Expected<std::string> made_root(ClipRequest& request) {
  if (!request.root_node.empty()) return std::string();
  const auto with_root = [&](MotionFile& file) {
    return joint_of(file, request.extract_root, "extract_root")
        .and_then([&](std::size_t joint) -> Expected<std::string> {
          if (joint == no_parent || file.skeleton[joint].parent != no_parent) return std::string();
          return with_root_above(std::move(file), joint).map([&](MotionFile made) {
            file = std::move(made);
            return file.skeleton[0].name;
          });
        });
  };
  auto name = with_root(request.file);
  if (!name || name->empty() || !request.appended) return name;
  if (!request.appended->skeleton.find(request.extract_root)) return name;
  return with_root(*request.appended).map([&](const std::string&) { return *name; });
}

/// Of several clips those that an edit does not fit, such as a pose that shall be a loop.
Warning warning_of_left(const MotionFile& file, const std::vector<Clip>& left, const Error& first) {
  const std::string option = first.option.empty() ? "" : formatted("`{}`: ", first.option);
  return {
      .code = "clips_left",
      .message = formatted("{} of {} clips stay as they are, since an edit does not fit them: {}. Of the first one: "
                           "{}{}; `clip` chooses which clips are edited and written",
                           left.size(), file.clips.size(), names_of(left), option, first.message),
      .where = {.file = file.name},
      .numbers = {{"clips", static_cast<double>(left.size())}}};
}

/// Where a joint that the loop brings back goes most of its way in one direction, as that of a walk does.
std::optional<Warning> warning_of_way(const ClipOutcome& outcome, const Clip& before, const ClipEdit& edit) {
  constexpr double most = 0.5;  // of the extent of its places
  const std::size_t joint = edit.loop ? edit.loop->translation.joint : no_parent;
  if (joint == no_parent || !outcome.request.root.empty()) return std::nullopt;
  const MotionFile& file = outcome.request.file;
  const ClipMotion moving(file.skeleton, before);
  Eigen::AlignedBox3d box;
  for (const double t : key_times(before))
    if (edit.part.contains(t)) box.extend(moving.world_pose(joint, t).translation());
  const double way =
      (moving.world_pose(joint, edit.part.end).translation() - moving.world_pose(joint, edit.part.start).translation())
          .norm();
  if (box.isEmpty() || way < most * box.diagonal().norm()) return std::nullopt;
  return Warning{
      .code = "way_bent",
      .message = formatted("clip {}: joint {} comes {:.4g}{} far, which the loop takes back; `root` names the "
                           "joint whose way a loop keeps",
                           in_quotes(before.name), name_of_joint(outcome, joint), way, length_unit(outcome)),
      .where = {.file = file.name},
      .numbers = {{"way", way}}};
}

Expected<ClipOutcome> edited_clips(ClipRequest request) {
  FirstError checked;
  const auto sound = check(request);
  if (!sound) return tl::unexpected(sound.error());
  const auto root = made_root(request);
  if (!root) return tl::unexpected(root.error());
  const Clip* const second = checked(appended_clip(request));
  const EditedJoints joints = checked(joints_in(request));
  if (auto named = std::move(checked).or_else(true); !named) return tl::unexpected(std::move(named.error()));
  const MotionFile& file = request.file;
  std::vector<Expected<ClipEdit>> edits(file.clips.size());
  parallel_for(edits.size(), request.threads, [&](std::size_t i) {
    if (!second) edits[i] = edited(file.skeleton, file.clips[i], request.edits, joints);
    else {
      const AppendedClip appended{request.appended->skeleton, *second};
      edits[i] = edited(file.skeleton, file.clips[i], request.edits, joints, &appended);
    }
  });
  const bool none_fits = std::ranges::none_of(edits, [](const auto& edit) { return edit.has_value(); });
  if (none_fits) return tl::unexpected(std::move(edits.front().error()));
  ClipOutcome outcome{.request = std::move(request), .made_root = *root};
  std::vector<Clip> left;
  std::optional<Error> why;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const Clip& before = outcome.request.file.clips[i];
    if (!edits[i]) {
      left.push_back(before);
      if (!why) why = std::move(edits[i].error());
      edits[i] = ClipEdit{.clip = before, .before = before.domain(), .part = before.domain()};
    }
    const ClipEdit& done = outcome.clips.emplace_back(*std::move(edits[i]));
    const bool keeps_way = done.loop && joints.in_place == no_parent && joints.extracted == no_parent;
    if (auto bent = warning_of_way(outcome, before, done)) outcome.warnings.push_back(*std::move(bent));
    outcome.seams.push_back(keeps_way ? seam_of(done.clip, done.loop->turns) : seam_of(done.clip));
  }
  std::ranges::move(warnings_of_values_beside(outcome.request.file), std::back_inserter(outcome.warnings));
  if (why) outcome.warnings.push_back(warning_of_left(outcome.request.file, left, *why));
  return outcome;
}

}  // namespace

Json json_of(const ClipSeam& seam, const Skeleton& skeleton) {
  const auto joint = [&](const ClipSeam::Step& step) {
    return step.joint == no_parent ? Json(nullptr) : Json(skeleton[step.joint].name);
  };
  return {{"seam_deg", seam.pose.value * degrees},
          {"seam_joint", joint(seam.pose)},
          {"seam_rate_deg_s", seam.rate.value * degrees},
          {"seam_rate_joint", joint(seam.rate)}};
}

Expected<ClipOutcome> clip(ClipRequest request) {
  const std::string name = request.file.name;
  return edited_clips(std::move(request)).map_error([&](Error error) {
    if (error.where.file.empty()) error.where.file = name;
    return error;
  });
}

std::string summary_of(const ClipOutcome& outcome) {
  const std::string& name = outcome.request.file.name;
  std::string text =
      formatted("{}{}\n", counted(outcome.clips.size(), "clip"), name.empty() ? "" : " from " + printable(name));
  if (!outcome.made_root.empty())
    text += formatted("joint {} was made above joint {}\n", in_quotes(outcome.made_root),
                      in_quotes(outcome.request.extract_root));
  constexpr std::size_t most_shown = 10;
  const std::size_t shown = std::min(most_shown, outcome.clips.size());
  for (std::size_t i = 0; i < shown; ++i) text += lines_of(outcome, i);
  if (shown < outcome.clips.size()) text += formatted("… and {} clips more\n", outcome.clips.size() - shown);
  return text;
}

Json document_of(const ClipOutcome& outcome) {
  Json clips = Json::array();
  for (std::size_t i = 0; i < outcome.clips.size(); ++i) {
    Json clip = json_of(outcome, outcome.clips[i]);
    clip.update(json_of(outcome.seams[i], outcome.request.file.skeleton));
    clips.push_back(std::move(clip));
  }
  Json json;
  if (!outcome.made_root.empty()) json["made_root"] = outcome.made_root;
  json["clips"] = std::move(clips);
  return json;
}

}}}  // namespace orispline::jobs
