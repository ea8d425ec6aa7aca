// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_keys.hpp"

#include <algorithm>

#include <orispline/analysis/sampled.hpp>
#include <orispline/base/formatted.hpp>

#include "output/standard_output.hpp"

namespace orispline::cli {
namespace {

/// Rows are sorted by an option of another name here, where that of this name is for the table.
Error with_its_options(Error error) {
  if (error.remedy == "sort") error.remedy = "sort_rows";
  return error;
}

/// A file that was read, if its keys are at least two.
Expected<io::TrackFile> with_two_keys(Expected<io::TrackFile> file) {
  if (!file) return tl::unexpected(with_its_options(std::move(file.error())));
  warn(file->warnings);
  if (file->track.keys.size() < 2)
    return failure(ErrorCode::bad_data, "found 1 key, wanted 2 at least to compare curves", {.file = file->track.name});
  return file;
}

Expected<io::TrackFile> input_of(const CompareRequest& request) {
  return with_two_keys(io::read_track(request.input.path, request.input.read, request.input.signs));
}

Expected<ComparedKeys> decimated(const Track& input, const Decimation& decimation) {
  const auto kept = kept_samples(decimation, input.keys.size());
  if (kept.size() < 2)
    return failure(ErrorCode::bad_data,
                   formatted("--keep-every {} leaves 1 of the {} samples, wanted 2 keys at least",
                             decimation.keep_every, input.keys.size()),
                   {.file = input.name});
  return ComparedKeys{decimation, input.at(kept), kept.back() + 1};
}

Expected<ComparedData> decimated_input(const CompareRequest& request) {
  auto input = input_of(request);
  if (!input) return tl::unexpected(std::move(input.error()));
  const Track& track = input->track;
  ComparedData data{.reference = track.name,
                    .epoch = track.epoch,
                    .samples = track.keys,
                    .times = {track.keys.times().begin(), track.keys.times().end()},
                    .key_sets = {},
                    .repairs = input->repairs};
  for (const Decimation& decimation : request.decimations) {
    auto key_set = decimated(track, decimation);
    if (!key_set) return tl::unexpected(std::move(key_set.error()));
    data.key_sets.push_back(std::move(*key_set));
  }
  return data;
}

Expected<ComparedData> input_and_reference(const CompareRequest& request, const std::string& reference) {
  auto input = input_of(request);
  if (!input) return tl::unexpected(std::move(input.error()));
  const auto truth = with_two_keys(io::read_track_beside(*input, reference, request.input.read));
  if (!truth) return tl::unexpected(truth.error());
  const Track& keys = input->track;
  const double shift = (truth->track.epoch - keys.epoch).to_double();
  std::vector<double> times(truth->track.keys.times().begin(), truth->track.keys.times().end());
  for (double& t : times) t += shift;
  const Domain domain{keys.keys.times().front(), keys.keys.times().back()};
  const std::size_t compared = times_within(times, domain).count;
  const auto text = [&](double t) { return (keys.epoch + Decimal::from_double(t)).to_string(); };
  if (compared == 0)
    return failure(ErrorCode::bad_data,
                   formatted("none of the {} times, {} to {} s, lies between the keys of {}, {} to {} s", times.size(),
                             text(times.front()), text(times.back()), keys.name, text(domain.start), text(domain.end)),
                   {.file = reference});
  const auto is_key = [&](double t) { return std::ranges::binary_search(keys.keys.times(), t); };
  if (std::ranges::all_of(times, [&](double t) { return !domain.contains(t) || is_key(t); }))
    warn(
        {Warning{.code = "no_reference_between_keys",
                 .message = "all samples that are compared are at the times of keys, where every curve through them is "
                            "right; wanted a denser reference, or INPUT and --reference the other way round",
                 .where = {.file = reference}}});
  ComparedData data{.reference = reference,
                    .epoch = keys.epoch,
                    .samples = truth->track.keys,
                    .times = std::move(times),
                    .key_sets = {},
                    .repairs = input->repairs};
  data.key_sets.push_back({std::nullopt, keys, compared});
  return data;
}

}  // namespace

Expected<ComparedData> compared_data(const CompareRequest& request, const std::optional<std::string>& reference) {
  return reference ? input_and_reference(request, *reference) : decimated_input(request);
}

}  // namespace orispline::cli
