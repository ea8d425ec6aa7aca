// SPDX-License-Identifier: Apache-2.0
// smooth, reduce, mean and align: tasks about recordings.
#include <utility>
#include <variant>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/fields.hpp>
#include <orispline/io/rates_file.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/sample_steps.hpp>

#include "commands/gyro_files.hpp"
#include "commands/task_command.hpp"
#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/each_input.hpp"
#include "output/found_output.hpp"
#include "output/gathered_output.hpp"
#include "output/keys_file.hpp"
#include "output/repairs_text.hpp"
#include "output/rows_file.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view all_in_scene = "an output such as all.glb";

// smooth

/// What is read once only.
Expected<void> check_times_file(const TaskArguments& arguments) {
  const auto& list = arguments.rows.list;
  if (!list) return {};
  if (*list == io::standard_stream && (arguments.inputs.folder || arguments.input.path == io::standard_stream))
    return usage_failure("--times: found '-', wanted a file, since standard input is read once only");
  return check_output_apart(arguments.output.option, arguments.output.path,
                            {{"INPUT", arguments.input.path}, {"that of --times", *list}});
}

Expected<TaskJob> smooth_job(const TaskArguments& arguments) {
  if (auto agreed = check_times_file(arguments).and_then([&] { return check_files(arguments); }); !agreed)
    return tl::unexpected(std::move(agreed.error()));
  const bool are_samples = arguments.rows.names_times();
  if (const auto given = first_given(arguments.rows); !are_samples && !given.empty())
    return usage_failure(formatted("{}: wanted --rate as well", given));
  if (are_samples && is_given(arguments.fields, "sigma"))
    return usage_failure(
        "--sigma: found --rate as well, wanted keys, which have columns for it, or --band 0.9 for samples");
  const bool has_gyro_file = file_of(arguments, "gyro").has_value();
  FirstError checked;
  TaskJob job{.input = checked(input_request(arguments.input)), .request = request_of(arguments)};
  if (arguments.rows.band) job.request.options.emplace_back("sigma", true);
  if (has_gyro_file && !is_given(arguments.fields, "gyro")) job.request.options.emplace_back("gyro", true);
  if (auto sound = jobs::check_task("smooth", job.request); !sound) return tl::unexpected(std::move(sound.error()));
  job.columns = checked(output_columns(arguments.output));
  if (are_samples) {
    job.rows = checked(row_request(arguments.rows, arguments.input, arguments.output));
    job.threads = checked(threads_in(arguments.inputs.threads));
  }
  job.names = Json({{"input", arguments.input.path}});
  const bool reads_rates = is_given(arguments.fields, "gyro") && !has_gyro_file;
  io::ReadOptions& read = job.input.read;
  read.rate_orders = reads_rates ? 1 : 0;
  read.world_rates = true;
  read.free_rates = io::FreeRates::lenient;
  read.unposed_rows = reads_rates ? io::UnposedRows::set_aside : io::UnposedRows::refused;
  read.parameters.assign(noise_columns.begin(), noise_columns.end());
  read.keep_exact_times = true;
  return std::move(checked).or_else(std::move(job));
}

Expected<void> read_smoothed(const TaskArguments& arguments, TaskJob& job) {
  auto file = io::read_track(job.input.path, job.input.read, job.input.signs);
  if (!file) return tl::unexpected(with_output_for_all(file.error(), all_in_scene));
  warn(file->warnings);
  job.columns = columns_like(*file->format, job.columns, arguments.output);
  if (job.rows) job.rows->columns = columns_for(arguments.rows, arguments.output, *file->format);
  if (is_given(arguments.fields, "sigma") && !job.columns.format->holds.settings)
    return bad_option(
        "sigma", formatted("{} has no columns for standard deviations, wanted a CSV file", job.columns.format->file));
  const auto gyro_file = file_of(arguments, "gyro");
  if (is_given(arguments.fields, "gyro") || gyro_file) {
    auto gyro = gyro_beside(*file, gyro_file, job.input.read);
    if (!gyro) return tl::unexpected(std::move(gyro.error()));
    job.request.inputs.emplace_back("gyro", std::make_shared<const GyroTrack>(std::move(*gyro)));
  }
  job.request.reading.mended = text_of(file->repairs);
  job.names = Json({{"input", file->track.name}});
  job.request.inputs.emplace_back("recording", shared(std::move(file->track)));
  return {};
}

/// Samples of the curve that the keys have when their file is read again, but none between two stretches; how many
/// rows there are.
Expected<std::size_t> write_curve(const std::string& path, const TaskJob& job, const orispline::Smoothing& smoothed) {
  const auto keys = jobs::as_read_again(smoothed.track);
  if (!keys) return tl::unexpected(keys.error());
  const auto curve = jobs::curve_through(smoothed.method, *keys);
  if (!curve) return tl::unexpected(curve.error());
  const RowRequest& rows = *job.rows;
  std::optional<jobs::Band> band;
  if (rows.band) {
    auto found = jobs::band_of(*keys, smoothed.method, *rows.band);
    if (!found) return tl::unexpected(std::move(found.error()));
    band = std::move(*found);
  }
  const auto wanted = jobs::times_on_curve(rows.times, keys->epoch, curve->orientation.domain(), rows.extrapolation);
  if (!wanted) return tl::unexpected(wanted.error());
  warn(wanted->warnings);
  const RowWriting writing = row_writing(rows, keys->recipe.gap.has_value(), job.threads);
  return write_rows(path, with_positions(rows.columns, curve->position.has_value()), *curve, wanted->times,
                    {rows.extrapolation, band ? &*band : nullptr}, writing, Progress::Show::never)
      .map([&](const jobs::RowCounts& counts) { return counts.rows(writing.policy); });
}

/// Samples in the place of keys, which the summary then tells.
Expected<void> write_smooth_samples(const TaskArguments& arguments, const TaskJob& job, jobs::TaskOutcome& outcome) {
  if (!job.columns.format->holds.rates)
    warn({{.code = "rates_not_written",
           .message = "this format holds no rates: wx,wy,wz,ax,ay,az are not written, wanted a CSV file for them"}});
  auto& smooth = jobs::found<jobs::SmoothOutcome>(outcome);
  return write_curve(arguments.output.path, job, smooth.smoothing).map([&](std::size_t rows) {
    smooth.samples = rows;
    outcome.document = jobs::document_of(smooth);
    outcome.line = jobs::line_of(smooth);
  });
}

Expected<WrittenResult> write_smoothed(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  job.columns.derivatives = job.columns.format->holds.rates ? 2 : 0;
  return (job.rows ? write_smooth_samples(arguments, job, outcome)
                   : write_keys(arguments.output.path, outcome.tracks.front(), job.columns))
      .map([&] {
        const auto& smooth = jobs::found<jobs::SmoothOutcome>(outcome);
        return WrittenResult{.text = written_text(arguments, smooth.result())};
      });
}

// reduce

Expected<std::vector<Method>> reducing_methods_in(const TaskArguments& arguments) {
  if (arguments.method.value_or(std::string(smallest_method)) != smallest_method)
    return method_request(*arguments.method, arguments.shape).map([](Method method) {
      return std::vector{std::move(method)};
    });
  if (any_given(arguments.shape))
    return usage_failure("options that shape a curve want --method with one method as well");
  return std::vector<Method>();
}

/// What makes sense for clips only.
Expected<void> check_no_clips(const TaskArguments& arguments) {
  for (const std::string_view name :
       {"between", "cuts", "shell", "world_tolerance", "position_scale", "closed", "keep_constant"})
    if (is_given(arguments.fields, name))
      return usage_failure(
          formatted("{}: found keys of one track, wanted a glTF output, such as small.glb", flag_of(name)));
  if (arguments.method == cubicspline_method)
    return usage_failure(
        "--method: found 'cubicspline' for keys of one track, wanted a glTF output, such as small.glb");
  if (is_given(arguments.fields, "tolerance")) return {};
  return usage_failure("reduce: --tolerance is missing; 'orispline help reduce' shows what to type");
}

Expected<io::SampleColumns> reduced_columns(const TaskArguments& arguments) {
  return output_columns(arguments.output).and_then([&](io::SampleColumns columns) {
    return check_times_are_kept(*columns.format, arguments.output.option, "the tolerance").map([&] { return columns; });
  });
}

Expected<TaskJob> reduce_job(const TaskArguments& arguments) {
  if (auto fits = check_no_clips(arguments); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  TaskJob job{.input = checked(input_request(arguments.input)), .request = request_of(arguments)};
  job.columns = checked(reduced_columns(arguments));
  for (Method& method : checked(reducing_methods_in(arguments)))
    job.request.methods.push_back({method.name, std::move(method)});
  job.request.options.emplace_back("threads", std::uint64_t{checked(threads_in(arguments.inputs.threads))});
  auto read = std::move(checked).or_else(std::move(job));
  if (!read) return read;
  if (auto sound = jobs::check_task("reduce", read->request); !sound) return tl::unexpected(std::move(sound.error()));
  read->input.read.rate_orders = 0;
  read->input.read.keep_exact_times = true;
  read->input.read.keep_as_read = true;
  if (read->request.methods.size() == 1)  // the settings of one method may stand in columns
    read->input.read.parameters = open_parameters(read->request.methods.front().method);
  read->names = Json({{"input", arguments.input.path}});
  return check_files(arguments).map([&] { return std::move(*read); });
}

Expected<void> read_reduced(const TaskArguments& arguments, TaskJob& job) {
  auto file = io::read_track(job.input.path, job.input.read, job.input.signs);
  if (!file) return tl::unexpected(with_output_for_all(std::move(file.error()), all_in_scene));
  warn(file->warnings);
  job.columns = columns_like(*file->format, job.columns, arguments.output);
  job.request.reading.mended = text_of(file->repairs);
  job.request.inputs.emplace_back("recording", shared(std::move(file->track)));
  return {};
}

Expected<WrittenResult> write_reduced(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  const Reduction& chosen = jobs::found<jobs::ReduceOutcome>(outcome).chosen();
  const std::string& path = arguments.output.path;
  job.columns.derivatives = chosen.track.keys.angular_velocities().empty() ? 0 : 1;
  return check_settings_fit(chosen.track, job.columns, path, "the tolerance holds")
      .and_then([&] { return write_keys(path, chosen.track, job.columns); })
      .map([&] {
        return WrittenResult{.text = formatted("{} written to {}; they are for --method {}\n",
                                               counted(chosen.samples.size(), "key"), destination(path),
                                               chosen.method.name)};
      });
}

/// Positions are missing in a file.
Error explain_reduced(Error error) {
  if (error.code != ErrorCode::bad_data || error.option != "position_tolerance") return error;
  error.message = "found no positions, wanted columns px,py,pz for `position_tolerance`";
  error.option.clear();
  return error;
}

// mean

/// The inputs whose rows are one set.
std::vector<std::string> paths_of(const TaskArguments& arguments) {
  return arguments.input.path.empty() ? arguments.inputs.paths : std::vector{arguments.input.path};
}

Expected<TaskJob> mean_job(const TaskArguments& arguments) {
  const auto paths = paths_of(arguments);
  std::vector<OtherFile> others;
  others.reserve(paths.size());
  for (const std::string& path : paths) others.push_back({"INPUT", path});
  InputOptions first = arguments.input;
  first.path = paths.front();
  FirstError checked;
  TaskJob job{.input = checked(input_request(first)), .request = request_of(arguments)};
  job.columns = checked(columns_of_made(arguments.output, arguments.summary, {"mean", "the mean"}, others));
  auto read = std::move(checked).or_else(std::move(job));
  if (!read) return read;
  if (auto sound = jobs::check_task("mean", read->request); !sound) return tl::unexpected(std::move(sound.error()));
  read->input.read.rate_orders = 0;
  read->input.read.count_rows = !is_given(arguments.fields, "every") && !read->input.read.session;
  read->input.read.parameters = {std::string(jobs::weight_name)};
  if (paths.size() > 1 && is_given(arguments.fields, "every"))
    return usage_failure(formatted(
        "--every: found {} inputs, each with a clock of its own, wanted one, or --output-folder FOLDER for the "
        "means of each",
        paths.size()));
  read->names = paths.size() == 1 ? Json({{"input", paths.front()}}) : Json({{"inputs", Json(paths)}});
  return read;
}

Expected<void> read_rows(const TaskArguments& arguments, TaskJob& job) {
  const auto paths = paths_of(arguments);
  std::string& mended = job.request.reading.mended;
  for (const std::string& path : paths) {
    auto file = io::read_track(path, job.input.read, job.input.signs);
    if (!file) return tl::unexpected(std::move(file.error()));
    warn(file->warnings);
    if (job.request.inputs.empty()) job.columns = columns_like(*file->format, job.columns, arguments.output);
    if (const std::string repaired = text_of(file->repairs); !repaired.empty())
      mended += (mended.empty() ? "" : "; ") + (paths.size() > 1 ? printable(path) + ": " : "") + repaired;
    job.request.inputs.emplace_back("rows", shared(std::move(file->track)));
  }
  job.columns.derivatives = 0;
  job.request.reading.rows_have_times = !job.input.read.count_rows;
  return {};
}

Expected<WrittenResult> write_mean(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  return write_keys(arguments.output.path, outcome.tracks.front(), job.columns).map([&] {
    return WrittenResult{.text = written_text(arguments, "mean")};
  });
}

// align

Expected<TaskJob> align_job(const TaskArguments& arguments) {
  if (arguments.input.path == io::standard_stream && arguments.second == io::standard_stream)
    return usage_failure("found '-' for INPUT and for REFERENCE, wanted it for one at most");
  FirstError checked;
  TaskJob job{.input = checked(input_request(arguments.input)), .request = request_of(arguments)};
  job.columns = checked(columns_of_made(arguments.output, arguments.summary, {"keys", "the aligned recording"},
                                        {{"INPUT", arguments.input.path}, {"REFERENCE", arguments.second}}));
  job.input.read.keep_exact_times = true;
  job.names = Json({{"input", arguments.input.path}});
  if (!writes_file(arguments.output)) job.names["reference"] = arguments.second;
  return std::move(checked).or_else(std::move(job)).and_then([](TaskJob read) {
    return jobs::check_task("align", read.request).map([&] { return std::move(read); });
  });
}

/// Rates are written as CSV; the options of writing are about orientations.
Expected<void> check_rates_output(const OutputOptions& output) {
  for (const auto& [name, text] : output.writing)
    if (text)
      return usage_failure(
          formatted("{}: found INPUT of a gyro, wanted none: its rates are written as t,wx,wy,wz", flag_of(name)));
  return {};
}

Expected<void> read_aligned(const TaskArguments& arguments, TaskJob& job) {
  auto moved = read_moved(job.input);
  if (!moved) return tl::unexpected(std::move(moved.error()));
  auto fixed = read_fixed(*moved, arguments.second, job.input.read);
  if (!fixed) return tl::unexpected(std::move(fixed.error()));
  if (const auto* const file = std::get_if<io::TrackFile>(&*moved))
    job.columns = columns_like(*file->format, job.columns, arguments.output);
  else if (auto rates = check_rates_output(arguments.output); !rates) return rates;
  const auto value_of = [](AlignedFile& file) -> jobs::TaskValue {
    if (auto* const gyro = std::get_if<GyroTrack>(&file)) return std::make_shared<const GyroTrack>(std::move(*gyro));
    return shared(std::move(std::get<io::TrackFile>(file).track));
  };
  job.request.inputs = {{"moved", value_of(*moved)}, {"fixed", value_of(*fixed)}};
  return {};
}

Expected<WrittenResult> write_aligned(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  const std::string& path = arguments.output.path;
  const bool is_of_gyro = outcome.tracks.empty();
  return (is_of_gyro ? write_aligned_rates(path, outcome.gyros.front())
                     : write_keys(path, outcome.tracks.front(), job.columns))
      .map([&] { return WrittenResult{.text = written_text(arguments, is_of_gyro ? "rates" : "keys")}; });
}

constexpr TaskSteps smooth_steps{"smooth", smooth_job, read_smoothed, write_smoothed};
constexpr TaskSteps reduce_steps{"reduce", reduce_job, read_reduced, write_reduced, explain_reduced};
constexpr TaskSteps mean_steps{"mean", mean_job, read_rows, write_mean};
constexpr TaskSteps align_steps{"align", align_job, read_aligned, write_aligned};

const TaskSteps& smoothing_steps(const TaskArguments& arguments) {
  return makes_scene(arguments) ? smooth_scene_steps : smooth_steps;
}

const TaskSteps& reducing_steps(const TaskArguments& arguments) {
  return makes_scene(arguments) ? reduce_scene_steps : reduce_steps;
}

/// How the command works on each input: with the steps that its arguments ask for.
template <const TaskSteps& (*Steps)(const TaskArguments&)>
CommandOnInput<TaskArguments> work_with(SceneOutputs scenes) {
  return {.written = "keys",
          .check = [](const TaskArguments& one) { return Steps(one).understand(one).map([](const TaskJob&) {}); },
          .work = [](const TaskArguments& one) { return run_on_one(Steps(one), one); },
          .scenes = scenes};
}

}  // namespace

Expected<void> run_smooth(const TaskArguments& arguments) {
  return on_inputs(arguments, work_with<smoothing_steps>(SceneOutputs::same));
}

Expected<void> run_reduce(const TaskArguments& arguments) {
  return on_inputs(arguments, work_with<reducing_steps>(SceneOutputs::glb));
}

Expected<void> run_align(const TaskArguments& arguments) { return run_on_one(align_steps, arguments); }

Expected<void> run_mean(const TaskArguments& arguments) {
  if (arguments.inputs.folder || asks_for_all_sessions(arguments.input)) {
    const auto check = [](const TaskArguments& one) { return mean_job(one).map([](const TaskJob&) {}); };
    const auto work = [](const TaskArguments& one) { return run_on_one(mean_steps, one); };
    return on_inputs(arguments, CommandOnInput<TaskArguments>{.written = "mean", .check = check, .work = work});
  }
  return files_of(arguments.inputs).and_then([&](const InputFiles& found) {
    warn(found.warnings);
    TaskArguments all = arguments;
    all.inputs.paths.clear();
    for (const InputFile& file : found.files) all.inputs.paths.push_back(file.path);
    return run_on_one(mean_steps, all);
  });
}

}  // namespace orispline::cli
