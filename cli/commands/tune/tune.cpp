// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <orispline/fields.hpp>
#include <orispline/jobs/tune.hpp>

#include "options/file_places.hpp"
#include "output/keys_file.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  std::optional<Method> named;
  orispline::TuneOptions tuning;
};

/// The file that `reference` is in.
const std::optional<std::string>& reference_of(const TuneArguments& options) {
  return options.tuning.find("reference")->second;
}

/// What the files ask of each other.
Expected<void> agree(const TuneArguments& options) {
  if (options.output.empty()) return usage_failure("-o: found an empty name, wanted FILE or -");
  if (auto checked = check_summary(options.summary, options.output, "keys"); !checked) return checked;
  std::vector<OtherFile> others{{"INPUT", options.input.path}};
  if (const auto& reference = reference_of(options)) others.push_back({"that of --reference", *reference});
  auto output = check_output_apart("-o", options.output, others).and_then([&] {
    return check_extension("-o", options.output, {".csv", ".txt"});
  });
  if (!output) return output;
  if (options.input.path == io::standard_stream && reference_of(options) == io::standard_stream)
    return usage_failure("found '-' for INPUT and --reference, wanted it for one at most");
  return {};
}

/// Whether the columns of INPUT are understood without an option: only then can the output have them.
bool reads_the_same_again(const InputOptions& o) {
  constexpr std::array about_rows{"signs", "ignore_recipe", "drop_duplicates", "drop_invalid", "sort"};
  return std::ranges::none_of(o.reading, [&](const auto& option) {
    return option.second.are_given() && std::ranges::find(about_rows, option.first) == about_rows.end();
  });
}

Expected<Request> request_in(const TuneArguments& options) {
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

Expected<std::shared_ptr<const Track>> read_reference(const TuneArguments& options, const io::TrackFile& keys,
                                                      const io::ReadOptions& reading) {
  const auto& path = reference_of(options);
  if (!path) return nullptr;
  return io::read_track_beside(keys, *path, reading).map([](io::TrackFile file) {
    warn(file.warnings);
    return std::make_shared<const Track>(std::move(file.track));
  });
}

/// The keys with the values that were found; what their table states itself keeps its text there.
Track written_track(const jobs::TuneOutcome& outcome) {
  const Track& given = *outcome.request.keys;
  Track keys = outcome.tuning.track;
  std::erase_if(keys.settings, [&](const auto& column) {
    const auto same = given.settings.find(column.first);
    return same != given.settings.end() && *same == column && !given.table.rows.empty();
  });
  return keys;
}

}  // namespace

Expected<void> tune(const TuneArguments& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto input = io::KeyInput::open(request->input.path, request->input.read);
  if (!input) return tl::unexpected(std::move(input.error()));
  auto chosen = chosen_method(request->named, options.shape, *input, jobs::usual_tuned);
  if (!chosen) return tl::unexpected(std::move(chosen.error()));
  warn(std::exchange(chosen->warnings, {}));
  request->input.read.parameters = open_parameters(chosen->method);
  request->input.read.rate_orders = jobs::family_of(chosen->method).rate_orders;
  auto file = io::read_track(std::move(*input), request->input.read, request->input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  warn(file->warnings);
  auto reference = read_reference(options, *file, request->input.read);
  if (!reference) return tl::unexpected(std::move(reference.error()));
  auto outcome = jobs::tune({.keys = std::make_shared<const Track>(std::move(file->track)),
                             .method = std::move(*chosen),
                             .reference = std::move(*reference),
                             .options = request->tuning});
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  warn(outcome->warnings);
  return write_keys(options.output, written_track(*outcome)).and_then([&] {
    return summarise(options.summary,
                     Written{options.input.path, options.output, "keys with tensions", std::move(*outcome)});
  });
}

}  // namespace orispline::cli
