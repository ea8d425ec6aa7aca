// SPDX-License-Identifier: Apache-2.0
#include "compare_keys.hpp"

#include <fmt/format.h>

#include <orispline/analysis/sampled.hpp>

namespace orispline::cli {
namespace {

/// A file and its keys, which are at least two.
struct Read {
  io::KeyFile file;
  Keyframes keys;
};

Expected<Read> read_two_keys(const std::string& path, const io::ReadOptions& options, Signs signs) {
  auto file = io::read_keys(path, options);
  if (!file) return tl::unexpected(std::move(file.error()));
  auto keys = Keyframes::make(file->data, signs);
  if (!keys) return tl::unexpected(located(*file, keys.error()));
  if (keys->size() < 2)
    return failure(ErrorCode::bad_data, "found 1 key, wanted 2 at least to compare curves", {.file = path});
  return Read{std::move(*file), std::move(*keys)};
}

/// What errors and options need of the file of those keys.
io::KeyFile kept_file(const io::KeyFile& file, std::span<const std::size_t> kept) {
  io::KeyFile result{.path = file.path, .format = file.format, .epoch = file.epoch};
  for (const std::size_t i : kept) result.lines.push_back(file.lines[i]);
  return result;
}

Expected<KeySet> decimated(const Read& input, const Decimation& decimation, Signs signs) {
  const auto kept = kept_samples(decimation, input.keys.size());
  if (kept.size() < 2)
    return failure(ErrorCode::bad_data,
                   fmt::format("--keep-every {} leaves 1 of the {} samples, wanted 2 keys at least",
                               decimation.keep_every, input.keys.size()),
                   {.file = input.file.path});
  io::KeyFile file = kept_file(input.file, kept);
  auto keys = Keyframes::make(kept_keys(input.file.data, kept), signs);
  if (!keys) return tl::unexpected(located(file, keys.error()));
  return KeySet{decimation, std::move(file), std::move(*keys), kept.back() + 1};
}

Expected<ComparedData> decimated_input(const CompareRequest& request) {
  auto input = read_two_keys(request.input.path, request.input.read, request.input.signs);
  if (!input) return tl::unexpected(std::move(input.error()));
  ComparedData data{.reference = input->file.path,
                    .epoch = input->file.epoch,
                    .samples = input->keys,
                    .times = {input->keys.times().begin(), input->keys.times().end()},
                    .key_sets = {},
                    .repairs = input->file.repairs};
  for (const Decimation& decimation : request.decimations) {
    auto key_set = decimated(*input, decimation, request.input.signs);
    if (!key_set) return tl::unexpected(std::move(key_set.error()));
    data.key_sets.push_back(std::move(*key_set));
  }
  return data;
}

Expected<ComparedData> input_and_reference(const CompareRequest& request, const std::string& reference) {
  auto input = read_two_keys(request.input.path, request.input.read, request.input.signs);
  if (!input) return tl::unexpected(std::move(input.error()));
  const auto truth =
      read_two_keys(reference, {.conjugate = request.input.read.conjugate, .world_rates = true}, Signs::shortest);
  if (!truth) return tl::unexpected(truth.error());
  const double shift = (truth->file.epoch - input->file.epoch).to_double();
  std::vector<double> times(truth->keys.times().begin(), truth->keys.times().end());
  for (double& t : times) t += shift;
  const Domain domain{input->keys.times().front(), input->keys.times().back()};
  const std::size_t compared = times_within(times, domain).count;
  const auto text = [&](double t) { return (input->file.epoch + io::Decimal::from_double(t)).to_string(); };
  if (compared == 0)
    return failure(
        ErrorCode::bad_data,
        fmt::format("none of the {} times, {} to {} s, lies between the keys of {}, {} to {} s", times.size(),
                    text(times.front()), text(times.back()), input->file.path, text(domain.start), text(domain.end)),
        {.file = reference});
  ComparedData data{.reference = reference,
                    .epoch = input->file.epoch,
                    .samples = truth->keys,
                    .times = std::move(times),
                    .key_sets = {},
                    .repairs = input->file.repairs};
  input->file.data = {};
  data.key_sets.push_back({std::nullopt, std::move(input->file), std::move(input->keys), compared});
  return data;
}

}  // namespace

Expected<ComparedData> compared_data(const CompareRequest& request, const std::optional<std::string>& reference) {
  return reference ? input_and_reference(request, *reference) : decimated_input(request);
}

}  // namespace orispline::cli
