// SPDX-License-Identifier: Apache-2.0
#include "commands/task_command.hpp"

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "output/found_output.hpp"
#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"
#include "output/report_file.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// A page shows the warnings as the command says them.
void name_flags(jobs::TaskOutcome& outcome) {
  std::visit(
      [](auto& found) {
        if constexpr (requires { found->warnings; })
          for (Warning& warning : found->warnings) warning = with_flags(std::move(warning));
      },
      outcome.finding);
}

/// The document with the names of the files around it and the warnings behind.
Json document_of(const jobs::TaskOutcome& outcome, Json names, Json::Object members = {}) {
  names.update(outcome.document);
  for (auto& [name, value] : members) names[name] = std::move(value);
  names["warnings"] = json_of_warnings();
  return names;
}

/// Of a command that writes no file.
Expected<void> print_found(const SummaryOptions& options, const jobs::TaskOutcome& outcome, const Json& names) {
  return print_document(options.json ? document(document_of(outcome, names)) : outcome.summary);
}

Expected<void> summarise(const TaskArguments& arguments, const TaskJob& job, const jobs::TaskOutcome& outcome,
                         WrittenResult written) {
  const std::string& output = arguments.output.path;
  if (arguments.summary.json) {
    Json names = job.names;
    names["output"] = output;
    return print_document(document(document_of(outcome, std::move(names), std::move(written.members))));
  }
  if (arguments.summary.quiet) return {};
  if (gathered_here() && !outcome.line.empty()) tell(formatted("{}: {}\n", printable(output), outcome.line));
  else tell(outcome.summary + written.text);
  return {};
}

}  // namespace

jobs::TaskRequest request_of(const TaskArguments& arguments) {
  jobs::TaskRequest request;
  for (const auto& [name, text] : arguments.fields)
    if (text) request.options.emplace_back(name, *text);
  return request;
}

std::optional<std::string> file_of(const TaskArguments& arguments, std::string_view name) {
  const auto found = arguments.files.find(name);
  return found == arguments.files.end() ? std::nullopt : found->second;
}

Expected<void> check_files(const TaskArguments& arguments) {
  const OutputOptions& output = arguments.output;
  return check_output_apart(output.option, output.path, {{"INPUT", arguments.input.path}})
      .and_then([&] { return check_summary(arguments.summary, output.path, "keys"); })
      .and_then([&] {
        return check_report(arguments.report,
                            {{place_of_output(output), output.path}, {"INPUT", arguments.input.path}});
      });
}

std::string written_text(const TaskArguments& arguments, std::string_view what) {
  return formatted("{}{}written to {}\n", what, what.empty() ? "" : " ", destination(arguments.output.path));
}

bool makes_scene(const TaskArguments& arguments) { return is_scene(arguments.output.path); }

Expected<void> run_on_one(const TaskSteps& steps, const TaskArguments& arguments) {
  auto job = steps.understand(arguments);
  if (!job) return tl::unexpected(std::move(job.error()));
  auto page = ReportFile::open(arguments.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  const bool writes = writes_file(arguments.output);
  if (writes)
    if (auto able = check_output(arguments.output.path); !able) return able;
  if (auto read = steps.read(arguments, *job); !read) return read;
  auto outcome = jobs::run_task(steps.task, job->request);
  if (!outcome) return tl::unexpected(steps.explain ? steps.explain(outcome.error()) : outcome.error());
  warn(outcome->warnings);
  name_flags(*outcome);
  if (!writes) return print_found(arguments.summary, *outcome, job->names);
  WrittenResult written;
  return page->write([&](const auto& head) { return page_of(*outcome, head, arguments.output.path); })
      .and_then([&] { return steps.write(arguments, *job, *outcome); })
      .map([&](WrittenResult result) { written = std::move(result); })
      .and_then([&] { return page->finish(); })
      .and_then([&] { return summarise(arguments, *job, *outcome, std::move(written)); });
}

}  // namespace orispline::cli
