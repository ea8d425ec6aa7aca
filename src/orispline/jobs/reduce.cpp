// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/reduce.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/parallel.hpp>
#include <orispline/jobs/curve_of_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

Expected<void> check_positions(const Track& recording, const Tolerance& tolerance) {
  if (!tolerance.bounds_positions() || !recording.keys.positions().empty()) return {};
  return tl::unexpected(
      placed(recording, {ErrorCode::bad_data, "found no positions, wanted some", {}, "position_tolerance"}));
}

std::vector<Warning> unchecked_positions(const Track& recording, const Tolerance& tolerance) {
  if (tolerance.bounds_positions() || recording.keys.positions().empty()) return {};
  return {{.code = "positions_unchecked",
           .message = "positions are kept but not checked; add `position_tolerance` LENGTH to bound them"}};
}

Expected<ReduceOutcome> smoothed_first(ReduceOutcome outcome, const SmoothOptions& options, const Progress& progress) {
  auto smoothed = smooth({outcome.recording, options}, {.stop = progress.stop});
  if (!smoothed) return tl::unexpected(outcome.recording->located(std::move(smoothed.error())));
  outcome.warnings.insert(outcome.warnings.end(), smoothed->warnings.begin(), smoothed->warnings.end());
  outcome.smoothed = SmoothedFirst{std::move(*smoothed)};
  return outcome;
}

/// The recording as it is to be reduced.
Expected<ReduceOutcome> begun(const ReduceRequest& request, std::shared_ptr<const Track> recording,
                              const Progress& progress) {
  if (auto fits = check_positions(*recording, request.options.tolerance); !fits)
    return tl::unexpected(std::move(fits.error()));
  ReduceOutcome outcome{.recording = std::move(recording), .options = request.options};
  outcome.warnings = unchecked_positions(*outcome.recording, request.options.tolerance);
  return request.smoothing ? smoothed_first(std::move(outcome), *request.smoothing, progress) : std::move(outcome);
}

/// With the distances from the recording as it was.
Expected<ReduceOutcome> measured_raw(ReduceOutcome outcome) {
  SmoothedFirst& smoothed = *outcome.smoothed;
  const Keyframes& raw = outcome.recording->keys;
  const auto distance = distance_of(outcome.chosen(), raw, smoothed.smoothing.rejected);
  if (!distance) return tl::unexpected(distance.error());
  smoothed.raw = *distance;
  if (const auto& positions = smoothed.smoothing.positions) {
    const auto of_positions = position_distance_of(outcome.chosen(), raw, positions->rejected);
    if (!of_positions) return tl::unexpected(of_positions.error());
    smoothed.raw_positions = *of_positions;
  }
  return outcome;
}

/// Whether some keys are apart by a gap, and not by a jump.
bool has_gaps(const Reduction& reduction) {
  const auto times = reduction.track.keys.times();
  return std::ranges::any_of(reduction.stretches, [&](const Stretch& stretch) {
    return stretch.first > 0 && times[stretch.first] > times[stretch.first - 1];
  });
}

Expected<ReduceOutcome> finished(ReduceOutcome outcome, Expected<std::vector<Reduction>> reductions) {
  if (!reductions) return tl::unexpected(placed(*outcome.recording, std::move(reductions.error())));
  outcome.reductions = std::move(*reductions);
  if (outcome.reduced().recipe.gap && has_gaps(outcome.chosen()) && !outcome.chosen().track.recipe.gap)
    outcome.warnings.push_back(
        {.code = "gaps_not_stated",
         .message =
             "no length tells the gaps from the intervals between the other keys: their file cannot say where the "
             "gaps are, and a curve through them bridges these"});
  return outcome.smoothed ? measured_raw(std::move(outcome)) : std::move(outcome);
}

}  // namespace

const Reduction& ReduceOutcome::chosen() const { return reductions[smallest(reductions)]; }

const Track& ReduceOutcome::reduced() const { return smoothed ? smoothed->smoothing.track : *recording; }

std::vector<Expected<ReduceOutcome>> reduce(const ReduceRequest& request, const Progress& progress) {
  std::vector<Expected<ReduceOutcome>> outcomes(request.recordings.size());
  parallel_for(outcomes.size(), request.threads,
               [&](std::size_t i) { outcomes[i] = begun(request, request.recordings[i], progress); });
  std::vector<Track> tracks;
  for (const auto& outcome : outcomes)
    if (outcome) tracks.push_back(outcome->reduced());
  auto reductions = reduce_tracks(tracks, request.methods, request.options, request.threads, progress);
  auto next = reductions.begin();
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i]) outcomes[i] = finished(std::move(*outcomes[i]), std::move(*next++));
    if (!outcomes[i] && outcomes.size() > 1) outcomes[i].error().where.curve = i;
  }
  return outcomes;
}

}}}  // namespace orispline::jobs
