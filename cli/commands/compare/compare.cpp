// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/tune/tension_model.hpp>
#include <orispline/tune/tune.hpp>

#include "commands/compare/compare_report.hpp"
#include "output/each_input.hpp"
#include "output/gathered_output.hpp"
#include "output/progress.hpp"
#include "output/standard_output.hpp"
#include "output/terminal_width.hpp"

namespace orispline::cli {

namespace {

/// Progress looks at the clock only once in so many steps.
constexpr std::size_t steps_per_method = 4096;

/// The same with the tensions that make ∫|α|² least, or with the reason why there are none.
ComparedMethod tuned(ComparedMethod method, const Track& track) {
  Candidate& candidate = method.candidate;
  method.label += ":tuned";
  auto tuning = orispline::tune(track, candidate.method);
  if (tuning) candidate.method = std::move(tuning->method);
  else method.measures = tl::unexpected(track.located(std::move(tuning.error())));
  return method;
}

std::vector<ComparedMethod> methods_to_compare(const CompareRequest& request, const ComparedData& data) {
  std::vector<ComparedMethod> methods;
  for (std::size_t i = 0; i < data.key_sets.size(); ++i)
    for (const NamedMethod& method : request.methods) {
      const Track& track = data.key_sets[i].track;
      methods.push_back(
          {.label = method.label, .key_set = i, .candidate = {completed(method.method, track), track.keys}});
      if (request.tune && !orispline::tunable_parameters(method.method.name).empty())
        methods.push_back(tuned(methods.back(), track));
    }
  return methods;
}

void measure_all(CompareReport& report, const CompareRequest& request, Progress::Show show) {
  std::vector<Candidate> candidates;
  for (const ComparedMethod& method : report.methods) candidates.push_back(method.candidate);
  Progress progress(steps_per_method * candidates.size(), show);
  Comparison comparison = orispline::compare(candidates, report.data.recording(), request.measured,
                                             static_cast<unsigned>(request.threads), {.show = [&](double share) {
                                               progress.advance_to(static_cast<std::size_t>(std::lround(
                                                   share * static_cast<double>(steps_per_method * candidates.size()))));
                                             }});
  warn(comparison.warnings);
  for (std::size_t i = 0; i < report.methods.size(); ++i) {
    ComparedMethod& method = report.methods[i];
    if (!method.measures) continue;  // it could not be tuned
    method.measures = std::move(comparison.measures[i]).map_error([&](Error error) {
      return report.data.key_sets[method.key_set].track.located(std::move(error));
    });
  }
}

/// Exit code 0 wants one method that worked.
Expected<void> any_worked(const CompareReport& report) {
  for (const ComparedMethod& method : report.methods)
    if (method.measures) return {};
  return failure(ErrorCode::bad_data,
                 formatted("none of the methods could be compared; {}: {}", report.methods.front().label,
                           describe(report.methods.front().measures.error())));
}

Expected<CompareReport> compared(const CompareOptions& options, const CompareRequest& request) {
  auto files = compared_files(request, options.reference);
  if (!files) return tl::unexpected(std::move(files.error()));
  CompareReport report{
      .data = std::move(files->data),
      .repairs = files->repairs,
      .methods = {},
      .inertia = is_given(options.measured, "inertia") ? std::optional(request.measured.inertia) : std::nullopt,
      .leave_out = request.measured.leave_out,
      .sort = request.sort};
  if (const auto sortable = sort(report); !sortable) return tl::unexpected(sortable.error());
  report.methods = methods_to_compare(request, report.data);
  measure_all(report, request, options.summary.quiet ? Progress::Show::never : Progress::Show::on_terminal);
  return sort(report).map([&] { return std::move(report); });
}

/// As the page takes it.
pages::ComparedCurves shown(const CompareReport& report, const std::vector<std::string>& named) {
  pages::ComparedCurves curves{.methods = report.methods,
                               .recording = report.data.recording(),
                               .epoch = report.data.epoch,
                               .named = named,
                               .measures = measures_of(report),
                               .sorted_by = report.sort,
                               .inertia = report.inertia};
  for (const ComparedKeys& keys : report.data.key_sets)
    curves.key_sets.push_back(keys.decimation ? name_of(*keys.decimation) : "");
  return curves;
}

Expected<void> print(const CompareReport& report, const CompareOptions& options) {
  return print_document(options.json  ? json_of(report)
                        : options.csv ? csv_of(report)
                                      : text_of(report, terminal_width()))
      .and_then([&] { return any_worked(report); });
}

/// The table of one of several inputs, as a file of its own.
Expected<void> write(const CompareReport& report, const CompareOptions& options) {
  const auto worked = any_worked(report);
  if (!worked) return worked;
  return open_output(options.output.path)
      .and_then([&](Noted<io::OutputFile> output) {
        return output.file.write(options.json ? json_of(report) : csv_of(report)).and_then([&] {
          return put_in_place(std::move(output));
        });
      })
      .map([&] {
        if (!options.summary.quiet) tell(formatted("{}: {}\n", printable(options.output.path), line_of(report)));
      });
}

Expected<void> compare_one(const CompareOptions& options) {
  const auto request = compare_request(options);
  if (!request) return tl::unexpected(request.error());
  auto file = ReportFile::open(options.report);
  if (!file) return tl::unexpected(std::move(file.error()));
  return compared(options, *request).and_then([&](const CompareReport& report) {
    const auto make_page = [&](auto head) {
      head.title = title_of(report, report.data.key_sets.front());
      return pages::compare_page(shown(report, request->named), head, static_cast<unsigned>(request->threads));
    };
    // What was measured is shown even where the report cannot be written.
    const auto written = file->write(make_page).and_then([&] { return file->finish(); });
    const auto printed = options.inputs.folder ? write(report, options) : print(report, options);
    return written ? printed : written;
  });
}

Expected<void> check_each(const CompareOptions& options) {
  if (options.reference == io::standard_stream)
    return usage_failure(
        "--output-folder: found '-' for --reference, wanted a file, which is read again for each input");
  return compare_request(options).map([](const CompareRequest&) {});
}

}  // namespace

Expected<void> compare(const CompareOptions& options) {
  return on_inputs(options, {.written = "tables",
                             .check = check_each,
                             .work = compare_one,
                             .extension = options.json ? ".json" : io::csv_format.extensions.front()});
}

}  // namespace orispline::cli
