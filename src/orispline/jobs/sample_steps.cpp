// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/sample_steps.hpp>

#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

Expected<Track> as_read_again(const Track& keys) {
  Track track = keys;
  track.epoch = keys.time_of(0);
  track.positions_apart = {};  // which files of keys do not have
  KeyframeData data = keys.keys.data();
  for (std::size_t k = 0; k < data.times.size(); ++k) {
    data.times[k] = (keys.time_of(k) - track.epoch).to_double();
    data.orientations[k] = keys.written(k);
  }
  return Keyframes::make(std::move(data), keys.recipe.signs).map([&](const Keyframes& read) {
    track.keys = read;
    return track;
  });
}

SampleOutcome outcome_of_joint(std::string source, const PoseCurve& curve) {
  const Domain domain = curve.orientation.domain();
  return {.source = std::move(source),
          .method = std::string(stored_method),
          .method_text = "the motion that is stored",
          .keys = curve.orientation.knots().times().size(),
          .start = Decimal::from_double(domain.start),
          .end = Decimal::from_double(domain.end)};
}

std::vector<std::size_t> moved_joints(const Skeleton& skeleton, const Clip& clip, JointSpace space) {
  std::vector<bool> moves(skeleton.size());
  for (const RotationChannel& channel : clip.rotations) moves[channel.joint] = true;
  for (const auto* const channels : {&clip.translations, &clip.scales})
    for (const VectorChannel& channel : *channels) moves[channel.joint] = true;
  std::vector<std::size_t> joints;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::size_t parent = skeleton[i].parent;
    if (space == JointSpace::world && parent != no_parent && moves[parent]) moves[i] = true;
    if (moves[i]) joints.push_back(i);
  }
  return joints;
}

void count_rows(SampleOutcome& outcome, const RowPolicy& policy, const RowCounts& counts) {
  outcome.held_samples = counts.outside;
  outcome.leaves_out = policy.outside == OutsideRows::left_out;
  outcome.gap_samples = counts.in_gaps;
  outcome.without_band = counts.without_band;
  outcome.marks_gaps = policy.gaps == GapRows::empty;
  outcome.samples = counts.rows(policy);
}

}}}  // namespace orispline::jobs
