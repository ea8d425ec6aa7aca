// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare.hpp"

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/report/table.hpp>

#include "commands/compare/compare_keys.hpp"
#include "commands/compare/compare_request.hpp"
#include "output/each_input.hpp"
#include "output/gathered_output.hpp"
#include "output/json_document.hpp"
#include "output/progress.hpp"
#include "output/repairs_text.hpp"
#include "output/standard_output.hpp"
#include "output/terminal_width.hpp"

namespace orispline::cli {

namespace {

/// Progress looks at the clock only once in 4096 steps.
constexpr double progress_steps = 4096 * 1000.0;

/// What was found, and what was mended in INPUT.
struct CompareReport {
  jobs::CompareOutcome outcome;
  io::RepairReport repairs{};
};

Expected<CompareReport> compared(const CompareArguments& options, CompareRequest request) {
  auto files = compared_files(request.input, options.reference);
  if (!files) return tl::unexpected(std::move(files.error()));
  request.job.keys = std::move(files->keys);
  request.job.reference = std::move(files->reference);
  Progress bar(static_cast<std::size_t>(progress_steps),
               options.summary.quiet ? Progress::Show::never : Progress::Show::on_terminal);
  const auto show = [&](double share) { bar.advance_to(static_cast<std::size_t>(progress_steps * share)); };
  return jobs::compare(std::move(request.job), {.show = show}).map([&](jobs::CompareOutcome outcome) {
    warn(outcome.warnings);
    return CompareReport{std::move(outcome), files->repairs};
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
std::string tables_text(const CompareReport& report, std::optional<std::size_t> width) {
  constexpr std::string_view not_shown = "The terminal is too narrow for these, which --csv and --json have too:";
  std::string text;
  if (const std::string repairs = text_of(report.repairs); !repairs.empty()) text += repairs + "\n";
  for (const report::Table& table : tables_of(report.outcome))
    text.append(text.empty() ? "" : "\n").append(width ? text_of(table, *width, not_shown) : text_of(table));
  return text;
}

Expected<void> print(const CompareReport& report, const CompareArguments& options) {
  return print_document(options.json  ? document(document_of(report.outcome))
                        : options.csv ? csv_of(report.outcome)
                                      : tables_text(report, terminal_width()))
      .and_then([&] { return any_worked(report.outcome); });
}

/// The table of one of several inputs, as a file of its own.
Expected<void> write(const jobs::CompareOutcome& outcome, const CompareArguments& options) {
  return any_worked(outcome)
      .and_then([&] { return open_output(options.output.path); })
      .and_then([&](Noted<io::OutputFile> output) {
        return output.file.write(options.json ? document(document_of(outcome)) : csv_of(outcome)).and_then([&] {
          return put_in_place(std::move(output));
        });
      })
      .map([&] {
        if (!options.summary.quiet) tell(formatted("{}: {}\n", printable(options.output.path), line_of(outcome)));
      });
}

Expected<void> compare_one(const CompareArguments& options) {
  auto request = compare_request(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto file = ReportFile::open(options.report);
  if (!file) return tl::unexpected(std::move(file.error()));
  return compared(options, std::move(*request)).and_then([&](const CompareReport& report) {
    // What was measured is shown even where the page cannot be written.
    const auto written = file->write([&](const auto& head) { return page_of(report.outcome, head); }).and_then([&] {
      return file->finish();
    });
    const auto printed = options.inputs.folder ? write(report.outcome, options) : print(report, options);
    return written ? printed : written;
  });
}

Expected<void> check_each(const CompareArguments& options) {
  if (options.reference == io::standard_stream)
    return usage_failure(
        "--output-folder: found '-' for --reference, wanted a file, which is read again for each input");
  return compare_request(options).map([](const CompareRequest&) {});
}

}  // namespace

Expected<void> compare(const CompareArguments& options) {
  return on_inputs(options, {.written = "tables",
                             .check = check_each,
                             .work = compare_one,
                             .extension = options.json ? ".json" : io::csv_format.extensions.front()});
}

}  // namespace orispline::cli
