// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/tune/tune_fields.hpp>

#include "commands/tune/tune_report.hpp"
#include "options/file_places.hpp"
#include "output/keys_file.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  std::optional<Method> named;
  orispline::TuneOptions tuning;
};

/// The file that `reference` is in.
const std::optional<std::string>& reference_of(const TuneOptions& options) {
  return options.tuning.find("reference")->second;
}

/// What the files ask of each other.
Expected<void> agree(const TuneOptions& options) {
  if (options.output.empty()) return usage_failure("-o: found an empty name, wanted FILE or -");
  if (auto checked = check_summary(options.summary, options.output, "keys"); !checked) return checked;
  std::vector<OtherFile> others{{"INPUT", options.input.path}};
  if (const auto& reference = reference_of(options)) others.push_back({"that of --reference", *reference});
  const auto output = check_output_apart("-o", options.output, others).and_then([&] {
    return check_extension("-o", options.output, {".csv", ".txt"});
  });
  if (!output) return output;
  if (options.input.path == io::standard_stream && reference_of(options) == io::standard_stream)
    return usage_failure("found '-' for INPUT and --reference, wanted it for one at most");
  return {};
}

bool has_tensions(const FamilyInfo& family) { return std::ranges::any_of(family.parameters, &Parameter::tunable); }

/// Whether the columns of INPUT are understood without an option: only then can the output have them.
bool reads_the_same_again(const InputOptions& o) {
  constexpr std::array about_rows{"signs", "ignore_recipe", "drop_duplicates", "drop_invalid", "sort"};
  return std::ranges::none_of(o.reading, [&](const auto& option) {
    return option.second.are_given() && std::ranges::find(about_rows, option.first) == about_rows.end();
  });
}

Expected<Request> request_in(const TuneOptions& options) {
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .named = checked(named_method(options.method, options.shape)),
                  .tuning = checked(options_in<orispline::TuneOptions>(options.tuning))};
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  if (auto agreed = agree(options); !agreed) return tl::unexpected(std::move(agreed.error()));
  read->input.read.keep_table = reads_the_same_again(options.input);
  return read;
}

/// A recording in the times of the keys.
struct Reference {
  std::vector<double> times;
  std::vector<Eigen::Quaterniond> orientations;
};

Expected<Reference> read_reference(const std::string& path, const io::TrackFile& keys, const io::ReadOptions& reading) {
  const auto file = io::read_track_beside(keys, path, reading);
  if (!file) return tl::unexpected(file.error());
  warn(file->warnings);
  const Track& samples = file->track;
  const double shift = (samples.epoch - keys.track.epoch).to_double();
  Reference reference{{samples.keys.times().begin(), samples.keys.times().end()},
                      {samples.keys.orientations().begin(), samples.keys.orientations().end()}};
  for (double& t : reference.times) t += shift;
  return reference;
}

Expected<orispline::Tuning> tuned(Request request, const Method& method, const TuneOptions& options,
                                  const io::TrackFile& keys) {
  Reference reference;
  if (const auto& path = reference_of(options)) {
    auto read = read_reference(*path, keys, request.input.read);
    if (!read) return tl::unexpected(std::move(read.error()));
    reference = std::move(*read);
    request.tuning.reference = {reference.times, reference.orientations};
  }
  return orispline::tune(keys.track, method, request.tuning).map_error([&](Error error) {
    return jobs::placed(keys.track, std::move(error));
  });
}

/// The keys with the values that were found; what their table states itself keeps its text there.
Track written_track(const orispline::Tuning& tuning, const Track& given) {
  Track keys = tuning.track;
  std::erase_if(keys.settings, [&](const auto& column) {
    const auto same = given.settings.find(column.first);
    return same != given.settings.end() && *same == column && !given.table.rows.empty();
  });
  return keys;
}

}  // namespace

Expected<void> tune(const TuneOptions& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto input = io::KeyInput::open(request->input.path, request->input.read.recipe);
  if (!input) return tl::unexpected(std::move(input.error()));
  const auto chosen = chosen_method(request->named, options.shape, *input, {default_tuned_method, has_tensions});
  if (!chosen) return tl::unexpected(chosen.error());
  warn(chosen->warnings);
  request->input.read.parameters = open_parameters(chosen->method);
  request->input.read.rate_orders = family_of(chosen->method).rate_orders;
  const auto file = io::read_track(std::move(*input), request->input.read, request->input.signs);
  if (!file) return tl::unexpected(file.error());
  warn(file->warnings);
  auto tuning = tuned(*request, chosen->method, options, *file);
  if (!tuning) return tl::unexpected(std::move(tuning.error()));
  warn(tuning->warnings);
  TuneReport report{.input = options.input.path,
                    .output = options.output,
                    .objective = request->tuning.objective,
                    .times = {file->track.keys.times().begin(), file->track.keys.times().end()},
                    .tuning = std::move(*tuning)};
  for (double& t : report.times) t += file->track.epoch.to_double();
  return write_keys(options.output, written_track(report.tuning, file->track)).and_then([&] {
    return summarise(options.summary, report);
  });
}

}  // namespace orispline::cli
