// SPDX-License-Identifier: Apache-2.0
#include <fuzz/optimise_claims.hpp>
#include <fuzz/outcome_claims.hpp>
#include <orispline/jobs/align.hpp>
#include <support/specimens.hpp>

namespace orispline::fuzz {

namespace {

/// The recording turned on both sides, late and by other noise; where it has positions, elsewhere and larger.
Expected<Keyframes> moved(const Keyframes& recording, TaskInput& input) {
  const Eigen::Quaterniond world = exp<double>(3.0 * input.options.vector()),
                           body = exp<double>(3.0 * input.options.vector());
  const double late = 10.0 * input.options.signed_unit();
  const double noise = std::pow(10.0, -static_cast<double>(input.options.below(9)));  // [rad], [m]
  testing_support::Dice dice(input.options.byte());
  KeyframeData data = recording.data();
  for (double& t : data.times) t += late;
  for (Eigen::Quaterniond& q : data.orientations) q = world * q * body * exp<double>(noise * dice.vector());
  for (Eigen::Vector3d& p : data.positions)
    p = 2.0 * (world * p) + Eigen::Vector3d(1.0, -2.0, 3.0) + noise * dice.vector();
  for (auto* const rates : {&data.angular_velocities, &data.angular_accelerations, &data.angular_jerks}) rates->clear();
  data.inner_leaving.clear();
  data.inner_arriving.clear();
  return Keyframes::make(std::move(data));
}

AlignOptions fuzzed_alignment(TaskInput& input) {
  Flags flags(input.more);
  AlignOptions options{
      .world_turn = !flags.next(), .body_turn = !flags.next(), .scale = !flags.next(), .translation = !flags.next()};
  if (flags.next()) options.offset = 10.0 * input.more.signed_unit();
  return options;
}

void claim_finite(const Alignment& found) {
  for (const Eigen::Quaterniond& q : {found.world, found.body})
    claim(std::abs(q.norm() - 1.0) < 1e-12, "a rotation has the norm {}", q.norm());
  for (const double number : {found.distance.rms, found.distance.largest, found.noise, found.sigmas.offset})
    claim(std::isfinite(number) && number >= 0.0, "a result is {}", number);
  claim(found.rejected.size() <= found.compared.size(), "{} of {} are rejected", found.rejected.size(),
        found.compared.size());
}

}  // namespace

void try_align(TaskInput& input) {
  auto other = moved(input.recording->keys, input);
  if (!other) return claim_plain(other.error());
  const jobs::AlignRequest request{.moved = std::make_shared<const Track>(std::move(*other)),
                                   .fixed = input.recording,
                                   .options = fuzzed_alignment(input)};
  const AlignOptions& options = request.options;
  const Situation situation([&] {
    return fmt::format("align: world {}, body {}, scale {}, translation {}, offset {}", options.world_turn,
                       options.body_turn, options.scale, options.translation, options.offset.value_or(0.0));
  });
  const Stopwatch stopwatch;
  const auto outcome = jobs::align(request);
  if (!outcome) return claim_plain(outcome.error());
  claim_told(*outcome);
  claim_finite(outcome->alignment);
  claim(outcome->aligned.keys.size() == request.moved->keys.size(), "{} keys of {}", outcome->aligned.keys.size(),
        request.moved->keys.size());
}

}  // namespace orispline::fuzz
