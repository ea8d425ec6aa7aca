// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/compared_keys.hpp>

#include <algorithm>
#include <limits>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/analysis/sampled.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Rising from the best; infinite where nothing can be said.
double rank_of(const ComparedMethod& method, const MeasureInfo& measure, const MeasureTimes& times) {
  constexpr double last = std::numeric_limits<double>::infinity();
  if (!method.measures || !measure.is_finite(*method.measures)) return last;
  const double value = measure.value(*method.measures, times).value_or(last);
  return measure.better == Better::more ? -value : value;
}

Expected<void> check_two_keys(const Track& track) {
  if (track.keys.size() >= 2) return {};
  return failure(ErrorCode::bad_data, "found 1 key, wanted 2 at least to compare curves", {.file = track.name});
}

/// Those of each stretch by themselves, and the last one before a jump, with which its time is compared.
Expected<ComparedKeys> kept(const Track& recording, const Decimation& decimation) {
  const auto all = stretches_of(recording);
  if (!all) return tl::unexpected(all.error());
  std::vector<std::size_t> samples;
  std::vector<Stretch> stretches;
  for (const Stretch& stretch : *all) {
    stretches.push_back({samples.size(), 0});
    for (const std::size_t sample : kept_samples(decimation, stretch.count)) samples.push_back(stretch.first + sample);
    const std::size_t next = stretch.first + stretch.count;
    if (next < recording.keys.size() && is_jump(recording.keys.times(), next) && samples.back() + 1 < next)
      samples.push_back(next - 1);
    stretches.back().count = samples.size() - stretches.back().first;
  }
  if (all->empty()) samples = kept_samples(decimation, recording.keys.size());
  if (samples.size() < 2)
    return failure(ErrorCode::bad_data,
                   formatted("`keep_every` {} leaves 1 of the {} samples, wanted 2 keys at least",
                             decimation.keep_every, recording.keys.size()),
                   {.file = recording.name});
  return ComparedKeys{decimation, recording.at(samples), samples.back() + 1, std::move(stretches)};
}

/// The times of a recording as they are for the keys.
std::vector<double> times_beside(const Track& keys, const Track& recording) {
  const double shift = (recording.epoch - keys.epoch).to_double();
  std::vector<double> times(recording.keys.times().begin(), recording.keys.times().end());
  for (double& t : times) t += shift;
  return times;
}

Error far_apart(const Track& keys, const Track& recording, std::span<const double> times) {
  const auto span = [&](std::span<const double> all) {
    const TimeOrigin epoch(keys.epoch);
    return keys.span_text(epoch.plus(all.front()), epoch.plus(all.back()));
  };
  const std::string of_keys = keys.name.empty() ? "" : formatted(" of {}", keys.name);
  return {.code = ErrorCode::bad_data,
          .message = formatted("none of the {} times, {}, lies between the keys{}, {}", times.size(), span(times),
                               of_keys, span(keys.keys.times())),
          .where = {.file = recording.name}};
}

/// Whether some time that is compared lies between two keys.
bool any_between_keys(std::span<const double> times, std::span<const double> keys) {
  return std::ranges::any_of(
      times, [&](double t) { return t >= keys.front() && t <= keys.back() && !std::ranges::binary_search(keys, t); });
}

Warning not_denser(const Track& recording) {
  return {.code = "no_reference_between_keys",
          .message =
              "all samples that are compared are at the times of keys, where every curve through them is right; "
              "wanted a denser `reference`, or the keys and it the other way round",
          .where = {.file = recording.name}};
}

}  // namespace

void sort_by(const MeasureInfo& measure, std::vector<ComparedMethod>& methods, const MeasureTimes& times) {
  std::ranges::stable_sort(methods, [&](const ComparedMethod& a, const ComparedMethod& b) {
    if (a.key_set != b.key_set) return a.key_set < b.key_set;
    if (a.measures.has_value() != b.measures.has_value()) return a.measures.has_value();
    return rank_of(a, measure, times) < rank_of(b, measure, times);
  });
}

std::vector<MeasureInfo> ComparedData::measures(LeaveOut leave_out,
                                                const std::optional<Eigen::Matrix3d>& inertia) const {
  std::vector groups{MeasureGroup::distance, MeasureGroup::shape, MeasureGroup::optimum, MeasureGroup::cost};
  if (any_given(samples.angular_velocities())) groups.push_back(MeasureGroup::rate);
  if (leave_out == LeaveOut::yes) groups.push_back(MeasureGroup::leave_out);
  if (inertia) groups.push_back(MeasureGroup::torque);
  return measures_of(groups);
}

Expected<ComparedData> beside_own_samples(const Track& recording, std::span<const Decimation> decimations) {
  if (auto enough = check_two_keys(recording); !enough) return tl::unexpected(std::move(enough.error()));
  ComparedData data{.reference = recording.name,
                    .epoch = recording.epoch,
                    .samples = recording.keys,
                    .times = {recording.keys.times().begin(), recording.keys.times().end()}};
  for (const Decimation& decimation : decimations) {
    auto keys = kept(recording, decimation);
    if (!keys) return tl::unexpected(std::move(keys.error()));
    data.key_sets.push_back(std::move(*keys));
  }
  return data;
}

Expected<ComparedData> beside_recording(const Track& keys, const Track& recording) {
  for (const Track* track : {&keys, &recording})
    if (auto enough = check_two_keys(*track); !enough) return tl::unexpected(std::move(enough.error()));
  std::vector<double> times = times_beside(keys, recording);
  const std::size_t compared = times_within(times, {keys.keys.times().front(), keys.keys.times().back()}).count;
  if (compared == 0) return tl::unexpected(far_apart(keys, recording, times));
  auto stretches = stretches_of(keys);
  if (!stretches) return tl::unexpected(std::move(stretches.error()));
  ComparedData data{.reference = recording.name,
                    .epoch = keys.epoch,
                    .samples = recording.keys,
                    .times = std::move(times),
                    .key_sets = {{std::nullopt, keys, compared, std::move(*stretches)}}};
  if (!any_between_keys(data.times, keys.keys.times())) data.warnings.push_back(not_denser(recording));
  return data;
}

}}  // namespace orispline
