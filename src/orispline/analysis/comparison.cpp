// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/comparison.hpp>

#include <algorithm>
#include <chrono>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/analysis/sampled.hpp>
#include <orispline/base/counted_work.hpp>
#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/motion_band.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The part of a recording that lies between the first and the last key.
struct Overlap {
  std::size_t first;
  std::span<const double> times;
  std::span<const Eigen::Quaterniond> orientations;
  std::span<const Eigen::Vector3d> angular_velocities;
};

Expected<Overlap> overlap_of(const RecordedMotion& recording, Domain domain) {
  const auto [first, count] = times_within(recording.times, domain);
  if (count == 0)
    return failure(ErrorCode::bad_data, formatted("none of the {} reference times lies between the keys, {} to {} s",
                                                  recording.times.size(), domain.start, domain.end));
  const bool has_rates = !recording.angular_velocities.empty();
  return Overlap{first, recording.times.subspan(first, count), recording.orientations.subspan(first, count),
                 has_rates ? recording.angular_velocities.subspan(first, count) : recording.angular_velocities};
}

void measure_errors(Measures& measures, const SampledCurve& samples, const Overlap& truth) {
  std::vector<double> distances(truth.times.size());
  for (std::size_t i = 0; i < distances.size(); ++i)
    distances[i] = angular_distance(samples.orientations[i], truth.orientations[i]);
  measures.distance = distance_statistics(std::move(distances), truth.first);
  if (any_given(truth.angular_velocities))
    measures.rate_error = rate_statistics(samples.angular_velocities, truth.angular_velocities, truth.first);
}

/// Each of the measures takes long for many keys.
void measure_shape(Measures& measures, const AnyCurve& curve, const MeasureOptions& options, const Progress& progress) {
  if (!progress.stopped()) {
    const Continuities continuities = continuities_at_keys(curve);
    measures.continuity = continuities.in_time;
    measures.shape = continuities.of_shape;
  }
  if (!progress.stopped()) measures.energies = energies(curve, options.inertia);
  if (!progress.stopped()) measures.peaks = peaks(curve, options.inertia);
  if (!progress.stopped()) measures.angle_travelled = AngleTravelled(curve).total();
}

/// The share of the recording that the band holds which is meant to hold 90 % of it.
std::optional<double> inside_band(const Candidate& candidate, const SampledCurve& samples, const Overlap& truth) {
  const auto band = MotionBand::make(candidate.method, candidate.keys, 0.9);
  if (!band || candidate.keys.size() < 2) return std::nullopt;
  constexpr double rounding = 1e-12;  // of the angle [rad] at a key, where the band may be 0
  std::size_t inside = 0;
  for (std::size_t i = 0; i < truth.times.size(); ++i)
    inside +=
        angular_distance(samples.orientations[i], truth.orientations[i]) <= (*band)(truth.times[i]) + rounding ? 1 : 0;
  return static_cast<double>(inside) / static_cast<double>(truth.times.size());
}

bool are_equal(const Keyframes& a, const Keyframes& b) {
  return std::ranges::equal(a.times(), b.times()) &&
         std::ranges::equal(a.orientations(), b.orientations(),
                            [](const auto& p, const auto& q) { return p.coeffs() == q.coeffs(); });
}

/// For each candidate the first one whose keys have the same times and orientations.
std::vector<std::size_t> first_of_equal(std::span<const Candidate> candidates) {
  std::vector<std::size_t> firsts;
  for (const Candidate& candidate : candidates)
    firsts.push_back(static_cast<std::size_t>(
        std::ranges::find_if(candidates,
                             [&](const Candidate& other) { return are_equal(other.keys, candidate.keys); }) -
        candidates.begin()));
  return firsts;
}

/// Whether its curve has the least ∫|α|² through its keys, so that no other need be sought.
bool is_least_curve(const Candidate& candidate) {
  const Keyframes& keys = candidate.keys;
  return candidate.stretches.empty() && text_of(candidate.method) == "least" && keys.angular_velocities().empty() &&
         keys.angular_accelerations().empty();
}

/// For each candidate the one whose measures have the least ∫|α|² through its keys; none where it is to be sought.
std::vector<std::optional<std::size_t>> least_curves(std::span<const Candidate> candidates,
                                                     std::span<const std::size_t> firsts) {
  std::vector<std::optional<std::size_t>> of_first(candidates.size()), found;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (is_least_curve(candidates[i])) of_first[firsts[i]] = i;
  for (const std::size_t first : firsts) found.push_back(of_first[first]);
  return found;
}

}  // namespace

Expected<PoseCurve> curve_of(const Candidate& candidate) {
  return candidate.stretches.empty() ? make_pose_curve(candidate.method, candidate.keys)
                                     : curve_in_stretches(candidate.method, candidate.keys, candidate.stretches);
}

Expected<Measures> measure(const Candidate& candidate, const RecordedMotion& recording, const MeasureOptions& options,
                           const Progress& progress) {
  ORISPLINE_EXPECT(recording.times.size() == recording.orientations.size());
  if (candidate.keys.size() == 0) return failure(ErrorCode::bad_data, "empty: no keys");
  const auto truth = overlap_of(recording, {candidate.keys.times().front(), candidate.keys.times().back()});
  if (!truth) return tl::unexpected(truth.error());
  Measures measures;
  const Clock::time_point start = Clock::now();
  const auto curve = candidate.stretches.empty()
                         ? make_curve(candidate.method, candidate.keys)
                         : curve_of(candidate).map([](const PoseCurve& pose) { return pose.orientation; });
  if (!curve) return tl::unexpected(curve.error());
  if (progress.stopped()) return cancellation();
  measures.build_seconds = seconds_since(start);
  const bool has_rates = !truth->angular_velocities.empty();
  const auto samples =
      sampled(*curve, truth->times, has_rates ? Sampled::orientations_and_rates : Sampled::orientations);
  measures.seconds = seconds_since(start);
  measure_errors(measures, samples, *truth);
  if (candidate.stretches.empty()) measures.inside_band = inside_band(candidate, samples, *truth);
  measure_shape(measures, *curve, options, progress);
  if (options.leave_out == LeaveOut::yes && candidate.stretches.empty() && !progress.stopped())
    if (const auto error = leave_out_error(candidate.keys, candidate.method)) measures.leave_out = *error;
  if (progress.stopped()) return cancellation();
  return measures;
}

bool Comparison::any() const noexcept {
  return std::ranges::any_of(measures, [](const Expected<Measures>& m) { return m.has_value(); });
}

Comparison compare(std::span<const Candidate> candidates, const RecordedMotion& recording,
                   const MeasureOptions& options, unsigned threads, const Progress& progress) {
  Comparison comparison{.measures = std::vector<Expected<Measures>>(candidates.size()),
                        .warnings = warnings_of(options.inertia)};
  const std::vector<std::size_t> firsts = first_of_equal(candidates);
  const auto least_curve = least_curves(candidates, firsts);
  std::vector<std::optional<double>> least(candidates.size());
  CountedWork work(progress, candidates.size());
  parallel_for(candidates.size(), threads, [&](std::size_t i) {
    comparison.measures[i] = progress.stopped() ? Expected<Measures>(cancellation())
                                                : measure(candidates[i], recording, options, {.stop = progress.stop});
    if (options.least_energy && candidates[i].stretches.empty() && firsts[i] == i && !least_curve[i] &&
        !progress.stopped())
      least[i] = least_energy(candidates[i].keys);
    work.add_part();
  });
  if (options.least_energy)
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (least_curve[i] && comparison.measures[*least_curve[i]])
        least[firsts[i]] = comparison.measures[*least_curve[i]]->energies.acceleration;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (auto& measures = comparison.measures[i]) measures->least_energy = least[firsts[i]];
  return comparison;
}

}}  // namespace orispline
