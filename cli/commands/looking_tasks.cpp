// SPDX-License-Identifier: Apache-2.0
// inspect and compare, which print what they find.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/io/key_rows.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/report/table.hpp>

#include "commands/task_command.hpp"
#include "options/file_places.hpp"
#include "options/reading_flags.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/each_input.hpp"
#include "output/gathered_output.hpp"
#include "output/json_document.hpp"
#include "output/noted_output.hpp"
#include "output/progress.hpp"
#include "output/repairs_text.hpp"
#include "output/report_file.hpp"
#include "output/standard_output.hpp"
#include "output/terminal_width.hpp"

namespace orispline::cli {

namespace {

// inspect

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

/// The keys of a file, made sound, its faults, and how its document names it.
Expected<TaskJob> inspected_keys(InputRequest input, std::vector<Method> methods) {
  input.read = read_for(methods, std::move(input.read));
  auto lenient = read_leniently(input);
  if (!lenient) return tl::unexpected(std::move(lenient.error()));
  io::KeyFile* const file = &lenient->file;
  if (input.signs) file->recipe.signs = *input.signs;
  auto scaled = scaled_to_unit(std::exchange(file->data, {}));
  auto keys = Keyframes::make(std::move(scaled.data), file->recipe.signs);
  if (!keys) return tl::unexpected(located(*file, keys.error()));
  io::TrackFile read = io::track_file(std::move(*file), *keys);
  TaskJob job{.input = std::move(input)};
  jobs::KeyFaults& faults = job.request.reading.faults;
  faults = {.duplicate_times = read.repairs.duplicates_dropped,
            .out_of_order_rows = read.repairs.rows_moved,
            .invalid_rows = read.repairs.invalid_dropped,
            .wrong_norms = scaled.wrong_norms,
            .largest_norm_error = scaled.largest_norm_error,
            .defect = lenient->several ? std::optional(describe(with_reading_flags(std::move(*lenient->several))))
                                       : defect_in(job.input, read.repairs, scaled.wrong_norms)};
  if (!faults.defect && scaled.first_error) faults.defect = describe(read.track.located(*scaled.first_error));
  for (Method& method : methods) job.request.methods.push_back({method.name, std::move(method)});
  job.names = Json({{"file", read.track.name}, {"format", read.format->id}});
  job.warnings = std::move(read.warnings);
  job.request.inputs = {{"keys", shared(std::move(read.track))}};
  return job;
}

/// The clips of a skeleton, and how its document names it.
Expected<TaskJob> inspected_scene(InputRequest input) {
  if (input.read.scene.space == io::SceneTrack::Space::world)
    return usage_failure("--space: found no joint, wanted --joint NAME as well");
  return open_scene(input).map([&](scenes::Scene scene) {
    warn(scene.warnings);
    TaskJob job{.input = std::move(input)};
    job.names = Json({{"input", scene.name}, {"input_format", scene.format->id}});
    job.request.inputs = {{"keys", motion_of(scene.name, scene)}};
    return job;
  });
}

// compare

constexpr std::size_t default_step = 8;
constexpr std::string_view all_methods_word = "all", methods_option = "--methods";
/// Progress looks at the clock only once in 4096 steps.
constexpr double progress_steps = 4096 * 1000.0;

Expected<jobs::LabelledMethod> named_method(const std::string& text, const OwnFamilies& own) {
  return method_from_text(text, own)
      .map([&](Method method) {
        return jobs::LabelledMethod{text, std::move(method)};
      })
      .map_error([](Error error) {
        if (!std::exchange(error.option, {}).empty())
          error.message = formatted("{}: {}", methods_option, error.message);
        return error;
      });
}

/// The methods of a name, which may be `all`.
Expected<std::vector<jobs::LabelledMethod>> methods_named(const std::string& name, const OwnFamilies& own) {
  if (name == all_methods_word) return jobs::all_methods();
  return named_method(name, own).map([](jobs::LabelledMethod method) { return std::vector{std::move(method)}; });
}

Expected<std::vector<jobs::LabelledMethod>> methods_in(std::span<const std::string> names, const OwnFamilies& own) {
  if (names.empty()) return jobs::all_methods();
  std::vector<jobs::LabelledMethod> methods;
  std::vector<std::string> labels;
  for (const std::string& name : names) {
    auto named = methods_named(name, own);
    if (!named) return tl::unexpected(std::move(named.error()));
    for (jobs::LabelledMethod& method : *named) {
      labels.push_back(method.label);
      methods.push_back(std::move(method));
    }
  }
  return check_differ(methods_option, labels).map([&] { return std::move(methods); });
}

Expected<std::vector<std::size_t>> steps_in(const TaskArguments& options) {
  std::vector<std::size_t> steps;
  for (const std::string& list : options.keep_every)
    for (const std::string_view piece : pieces_of(list, ',')) {
      const auto step = count_in({"--keep-every", piece}, 2);
      if (!step) return tl::unexpected(step.error());
      if (std::ranges::find(steps, *step) != steps.end())
        return usage_failure(formatted("--keep-every: found {} twice, wanted each number once", *step));
      steps.push_back(*step);
    }
  if (steps.empty()) steps.push_back(default_step);
  return steps;
}

Expected<std::vector<Decimation>> decimations_in(const TaskArguments& options) {
  const auto reference = file_of(options, "reference");
  const bool decimates = !options.keep_every.empty() || options.jitter || options.random;
  if (reference && decimates)
    return usage_failure(
        "found --reference and --keep-every, --jitter or --random, wanted a dense reference or samples of INPUT for "
        "it");
  if (reference) return std::vector<Decimation>();
  FirstError checked;
  const auto steps = checked(steps_in(options));
  const auto seed =
      checked(if_given("--random", options.random, [](OptionText text) { return count_in(text, 0); })).value_or(1);
  const Spacing spacing = options.jitter ? Spacing::jittered : options.random ? Spacing::random : Spacing::even;
  std::vector<Decimation> decimations;
  for (const std::size_t step : steps) decimations.push_back({step, spacing, seed});
  return std::move(checked).or_else(std::move(decimations));
}

/// What the options and files ask of each other.
Expected<void> check_compared_files(const TaskArguments& options) {
  const auto reference = file_of(options, "reference");
  if (options.json && options.csv) return usage_failure("found --json and --csv, wanted one of them");
  std::vector<OtherFile> others{{"INPUT", options.input.path}};
  if (reference) others.push_back({"that of --reference", *reference});
  if (auto fits = check_report(options.report, others); !fits) return fits;
  if (reference == io::standard_stream && options.input.path == io::standard_stream)
    return usage_failure("found '-' for INPUT and --reference, wanted it for one at most");
  return {};
}

Expected<TaskJob> compare_job(const TaskArguments& options) {
  FirstError checked;
  const OwnFamilies own = checked(own_families(options.shape.blending));
  const auto named = checked(method_texts(methods_option, options.methods, own));
  TaskJob job{.input = checked(input_request(options.input)), .request = request_of(options)};
  job.request.decimations = checked(decimations_in(options));
  job.request.methods = checked(methods_in(named, own));
  job.request.named = named;
  job.request.options.emplace_back("threads", std::uint64_t{checked(threads_in(options.inputs.threads))});
  auto read = std::move(checked).or_else(std::move(job));
  if (!read) return read;
  const bool has_reference = file_of(options, "reference").has_value();
  if (auto agreed = check_compared_files(options).and_then([&] { return jobs::check_task("compare", read->request); });
      !agreed)
    return tl::unexpected(std::move(agreed.error()));
  read->input.read.rate_orders = 1;
  read->input.read.world_rates = true;
  for (const jobs::LabelledMethod& method : read->request.methods) {
    read->input.read = with_columns_of(method.method, std::move(read->input.read));
    if (!has_reference) continue;
    for (std::string& name : open_parameters(method.method)) {
      auto& parameters = read->input.read.parameters;
      if (std::ranges::find(parameters, name) == parameters.end()) parameters.push_back(std::move(name));
    }
  }
  return read;
}

/// Rows are sorted by an option of another name here, where that of this name is for the table.
Error with_its_options(Error error) {
  if (error.remedy == "sort") error.remedy = "sort_rows";
  return error;
}

Expected<io::TrackFile> after_warnings(Expected<io::TrackFile> file) {
  if (!file) return tl::unexpected(with_its_options(std::move(file.error())));
  warn(file->warnings);
  return file;
}

Expected<void> read_compared(const TaskArguments& options, TaskJob& job) {
  auto file = after_warnings(io::read_track(job.input.path, job.input.read, job.input.signs));
  if (!file) return tl::unexpected(std::move(file.error()));
  job.request.reading.mended = text_of(file->repairs);
  if (const auto path = file_of(options, "reference")) {
    auto recording = after_warnings(io::read_track_beside(*file, *path, job.input.read));
    if (!recording) return tl::unexpected(std::move(recording.error()));
    job.request.inputs.emplace_back("reference", shared(std::move(recording->track)));
  }
  job.request.inputs.emplace_back("keys", shared(std::move(file->track)));
  return {};
}

Expected<jobs::TaskOutcome> compared(const TaskArguments& options, const TaskJob& job) {
  Progress bar(static_cast<std::size_t>(progress_steps),
               options.summary.quiet ? Progress::Show::never : Progress::Show::on_terminal);
  const auto show = [&](double share) { bar.advance_to(static_cast<std::size_t>(progress_steps * share)); };
  return jobs::run_task("compare", job.request, {.show = show}).map([](jobs::TaskOutcome outcome) {
    warn(outcome.warnings);
    return outcome;
  });
}

/// Exit code 0 wants one method that worked.
Expected<void> any_worked(const jobs::CompareOutcome& outcome) {
  for (const ComparedMethod& method : outcome.methods)
    if (method.measures) return {};
  return failure(ErrorCode::bad_data,
                 formatted("none of the methods could be compared; {}: {}", outcome.methods.front().label,
                           describe(outcome.methods.front().measures.error())));
}

/// In lines of so many characters: what has no room is left out, and named.
std::string tables_text(const jobs::CompareOutcome& outcome, const std::string& mended,
                        std::optional<std::size_t> width) {
  constexpr std::string_view not_shown = "The terminal is too narrow for these, which --csv and --json have too:";
  std::string text = mended.empty() ? "" : mended + "\n";
  for (const report::Table& table : tables_of(outcome))
    text.append(text.empty() ? "" : "\n").append(width ? text_of(table, *width, not_shown) : text_of(table));
  return text;
}

Expected<void> print_compared(const TaskArguments& options, const TaskJob& job, const jobs::TaskOutcome& outcome) {
  const auto& found = jobs::found<jobs::CompareOutcome>(outcome);
  return print_document(options.json  ? document(outcome.document)
                        : options.csv ? csv_of(found)
                                      : tables_text(found, job.request.reading.mended, terminal_width()))
      .and_then([&] { return any_worked(found); });
}

/// The table of one of several inputs, as a file of its own.
Expected<void> write_compared(const TaskArguments& options, const jobs::TaskOutcome& outcome) {
  const auto& found = jobs::found<jobs::CompareOutcome>(outcome);
  return any_worked(found)
      .and_then([&] { return open_output(options.output.path); })
      .and_then([&](Noted<io::OutputFile> output) {
        return output.file.write(options.json ? document(outcome.document) : csv_of(found)).and_then([&] {
          return put_in_place(std::move(output));
        });
      })
      .map([&] {
        if (!options.summary.quiet) tell(formatted("{}: {}\n", printable(options.output.path), outcome.line));
      });
}

Expected<void> compare_one(const TaskArguments& options) {
  auto job = compare_job(options);
  if (!job) return tl::unexpected(std::move(job.error()));
  auto file = ReportFile::open(options.report);
  if (!file) return tl::unexpected(std::move(file.error()));
  if (auto read = read_compared(options, *job); !read) return read;
  return compared(options, *job).and_then([&](const jobs::TaskOutcome& outcome) {
    // What was measured is shown even where the page cannot be written.
    const auto written =
        file->write([&](const auto& head) { return page_of(outcome, head); }).and_then([&] { return file->finish(); });
    const auto printed =
        options.inputs.folder ? write_compared(options, outcome) : print_compared(options, *job, outcome);
    return written ? printed : written;
  });
}

Expected<void> check_compared(const TaskArguments& options) {
  if (file_of(options, "reference") == io::standard_stream)
    return usage_failure(
        "--output-folder: found '-' for --reference, wanted a file, which is read again for each input");
  return compare_job(options).map([](const TaskJob&) {});
}

}  // namespace

Expected<void> run_inspect(const TaskArguments& arguments) {
  auto input = input_request(arguments.input);
  if (!input) return tl::unexpected(std::move(input.error()));
  if (auto apart = check_report(arguments.report, {{"INPUT", arguments.input.path}}); !apart) return apart;
  const bool is_about_scene = is_scene(*input) && arguments.methods.empty() && !input->read.scene.joint;
  if (!is_about_scene && arguments.methods.empty() && any_given(arguments.shape))
    return usage_failure("found options that shape a curve, but no curve; wanted --method as well");
  auto methods = is_about_scene ? std::vector<Method>() : method_requests(arguments.methods, arguments.shape);
  if (!methods) return tl::unexpected(methods.error());
  auto page = ReportFile::open(arguments.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  auto job =
      is_about_scene ? inspected_scene(std::move(*input)) : inspected_keys(std::move(*input), std::move(*methods));
  if (!job) return tl::unexpected(std::move(job.error()));
  auto outcome = jobs::run_task("inspect", job->request);
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  std::ranges::copy(outcome->warnings, std::back_inserter(job->warnings));
  warn(job->warnings);
  job->names.update(outcome->document);
  return page->write([&](const auto& head) { return page_of(*outcome, head); })
      .and_then([&] { return print_document(arguments.json ? document(job->names) : outcome->summary); })
      .and_then([&] { return page->finish(); });
}

Expected<void> run_compare(const TaskArguments& arguments) {
  return on_inputs(arguments, CommandOnInput<TaskArguments>{
                                  .written = "tables",
                                  .check = check_compared,
                                  .work = compare_one,
                                  .extension = arguments.json ? ".json" : io::csv_format.extensions.front()});
}

}  // namespace orispline::cli
