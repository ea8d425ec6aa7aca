// SPDX-License-Identifier: Apache-2.0
// tune, retime and bake: tasks about the curve of one method through keys.
#include <algorithm>
#include <array>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/track_file.hpp>

#include "commands/task_command.hpp"
#include "options/file_places.hpp"
#include "output/each_input.hpp"
#include "output/gathered_output.hpp"
#include "output/keys_file.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// What the words ask of the task, with its options checked.
Expected<TaskJob> understood(std::string_view task, const TaskArguments& arguments, bool writes_keys) {
  FirstError checked;
  TaskJob job{.input = checked(input_request(arguments.input)), .request = request_of(arguments)};
  job.named = checked(named_method(arguments.method, arguments.shape));
  if (writes_keys) job.columns = checked(output_columns(arguments.output));
  job.names = Json({{"input", arguments.input.path}});
  return std::move(checked).or_else(std::move(job)).and_then([&](TaskJob read) {
    return jobs::check_task(task, read.request).map([&] { return std::move(read); });
  });
}

/// Settles the method, then reads the keys with the columns that it takes.
template <class ReadFor>
Expected<io::TrackFile> keys_for_method(const TaskArguments& arguments, TaskJob& job, const jobs::UsualMethod& usual,
                                        ReadFor read_for_method) {
  auto input = io::KeyInput::open(job.input.path, job.input.read);
  if (!input) return tl::unexpected(std::move(input.error()));
  auto chosen = chosen_method(job.named, arguments.shape, *input, usual);
  if (!chosen) return tl::unexpected(std::move(chosen.error()));
  warn(std::exchange(chosen->warnings, {}));
  job.input.read = read_for_method(chosen->method, std::move(job.input.read));
  job.request.method = std::move(*chosen);
  return io::read_track(std::move(*input), job.input.read, job.input.signs).map([](io::TrackFile file) {
    warn(file.warnings);
    return file;
  });
}

void take_keys(TaskJob& job, io::TrackFile file) {
  job.request.inputs.emplace_back("keys", shared(std::move(file.track)));
}

// tune

/// Whether the columns of INPUT are understood without an option: only then can the output have them.
bool reads_the_same_again(const InputOptions& o) {
  constexpr std::array about_rows{"signs", "ignore_recipe", "drop_duplicates", "drop_invalid", "sort"};
  return std::ranges::none_of(o.reading, [&](const auto& option) {
    return option.second.are_given() && std::ranges::find(about_rows, option.first) == about_rows.end();
  });
}

/// What the files ask of each other.
Expected<void> check_tuned_files(const TaskArguments& arguments) {
  const std::string& output = arguments.output.path;
  const auto reference = file_of(arguments, "reference");
  if (output.empty()) return usage_failure("-o: found an empty name, wanted FILE or -");
  if (auto checked = check_summary(arguments.summary, output, "keys"); !checked) return checked;
  std::vector<OtherFile> others{{"INPUT", arguments.input.path}};
  if (reference) others.push_back({"that of --reference", *reference});
  auto apart = check_output_apart("-o", output, others).and_then([&] {
    return check_extension("-o", output, {".csv", ".txt"});
  });
  if (!apart) return apart;
  if (arguments.input.path == io::standard_stream && reference == io::standard_stream)
    return usage_failure("found '-' for INPUT and --reference, wanted it for one at most");
  return {};
}

Expected<TaskJob> tune_job(const TaskArguments& arguments) {
  return understood("tune", arguments, false).and_then([&](TaskJob job) {
    job.input.read.keep_table = reads_the_same_again(arguments.input);
    return check_tuned_files(arguments).map([&] { return std::move(job); });
  });
}

Expected<void> read_tuned(const TaskArguments& arguments, TaskJob& job) {
  auto file = keys_for_method(arguments, job, jobs::usual_tuned, [](const Method& method, io::ReadOptions read) {
    read.parameters = open_parameters(method);
    read.rate_orders = 0;
    return with_columns_of(method, std::move(read));
  });
  if (!file) return tl::unexpected(std::move(file.error()));
  if (const auto path = file_of(arguments, "reference")) {
    auto reference = io::read_track_beside(*file, *path, job.input.read);
    if (!reference) return tl::unexpected(std::move(reference.error()));
    warn(reference->warnings);
    job.request.inputs.emplace_back("reference", shared(std::move(reference->track)));
  }
  take_keys(job, std::move(*file));
  return {};
}

Expected<WrittenResult> write_tuned(const TaskArguments& arguments, TaskJob&, jobs::TaskOutcome& outcome) {
  return write_keys(arguments.output.path, outcome.tracks.front()).map([&] {
    return WrittenResult{.text = written_text(arguments, "keys with tensions")};
  });
}

// retime

Expected<TaskJob> retime_job(const TaskArguments& arguments) {
  return understood("retime", arguments, true).and_then([&](TaskJob job) {
    job.input.read.rate_orders = 0;
    job.input.read.keep_as_read = true;
    return check_files(arguments)
        .and_then([&] { return check_times_are_kept(*job.columns.format, arguments.output.option, "the limits"); })
        .map([&] { return std::move(job); });
  });
}

Expected<void> read_retimed(const TaskArguments& arguments, TaskJob& job) {
  auto file = keys_for_method(arguments, job, jobs::usual_retimed, [](const Method& method, io::ReadOptions read) {
    read.parameters = open_parameters(method);
    return read;
  });
  if (!file) return tl::unexpected(std::move(file.error()));
  job.columns = columns_like(*file->format, job.columns, arguments.output);
  if (!file->ignored_columns.empty())
    warn({{.code = "columns_left_out",
           .message = formatted("the output leaves out the columns {}", joined(file->ignored_columns, ", "))}});
  take_keys(job, std::move(*file));
  return {};
}

Expected<WrittenResult> write_retimed(const TaskArguments& arguments, TaskJob& job, jobs::TaskOutcome& outcome) {
  const Track& retimed = outcome.tracks.front();
  return check_settings_fit(retimed, job.columns, arguments.output.option, "the limits hold")
      .and_then([&] { return write_keys(arguments.output.path, retimed, job.columns); })
      .map([&] { return WrittenResult{.text = written_text(arguments, "keys")}; });
}

// bake

constexpr std::string_view binary = ".bin";

Expected<TaskJob> bake_job(const TaskArguments& arguments) {
  const std::string& output = arguments.output.path;
  return check_output_apart("-o", output, {{"INPUT", arguments.input.path}})
      .and_then([&] {
        return check_extension("-o", output, {".json", binary});
      })
      .and_then([&] { return check_summary(arguments.summary, output, "curve"); })
      .and_then([&] { return understood("bake", arguments, false); });
}

Expected<void> read_baked(const TaskArguments& arguments, TaskJob& job) {
  return keys_for_method(arguments, job, {default_method},
                         [](const Method& method, io::ReadOptions read) {
                           return read_for({&method, 1}, std::move(read));
                         })
      .map([&](io::TrackFile file) { take_keys(job, std::move(file)); });
}

Expected<WrittenResult> write_baked(const TaskArguments& arguments, TaskJob&, jobs::TaskOutcome& outcome) {
  const auto& found = jobs::found<jobs::BakeOutcome>(outcome);
  const Decimal& epoch = found.request.keys->epoch;
  const std::string content =
      has_extension(arguments.output.path, binary) ? baked_bytes(found.baked, epoch) : baked_json(found.baked, epoch);
  return open_output(arguments.output.path)
      .and_then([&](Noted<io::OutputFile> output) {
        return output.file.write(content).and_then([&] { return output.file.finish(); });
      })
      .map([&] { return WrittenResult{.text = written_text(arguments, "curve")}; });
}

constexpr TaskSteps tune_steps{"tune", tune_job, read_tuned, write_tuned};
constexpr TaskSteps retime_steps{"retime", retime_job, read_retimed, write_retimed};
constexpr TaskSteps bake_steps{"bake", bake_job, read_baked, write_baked};

const TaskSteps& retiming_steps(const TaskArguments& arguments) {
  return makes_scene(arguments) ? retime_scene_steps : retime_steps;
}

}  // namespace

Expected<void> run_tune(const TaskArguments& arguments) { return run_on_one(tune_steps, arguments); }

Expected<void> run_bake(const TaskArguments& arguments) { return run_on_one(bake_steps, arguments); }

Expected<void> run_retime(const TaskArguments& arguments) {
  const auto check = [](const TaskArguments& one) {
    return retiming_steps(one).understand(one).map([](const TaskJob&) {});
  };
  const auto work = [](const TaskArguments& one) { return run_on_one(retiming_steps(one), one); };
  return on_inputs(arguments, CommandOnInput<TaskArguments>{
                                  .written = "keys", .check = check, .work = work, .scenes = SceneOutputs::same});
}

}  // namespace orispline::cli
