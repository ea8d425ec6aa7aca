// SPDX-License-Identifier: Apache-2.0
#include "commands/inspect/inspect.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include <orispline/io/key_rows.hpp>
#include <orispline/jobs/inspect.hpp>

#include "commands/inspect/inspect_scene.hpp"
#include "options/reading_flags.hpp"
#include "output/json_document.hpp"
#include "output/report_file.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// A file read with every repair, so that a faulty one is reported instead of refused; of several recordings the first.
struct LenientFile {
  io::KeyFile file;
  std::optional<Error> several{};  ///< recordings, of which a task wants one
};

Expected<LenientFile> read_leniently(const InputRequest& input) {
  io::ReadOptions read = input.read;
  read.drop_duplicates = read.drop_invalid = read.sort = true;
  read.norms = io::Norms::as_they_are;
  auto file = io::read_keys(input.path, read);
  const auto alone = [](io::KeyFile found) { return LenientFile{std::move(found)}; };
  if (file || file.error().remedy != "session" || input.path == io::standard_stream) return std::move(file).map(alone);
  read.session = 1;
  return io::read_keys(input.path, read).map([&](io::KeyFile found) {
    return LenientFile{std::move(found), std::move(file.error())};
  });
}

/// What stands in the way of `sample` in a file that needed repairs; standard input cannot be read twice.
std::optional<std::string> defect_in(const InputRequest& input, const io::RepairReport& repairs,
                                     std::size_t wrong_norms) {
  const bool touched = repairs.duplicates_dropped + repairs.invalid_dropped + repairs.rows_moved + wrong_norms > 0;
  if (!touched || input.path == io::standard_stream) return std::nullopt;
  const auto strict = io::read_keys(input.path, input.read);
  return strict ? std::nullopt : std::optional(describe(with_reading_flags(strict.error())));
}

/// Quaternions of any norm but 0, scaled to 1.
struct ScaledKeys {
  KeyframeData data;
  std::size_t wrong_norms = 0;
  double largest_norm_error = 0.0;
  std::optional<Error> first_error{};  ///< of the keys as they were
};

ScaledKeys scaled_to_unit(KeyframeData data) {
  ScaledKeys scaled{.data = std::move(data)};
  for (std::size_t i = 0; i < scaled.data.orientations.size(); ++i) {
    Eigen::Quaterniond& q = scaled.data.orientations[i];
    const double norm = q.coeffs().stableNorm(), norm_error = std::abs(norm - 1.0);
    if (norm_error <= norm_error_limit || norm == 0.0) continue;
    ++scaled.wrong_norms;
    if (norm_error > io::loose_norm_limit && !scaled.first_error)
      scaled.first_error = with_reading_flags(io::norm_refused(norm, {.key = i}));
    scaled.largest_norm_error = std::max(scaled.largest_norm_error, norm_error);
    q.coeffs() /= norm;
  }
  return scaled;
}

/// The keys of a file, made sound, and its faults.
struct InspectedFile {
  const io::FormatInfo* format;
  jobs::InspectRequest request;
  std::vector<Warning> warnings;
};

Expected<InspectedFile> inspected_file(const InputRequest& input) {
  auto lenient = read_leniently(input);
  if (!lenient) return tl::unexpected(std::move(lenient.error()));
  io::KeyFile* const file = &lenient->file;
  if (input.signs) file->recipe.signs = *input.signs;
  auto scaled = scaled_to_unit(std::exchange(file->data, {}));
  auto keys = Keyframes::make(std::move(scaled.data), file->recipe.signs);
  if (!keys) return tl::unexpected(located(*file, keys.error()));
  io::TrackFile read = io::track_file(std::move(*file), *keys);
  jobs::KeyFaults faults{.duplicate_times = read.repairs.duplicates_dropped,
                         .out_of_order_rows = read.repairs.rows_moved,
                         .invalid_rows = read.repairs.invalid_dropped,
                         .wrong_norms = scaled.wrong_norms,
                         .largest_norm_error = scaled.largest_norm_error,
                         .defect = lenient->several
                                       ? std::optional(describe(with_reading_flags(std::move(*lenient->several))))
                                       : defect_in(input, read.repairs, scaled.wrong_norms)};
  if (!faults.defect && scaled.first_error) faults.defect = describe(read.track.located(*scaled.first_error));
  return InspectedFile{
      .format = read.format,
      .request = {.keys = std::make_shared<const Track>(std::move(read.track)), .faults = std::move(faults)},
      .warnings = std::move(read.warnings)};
}

Expected<void> inspect_keys(const InspectArguments& options, const InputRequest& input, std::vector<Method> methods) {
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  auto file = inspected_file(input);
  if (!file) return tl::unexpected(std::move(file.error()));
  file->request.methods = std::move(methods);
  return jobs::inspect(std::move(file->request)).and_then([&](const jobs::InspectOutcome& outcome) {
    std::ranges::copy(outcome.warnings, std::back_inserter(file->warnings));
    warn(file->warnings);
    Json json{{"file", outcome.request.keys->name}, {"format", file->format->id}};
    if (options.json) json.update(document_of(outcome));
    return page->write([&](const auto& head) { return page_of(outcome, head); })
        .and_then([&] { return print_document(options.json ? document(json) : summary_of(outcome)); })
        .and_then([&] { return page->finish(); });
  });
}

}  // namespace

Expected<void> inspect(const InspectArguments& options) {
  auto input = input_request(options.input);
  if (!input) return tl::unexpected(std::move(input.error()));
  if (auto apart = check_report(options.report, {{"INPUT", options.input.path}}); !apart) return apart;
  if (is_about_scene(options, *input)) return inspect_scene(options, *input);
  if (options.methods.empty() && any_given(options.shape))
    return usage_failure("found options that shape a curve, but no curve; wanted --method as well");
  const auto methods = method_requests(options.methods, options.shape);
  if (!methods) return tl::unexpected(methods.error());
  input->read = read_for(*methods, std::move(input->read));
  return inspect_keys(options, *input, *methods);
}

}  // namespace orispline::cli
