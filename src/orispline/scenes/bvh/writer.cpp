// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh/writer.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/scenes/scene_tracks.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr double least_rest = 0.01;  // of a clip behind its last frame that is said, as a share of the frame time

Expected<EulerOrder> order_of(const SceneWriting& writing) {
  const EulerOrder order = writing.euler.value_or(EulerOrder{});
  if (order.is_proper())
    return bad_option("output_euler",
                      "found an order with one axis twice, wanted three different axes, for a joint of BVH has "
                      "each channel once");
  return order;
}

/// That of a scene as it was read; null if there is none that still fits.
const Source* source_of(const Scene& scene) {
  const auto* source = dynamic_cast<const Source*>(scene.source.get());
  return source && source->has(scene.skeleton) ? source : nullptr;
}

/// All joints with rotations turn in one order.
void set_turns(Plan& plan, const EulerOrder& order) {
  const std::vector<Column> turns = columns_of(order);
  for (PlannedJoint& joint : plan) {
    std::vector<Column>& columns = joint.written.columns;
    const auto is_turn = [](const Column& column) { return column.kind == Column::Kind::rotation; };
    std::vector<Column> before;
    std::ranges::copy_if(columns, std::back_inserter(before), is_turn);
    if (before.empty() || before == turns) continue;
    std::erase_if(columns, is_turn);
    columns.insert(columns.end(), turns.begin(), turns.end());
  }
}

Warning warning_of(std::string_view code, std::string message, std::string_view what, std::size_t count,
                   const std::string& path) {
  return {.code = code,
          .message = std::move(message),
          .where = {.file = path},
          .numbers = {{what, static_cast<double>(count)}}};
}

/// Joints whose scale is not 1 but for rounding to `float`.
std::size_t scaled_joints_of(const Scene& scene, const Clip& clip) {
  const auto is_scale = [](const Eigen::Vector3d& scale) {
    constexpr double off = 1e-6;
    return (scale - Eigen::Vector3d::Ones()).cwiseAbs().maxCoeff() > off;
  };
  std::vector<bool> is_scaled(scene.skeleton.size());
  for (std::size_t j = 0; j < scene.skeleton.size(); ++j) is_scaled[j] = is_scale(scene.skeleton[j].rest.scale);
  for (const VectorChannel& channel : clip.scales)
    if (std::ranges::any_of(channel.values, is_scale)) is_scaled[channel.joint] = true;
  return static_cast<std::size_t>(std::ranges::count(is_scaled, true));
}

/// Writes one scene.
class Writer {
 public:
  Writer(const Scene& scene, const Clip& clip, const std::string& path, const SceneWriting& writing)
      : scene_(scene), clip_(clip), path_(path), writing_(writing), source_(source_of(scene)) {}

  Expected<SceneWritten> write(const EulerOrder& order) {
    auto frames = frames_of(clip_, writing_, source_);
    if (!frames) return tl::unexpected(std::move(frames.error()));
    auto plan = source_ ? Expected<Plan>(plan_of(*source_)) : plan_of(scene_.skeleton, clip_, order);
    if (!plan) return tl::unexpected(std::move(plan.error()));
    if (plan->empty()) return failure(ErrorCode::bad_data, "found no joint, wanted one at least");
    if (writing_.euler) set_turns(*plan, order);
    auto joints = numbers_of(*plan, *frames, order);
    if (!joints) return tl::unexpected(std::move(joints.error()));
    for (std::size_t i = 0; i < joints->size(); ++i) set_columns((*plan)[i], (*joints)[i].columns);
    add_hierarchy(*plan);
    add_motion(*frames, *joints);
    warn(*frames, *joints);
    warn_of_detours(*frames, *plan, *joints);
    return std::move(written_);
  }

 private:
  Expected<std::vector<JointNumbers>> numbers_of(const Plan& plan, const Frames& frames,
                                                 const EulerOrder& order) const {
    const NumberFinder finder(scene_.skeleton, clip_, frames, source_,
                              writing_.euler ? SourceAngles::without_jumps : SourceAngles::all);
    std::vector<JointNumbers> joints;
    std::size_t all = 0;
    for (const PlannedJoint& planned : plan) {
      auto numbers = finder.of(planned, order);
      if (!numbers) return tl::unexpected(std::move(numbers.error()));
      all += numbers->numbers.size();
      if (all > most_numbers)
        return failure(ErrorCode::bad_data, formatted("found {} with more than {} numbers, wanted fewer of both",
                                                      counted(frames.times.size(), "frame"), most_numbers));
      joints.push_back(std::move(*numbers));
    }
    return joints;
  }

  static void set_columns(PlannedJoint& joint, const std::vector<Column>& columns) {
    joint.written.columns = columns;
    if (!columns.empty()) joint.written.is_end_site = false;
  }

  void add_hierarchy(const Plan& plan) {
    const bool has_returns = source_ && source_->hierarchy.find("\r\n") != std::string::npos;
    line_end_ = has_returns ? "\r\n" : "\n";
    const auto is_as_read = [](const PlannedJoint& joint, const WrittenJoint& read) {
      return joint.written.columns == read.columns;
    };
    if (source_ && std::ranges::equal(plan, source_->joints, is_as_read)) {
      written_.bytes = source_->hierarchy;
      return;
    }
    HierarchyText hierarchy = text_of(plan, line_end_);
    written_.bytes = std::move(hierarchy.text);
    if (hierarchy.renamed > 0)
      written_.warnings.push_back(
          warning_of("names_changed",
                     formatted("{} with '_' for what a name of BVH cannot hold", counted(hierarchy.renamed, "joint")),
                     "joints", hierarchy.renamed, path_));
  }

  void add_motion(const Frames& frames, const std::vector<JointNumbers>& joints) {
    for (const JointNumbers& joint : joints) {
      if (count_of(joint.columns, Column::Kind::rotation) > 0) written_.keys.rotations += frames.times.size();
      if (count_of(joint.columns, Column::Kind::position) > 0) written_.keys.translations += frames.times.size();
    }
    std::string& text = written_.bytes;
    text += formatted("MOTION{0}Frames: {1}{0}Frame Time: {2}{0}", line_end_, frames.times.size(),
                      frames.frame_time.to_string());
    std::array<char, shortest_text_room> room;
    for (std::size_t k = 0; k < frames.times.size(); ++k) {
      std::string_view before;
      for (const JointNumbers& joint : joints)
        for (std::size_t i = 0; i < joint.columns.size(); ++i) {
          const double number = joint.numbers[k * joint.columns.size() + i];
          text.append(before).append(room.data(), write_shortest_text(room.data(), number));
          before = " ";
        }
      text += line_end_;
    }
  }

  void warn(const Frames& frames, const std::vector<JointNumbers>& joints) {
    std::vector<bool> is_near_lock(frames.times.size());
    for (const JointNumbers& joint : joints)
      for (const std::size_t k : joint.near_lock) is_near_lock[k] = true;
    const auto add = [&](std::string_view code, std::string message, std::string_view what, std::size_t count) {
      if (count > 0) written_.warnings.push_back(warning_of(code, std::move(message), what, count, path_));
    };
    const auto locked = static_cast<std::size_t>(std::ranges::count(is_near_lock, true));
    add("gimbal_lock",
        formatted("{} within 1° of gimbal lock, where angles may jump; another order of `output_euler` may have none",
                  counted(locked, "frame")),
        "frames", locked);
    const std::size_t scaled = scaled_joints_of(scene_, clip_);
    add("scale_dropped", formatted("{} with a scale, which BVH does not hold", counted(scaled, "joint")), "joints",
        scaled);
    const double end = clip_.domain().end, last = frames.times.back();
    if (end - last > least_rest * frames.frame_time.to_double())
      written_.warnings.push_back(
          {.code = "end_dropped",
           .message = formatted("the clip ends at {:.6g} s, between two frames, of which the last one is at {:.6g} s",
                                end, last),
           .where = {.file = path_},
           .numbers = {{"end_s", end}, {"last_frame_s", last}}});
    if (const double start = frames.times.front(); start != 0.0)
      written_.warnings.push_back({.code = "start_dropped",
                                   .message = formatted("the clip starts at {} s, its frames at 0 s", start),
                                   .where = {.file = path_},
                                   .numbers = {{"start_s", start}}});
  }

  void warn_of_detours(const Frames& frames, const Plan& plan, const std::vector<JointNumbers>& joints) {
    std::size_t worst = 0, frames_for_one = 1;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Detour& detour = joints[i].detour;
      if (detour.angle > joints[worst].detour.angle) worst = i;
      if (frames_for_one > 0 && detour.angle > largest_detour)
        frames_for_one = detour.frames_for_one == 0 ? 0 : std::max(frames_for_one, detour.frames_for_one);
    }
    if (joints.empty() || joints[worst].detour.angle <= largest_detour) return;
    const Detour& largest = joints[worst].detour;
    const double rate = static_cast<double>(frames_for_one) / frames.frame_time.to_double();
    const std::string cure =
        frames_for_one == 0 ? formatted("{} times as many frames are too few; another order of `output_euler` may do",
                                        most_frames_for_one)
                            : formatted("the `rate` {:.6g} stays within {:g}°", rate, largest_detour * degrees);
    written_.warnings.push_back(
        {.code = "euler_detour",
         .message = formatted("players that turn each angle by itself from frame to frame lead up to {:.3g}° away from "
                              "the motion, joint {} from {:.6g} s on; {}",
                              largest.angle * degrees, in_quotes(plan[worst].name), frames.times[largest.frame], cure),
         .where = {.file = path_},
         .numbers = {{"detour_deg", largest.angle * degrees}, {"rate_hz", frames_for_one == 0 ? 0.0 : rate}}});
  }

  const Scene& scene_;
  const Clip& clip_;
  const std::string& path_;
  const SceneWriting& writing_;
  const Source* source_;
  std::string_view line_end_{};
  SceneWritten written_{};
};

}  // namespace

Expected<SceneWritten> write(const Scene& scene, const std::string& path, const SceneWriting& writing) {
  const auto clip = only_clip(scene);
  if (!clip) return tl::unexpected(clip.error());
  const auto order = order_of(writing);
  if (!order) return tl::unexpected(order.error());
  return Writer(scene, **clip, path, writing).write(*order);
}

}}}  // namespace orispline::scenes::bvh
