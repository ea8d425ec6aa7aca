// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/clip_edits.hpp>

#include <limits>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/edit/cut.hpp>
#include <orispline/edit/root_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double most_keys = 1e7;  // of a channel

Eigen::Vector3d vector_of(UpAxis up) { return up == UpAxis::y ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ(); }

/// The part that is asked for.
Expected<Domain> part_in(const Clip& clip, const ClipEdits& edits) {
  const Domain whole = clip.domain();
  const auto time_of = [&](const std::optional<double>& stated, double otherwise,
                           std::string_view option) -> Expected<double> {
    if (!stated) return otherwise;
    const double time = key_time_near(clip, *stated);
    if (whole.contains(time)) return time;
    return bad_option(option, formatted("clip {}: found {} s, wanted a time of the clip, which is from {} s to {} s",
                                        in_quotes(clip.name), *stated, whole.start, whole.end));
  };
  return time_of(edits.from, whole.start, "from").and_then([&](double from) {
    return time_of(edits.to, whole.end, "to").and_then([&](double to) -> Expected<Domain> {
      if (from < to || (from == to && !edits.from && !edits.to)) return Domain{from, to};
      return bad_option(edits.to ? "to" : "from",
                        formatted("clip {}: found a part from {} s to {} s, wanted one that ends later than it starts",
                                  in_quotes(clip.name), from, to));
    });
  });
}

/// A cubic may pass through 0 where it is cut.
Expected<Clip> checked(const Skeleton& skeleton, Clip clip) {
  return check_clip(skeleton, clip).map([&] { return std::move(clip); });
}

Expected<void> add_loop(const Skeleton& skeleton, ClipEdit& edit, const ClipEdits& edits, const EditedJoints& joints) {
  const LoopRoot root{joints.root, vector_of(edits.up)};
  if (edits.period_from || edits.period_to) {
    const auto best = best_period(
        skeleton, edit.clip,
        {edits.period_from.value_or(0.0), edits.period_to.value_or(std::numeric_limits<double>::infinity())}, root);
    if (!best) return tl::unexpected(best.error());
    edit.clip = part_of(edit.clip, *best);
    if (!edits.reverse && edits.speed == 1.0 && !edit.blend) edit.part = *best;
  }
  const bool was_found = edits.period_from || edits.period_to;
  return looped(skeleton, edit.clip, root, was_found ? ClosingKey::is_there : ClosingKey::may_lack)
      .map([&](ClipLoop loop) {
        edit.clip = std::exchange(loop.clip, {});
        edit.loop = std::move(loop);
      });
}

Expected<void> add_clip(const Skeleton& skeleton, ClipEdit& edit, const ClipEdits& edits, const EditedJoints& joints,
                        const AppendedClip& appended) {
  JoinOptions options{.root = joints.root, .up = vector_of(edits.up)};
  if (edits.blend) options.blend = *edits.blend;
  return with_joints_of(skeleton, edit.clip, appended.skeleton, appended.clip)
      .and_then([&](const Clip& second) { return joined(skeleton, edit.clip, second, options); })
      .map([&](JoinedClip all) {
        edit.clip = std::move(all.clip);
        edit.blend = all.blend;
        edit.appended_turn = all.turn;
      });
}

Expected<void> move_root(const Skeleton& skeleton, ClipEdit& edit, const ClipEdits& edits, const EditedJoints& joints) {
  RootMotion motion{.joint = joints.in_place, .up = vector_of(edits.up)};
  if (joints.extracted != no_parent) {
    motion.joint = joints.extracted;
    motion.node = joints.node == no_parent ? topmost_above(skeleton, joints.extracted) : joints.node;
    if (motion.node == no_parent)
      return bad_option("extract_root",
                        formatted("found {}, above which there is no node, wanted a joint below one, or `in_place`",
                                  in_quotes(skeleton.shown_name(motion.joint))));
  }
  if (motion.joint == no_parent) return {};
  edit.taken = travel_of(skeleton, edit.clip, motion.joint, motion.up);
  return with_root_motion(skeleton, edit.clip, motion).map([&](Clip moved) { edit.clip = std::move(moved); });
}

}  // namespace

Expected<void> check(const ClipEdits& edits) {
  if (auto sound = check_ranges(edits); !sound) return sound;
  for (const auto& [name, is_given] :
       {std::pair{"period_from", edits.period_from.has_value()}, std::pair{"period_to", edits.period_to.has_value()}})
    if (is_given && !edits.loop) return bad_option(name, "found a period without `loop`, wanted both");
  if (edits.period_from && edits.period_to && *edits.period_from > *edits.period_to)
    return bad_option("period_to", formatted("found {} s, wanted no less than `period_from`, which is {} s",
                                             *edits.period_to, *edits.period_from));
  return {};
}

Expected<ClipEdit> edited(const Skeleton& skeleton, const Clip& clip, const ClipEdits& edits,
                          const EditedJoints& joints, const AppendedClip* appended) {
  if (auto sound = check(edits); !sound) return tl::unexpected(std::move(sound.error()));
  const auto part = part_in(clip, edits);
  if (!part) return tl::unexpected(part.error());
  ClipEdit edit{.clip = clip, .before = clip.domain(), .part = *part};
  if (edits.from || edits.to) edit.clip = part_of(clip, *part);
  auto cut = checked(skeleton, std::move(edit.clip));
  if (!cut) return tl::unexpected(std::move(cut.error()));
  edit.clip = *std::move(cut);
  if (edits.reverse) edit.clip = reversed(std::move(edit.clip));
  if (edits.speed != 1.0) edit.clip = with_speed(std::move(edit.clip), edits.speed);
  Expected<void> done{};
  if (appended) done = add_clip(skeleton, edit, edits, joints, *appended);
  if (done && edits.loop) done = add_loop(skeleton, edit, edits, joints);
  if (done) done = move_root(skeleton, edit, edits, joints);
  if (!done) return tl::unexpected(std::move(done.error()));
  if (edits.rate) {
    const Domain whole = edit.clip.domain();
    if (const double keys = (whole.end - whole.start) * *edits.rate; keys > most_keys)
      return bad_option("rate", formatted("clip {}: found {:.4g} keys, wanted {:.0g} at most", in_quotes(clip.name),
                                          keys, most_keys));
    edit.clip = resampled(std::move(edit.clip), *edits.rate);
  }
  if (edits.shift) edit.clip = shifted(std::move(edit.clip), *edits.shift - edit.clip.domain().start);
  return edit;
}

}}  // namespace orispline
