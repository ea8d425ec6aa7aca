// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_report.hpp"

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/file_json.hpp>

#include "output/repairs_text.hpp"
#include "output/rows_file.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

constexpr std::size_t many_keys = 1'000'000;  // some hundred megabytes, worth a word

jobs::SampleOutcome in_words(const SampleReport& report) {
  jobs::SampleOutcome outcome = report.outcome;
  outcome.mended = cli::text_of(report.repairs);
  outcome.written_to = destination(report.output);
  return outcome;
}

/// The names of the columns, where they may be many.
Json names_of(const io::SampleColumns& columns) {
  return columns.format->holds.rates ? Json(io::column_names(columns)) : Json(nullptr);
}

}  // namespace

Expected<SampleReport> write_samples(const SampleRequest& request, SampleReport report, const PoseCurve& curve,
                                     const jobs::SampleTimes& times, bool has_gaps, const jobs::Band* band) {
  report.input = request.input.path;
  report.output = request.output;
  report.columns = with_positions(request.rows.columns, curve.position.has_value());
  report.keys_held = true;
  report.outcome.extrapolation = request.rows.extrapolation;
  const RowWriting writing = row_writing(request.rows, has_gaps, request.threads);
  return write_rows(request.output, report.columns, curve, times, {request.rows.extrapolation, band}, writing,
                    request.progress)
      .map([&](const jobs::RowCounts& counts) {
        count_rows(report.outcome, writing.policy, counts);
        return std::move(report);
      });
}

std::string text_of(const SampleReport& report) {
  std::string text = summary_of(in_words(report));
  if (could_be_measured(report.outcome))
    text +=
        "if the keys are a recording, --method measured finds how noisy they are, and --band 0.9 how far off it may "
        "be\n";
  if (report.keys_held && report.outcome.keys >= many_keys)
    text += "all keys were held in memory; 'orispline sample --help' says what goes through in pieces\n";
  return text;
}

std::string line_of(const SampleReport& report) {
  return formatted("{}: {}", printable(report.output), line_of(in_words(report)));
}

Json json_of(const SampleReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"output_format", report.columns.format->id},
            {"output_orientation", word_of(orientation_choices, report.columns.form.representation)}};
  Json columns{{"columns", names_of(report.columns)},
               {"derivatives", report.columns.derivatives},
               {"frame", word_of(frame_choices, report.columns.frame)}};
  Json repairs;
  add_repairs(repairs, report.repairs);
  json.update(document_of(report.outcome, std::move(columns), std::move(repairs)));
  return json;
}

std::string text_of(const CurveSceneReport& report) { return summary_of(report.outcome); }

Json json_of(const CurveSceneReport& report) {
  Json json{{"input", report.outcome.request.source}, {"output", report.output}};
  json.update(document_of(report.outcome));
  return json;
}

}  // namespace orispline::cli
