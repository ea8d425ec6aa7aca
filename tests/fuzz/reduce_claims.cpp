// SPDX-License-Identifier: Apache-2.0
#include <fuzz/optimise_claims.hpp>
#include <fuzz/outcome_claims.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/reduce/tolerance_check.hpp>

namespace orispline::fuzz {

namespace {

void claim_within(const jobs::ReduceOutcome& outcome) {
  const Reduction& reduction = outcome.chosen();
  const Keyframes& samples = outcome.reduced().keys;
  const auto& kept = reduction.samples;
  const Tolerance& tolerance = outcome.options.tolerance;
  claim(kept.size() == reduction.track.keys.size() && kept.front() == 0 && kept.back() == samples.size() - 1,
        "{} keys at {} samples from {} to {}", reduction.track.keys.size(), kept.size(), kept.front(), kept.back());
  claim(reduction.deviation.angle <= tolerance.angle, "its deviation is {}", reduction.deviation.angle);
  const auto curve = make_pose_curve(reduction.method, reduction.track.keys);
  claim(curve.has_value(), "the result has no curve: {}", curve ? "" : describe(curve.error()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = samples.times()[i];
    const double off = angular_distance(curve->orientation(t), samples.orientations()[i]);
    claim(off <= tolerance.angle + angle_rounding, "sample {} is missed by {} rad", i, off);
    if (!tolerance.bounds_positions()) continue;
    const double away = (curve->position->linear_motion(t).position - samples.positions()[i]).norm();
    claim(away <= tolerance.position * (1.0 + 1e-9), "sample {} is missed by {} m", i, away);
  }
}

}  // namespace

void try_reduce(TaskInput& input) {
  constexpr std::array names{"auto", "timed-c2", "slerp", "hermite-c1", "squad-timed", "tcb"};
  ReduceOptions options{.tolerance = {.angle = std::pow(10.0, -static_cast<double>(input.options.below(7)))}};
  Flags flags(input.options);
  if (flags.next()) options.values = KeyValues::refitted;
  if (flags.next()) options.tolerance.position = 0.1;
  jobs::ReduceRequest request{
      .recordings = {input.recording}, .methods = {input.chosen(names)}, .options = options, .threads = 1};
  Flags more(input.more);
  if (more.next()) request.smoothing = SmoothOptions{.adapt = more.next()};
  if (more.next()) request.methods.emplace_back("hermite-c1");
  const Situation situation([&] {
    return fmt::format("reduce to {} rad by {}, smoothed {}", options.tolerance.angle, text_of(request.methods.front()),
                       request.smoothing.has_value());
  });
  const Stopwatch stopwatch;
  const auto outcomes = jobs::reduce(request);
  claim(outcomes.size() == 1, "{} outcomes", outcomes.size());
  if (!outcomes.front()) return claim_plain(outcomes.front().error());
  claim_told(*outcomes.front());
  claim_within(*outcomes.front());
}

}  // namespace orispline::fuzz
