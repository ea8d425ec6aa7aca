// SPDX-License-Identifier: Apache-2.0
#include "commands/mean/mean.hpp"

#include <memory>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/fields.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/mean.hpp>

#include "options/option_text.hpp"
#include "output/each_input.hpp"
#include "output/found_output.hpp"
#include "output/keys_file.hpp"
#include "output/repairs_text.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  io::SampleColumns columns;
  orispline::MeanOptions mean;
};

Expected<Request> request_in(const MeanArguments& options, const std::vector<std::string>& paths) {
  std::vector<OtherFile> others;
  others.reserve(paths.size());
  for (const std::string& path : paths) others.push_back({"INPUT", path});
  InputOptions first = options.input;
  first.path = paths.front();
  FirstError checked;
  Request request{.input = checked(input_request(first)),
                  .columns = checked(columns_of_made(options.output, options.summary, {"mean", "the mean"}, others)),
                  .mean = checked(options_in<orispline::MeanOptions>(options.mean))};
  request.input.read.rate_orders = 0;
  request.input.read.count_rows = !request.mean.every && !request.input.read.session;
  request.input.read.parameters = {std::string(jobs::weight_name)};
  return std::move(checked).or_else(std::move(request));
}

/// The rows of all files, as they are averaged, and what the first one says of a file of their mean.
struct Rows {
  jobs::MeanRequest job;
  io::SampleColumns columns;
  std::string mended{};
};

Expected<Rows> rows_of(const MeanArguments& options, const Request& request, const std::vector<std::string>& paths) {
  std::vector<Track> tracks;
  Rows rows{.job = {.rows = {}, .options = request.mean, .has_times = !request.input.read.count_rows},
            .columns = request.columns};
  for (const std::string& path : paths) {
    auto file = io::read_track(path, request.input.read, request.input.signs);
    if (!file) return tl::unexpected(std::move(file.error()));
    warn(file->warnings);
    if (tracks.empty()) rows.columns = columns_like(*file->format, request.columns, options.output);
    if (const std::string mended = text_of(file->repairs); !mended.empty())
      rows.mended += (rows.mended.empty() ? "" : "; ") + (paths.size() > 1 ? printable(path) + ": " : "") + mended;
    tracks.push_back(std::move(file->track));
  }
  rows.columns.derivatives = 0;
  if (tracks.size() > 1)
    return jobs::mean_of_all(tracks, request.mean).map([&](jobs::MeanRequest all) {
      rows.job = std::move(all);
      return std::move(rows);
    });
  rows.job.rows = std::make_shared<const Track>(std::move(tracks.front()));
  return rows;
}

/// The files as the document names them.
Json names_of(const std::vector<std::string>& paths) {
  if (paths.size() == 1) return {{"input", paths.front()}};
  return {{"inputs", Json(paths)}};
}

struct WrittenMean : Written<jobs::MeanOutcome> {
  std::vector<std::string> inputs;
};

Json json_of(const WrittenMean& written) {
  Json json = names_of(written.inputs);
  json["output"] = written.output;
  json.update(document_of(written.outcome));
  return json;
}

Expected<void> mean_of(const MeanArguments& options, const std::vector<std::string>& paths) {
  const auto request = request_in(options, paths);
  if (!request) return tl::unexpected(request.error());
  if (paths.size() > 1 && request->mean.every)
    return usage_failure(formatted(
        "--every: found {} inputs, each with a clock of its own, wanted one, or --output-folder FOLDER for the "
        "means of each",
        paths.size()));
  if (writes_file(options.output))
    if (auto able = check_output(options.output.path); !able) return able;
  auto rows = rows_of(options, *request, paths);
  if (!rows) return tl::unexpected(std::move(rows.error()));
  auto outcome = jobs::mean(std::move(rows->job));
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  outcome->mended = std::move(rows->mended);
  warn(outcome->warnings);
  if (!writes_file(options.output)) return print_found(options.summary, *outcome, names_of(paths));
  return write_keys(options.output.path, outcome->track(), rows->columns).and_then([&] {
    return summarise(options.summary,
                     WrittenMean{{paths.front(), options.output.path, "mean", std::move(*outcome)}, paths});
  });
}

Expected<void> mean_of_one(const MeanArguments& options) { return mean_of(options, {options.input.path}); }

}  // namespace

Expected<void> mean(const MeanArguments& options) {
  if (options.inputs.folder || asks_for_all_sessions(options.input)) {
    const auto check = [](const MeanArguments& one) {
      return request_in(one, {one.input.path}).map([](const Request&) {});
    };
    return on_inputs(options, {.written = "mean", .check = check, .work = mean_of_one});
  }
  return files_of(options.inputs).and_then([&](const InputFiles& found) {
    warn(found.warnings);
    std::vector<std::string> paths;
    for (const InputFile& file : found.files) paths.push_back(file.path);
    return mean_of(options, paths);
  });
}

}  // namespace orispline::cli
