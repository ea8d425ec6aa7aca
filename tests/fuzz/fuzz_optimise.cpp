// SPDX-License-Identifier: Apache-2.0
// Keys, or the motion through them as a sensor records it, and one of the jobs: what each promises, in time.
#include <fuzz/fuzzed_recording.hpp>
#include <fuzz/optimise_claims.hpp>
#include <fuzz/outcome_claims.hpp>
#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/jobs/inspect.hpp>
#include <orispline/jobs/tune.hpp>

namespace orispline::fuzz {

namespace {

constexpr std::size_t most_keys = 40;

void claim_finite(const DistanceStatistics& statistics) {
  for (const double number : {statistics.rms, statistics.mean, statistics.largest, statistics.median})
    claim(std::isfinite(number), "a distance is {}", number);
}

}  // namespace

void try_tune(TaskInput& input) {
  constexpr std::array names{"timed-c2", "timed-c1",           "timed-c3", "timed-sextic",
                             "quintic",  "hermite-cumulative", "nu-exact"};
  jobs::TuneRequest request{.keys = input.keys};
  TuneOptions& options = request.options;
  options.objective =
      std::array{Objective::acceleration, Objective::jerk, Objective::linearised}[input.options.below(3)];
  request.method.method = input.chosen(names);
  const std::size_t other = input.more.below(4);
  if (other > 0) options.objective = std::array{Objective::torque, Objective::curvature, Objective::fit}[other - 1];
  if (options.objective == Objective::torque) options.inertia = Eigen::Vector3d(1.0, 1.5, 2.0).asDiagonal();
  if (options.objective == Objective::fit) request.reference = input.recording;
  if (input.more.below(2) == 1) options.bounds = Interval{-0.5, 1.0};
  const Situation situation([&] {
    return fmt::format("tune {}, objective {}", text_of(request.method.method), static_cast<int>(options.objective));
  });
  const Stopwatch stopwatch;
  const auto outcome = jobs::tune(request);
  if (!outcome) return claim_plain(outcome.error());
  claim_told(*outcome);
  const Tuning& tuning = outcome->tuning;
  claim(std::isfinite(tuning.energy_before) && std::isfinite(tuning.energy_after), "energies {} and {}",
        tuning.energy_before, tuning.energy_after);
  claim(tuning.energy_after <= tuning.energy_before * (1.0 + 1e-9), "the energy rises from {} to {}",
        tuning.energy_before, tuning.energy_after);
  static_cast<void>(curve_of(tuning.method, tuning.track.keys));
}

void try_compare(TaskInput& input) {
  const Keyframes& all = input.recording->keys;
  const Decimation decimation{
      .keep_every = 1 + input.options.below(8),
      .spacing = std::array{Spacing::even, Spacing::jittered, Spacing::random}[input.options.below(3)],
      .seed = input.options.byte()};
  const auto kept = kept_samples(decimation, all.size());
  for (std::size_t i = 1; i < kept.size(); ++i) claim(kept[i - 1] < kept[i], "sample {} is kept twice", kept[i]);
  claim(kept.front() == 0 && kept.back() < all.size(), "samples {} to {} are kept", kept.front(), kept.back());
  const Keyframes keys = all.at(kept);
  std::vector<Candidate> candidates;
  for (const char* name : {"auto", "timed-c2", "squad"}) candidates.push_back({name, keys});
  const Stopwatch stopwatch;
  const MeasureOptions options{.leave_out = input.options.below(2) == 0 ? LeaveOut::no : LeaveOut::yes};
  const Comparison comparison =
      compare(candidates, {.times = all.times(), .orientations = all.orientations()}, options);
  for (const auto& measures : comparison.measures) {
    if (!measures) {
      claim_plain(measures.error());
      continue;
    }
    claim_finite(measures->distance);
    for (const double number : {measures->energies.acceleration, measures->energies.jerk,
                                measures->peaks.angular_velocity.value, measures->angle_travelled})
      claim(std::isfinite(number), "a measure is {}", number);
  }
}

void try_inspect(TaskInput& input) {
  const auto families = families_info();
  const FamilyInfo& family = families[input.options.below(families.size())];
  jobs::InspectRequest request{.keys = input.recording,
                               .methods = {fuzzed_method(input.options, family, input.fuzzed)}};
  const Situation situation([&] { return fmt::format("inspect {}", text_of(request.methods.front())); });
  const Stopwatch stopwatch;
  const auto outcome = jobs::inspect(request);
  if (!outcome) return claim_plain(outcome.error());
  claim_told(*outcome);
}

}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  constexpr std::array tasks{try_reduce, try_retime, try_smooth, try_tune, try_compare, try_inspect, try_align};
  FuzzInput input(data, size);
  const std::size_t task = input.below(tasks.size());
  const FuzzInput options = input.part(32);
  const FuzzedKeys fuzzed = fuzzed_keys(input, most_keys);
  const auto keys = Keyframes::make(fuzzed.data, fuzzed.signs);
  if (!keys) return claim_plain(keys.error()), 0;
  FuzzInput of_recording = input.part(4);
  const auto recording = fuzzed_recording(of_recording, *keys);
  if (!recording) return claim_plain(recording.error()), 0;
  TaskInput of_task{options, input, fuzzed, std::make_shared<const Track>(*keys),
                    std::make_shared<const Track>(*recording)};
  const Situation situation([&] { return told("auto", fuzzed); });
  tasks[task](of_task);
  return 0;
}
