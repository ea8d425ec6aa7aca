// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include <orispline/report/page.hpp>
#include <orispline/report/table.hpp>

#include "commands/compare/compare_keys.hpp"

namespace orispline::cli {

/// One method on one set of keys.
struct ComparedMethod {
  std::string label;
  std::size_t key_set = 0;
  Candidate candidate;
  Expected<Measures> measures{};  ///< or one line that says why there are none, with its place in the file
};

/// What `orispline compare` found, sorted within each set of keys.
struct CompareReport {
  ComparedData data;
  std::vector<ComparedMethod> methods{};
  std::optional<Eigen::Matrix3d> inertia{};
  LeaveOut leave_out = LeaveOut::no;
  std::string sort{};
};

/// A measure as it is printed; THE list of them is `compare_figures`.
struct CompareFigure {
  std::string_view id;                        ///< member of the JSON and column of the CSV
  std::string_view word;                      ///< for --sort; empty: not for sorting
  report::Column column;                      ///< of the table for people; without a name it is not there
  std::string_view label, unit, explanation;  ///< in the page
  report::Better better = report::Better::less;
  std::function<std::optional<double>(const Measures&, const ComparedData&)> value{};
};

/// The measures that the report has: of rates where they are logged, of torques where the inertia is known.
[[nodiscard]] std::vector<CompareFigure> compare_figures(const CompareReport& report);

/// All that can be sorted by.
[[nodiscard]] std::vector<CompareFigure> all_compare_figures();

/// Some of them: how far a curve is from a recording, how smooth it is, and what torque it takes.
[[nodiscard]] std::vector<CompareFigure> distance_figures();
[[nodiscard]] std::vector<CompareFigure> shape_figures();
[[nodiscard]] std::vector<CompareFigure> torque_figures();

/// A word of `--sort`.
[[nodiscard]] Expected<std::string> sort_word_in(OptionText option);
/// `rms|mean|…`
[[nodiscard]] std::string sort_words();

/// Whether the figure is that of the whole curve: an energy is infinite where a rate that it integrates jumps at keys.
[[nodiscard]] bool is_finite(const CompareFigure& figure, const Measures& measures);

/// Puts the best method first in each set of keys, what failed last. Error (bad_argument): rates are not logged.
[[nodiscard]] Expected<void> sort(CompareReport& report);

/// `every 8th sample of flight.csv`, `keys.csv against truth.csv`
[[nodiscard]] std::string title_of(const CompareReport& report, const ComparedKeys& keys);

/// A table for each set of keys, for people.
[[nodiscard]] std::string text_of(const CompareReport& report);
/// One table with a header.
[[nodiscard]] std::string csv_of(const CompareReport& report);

/// One JSON document, described in docs/inspect-json.md.
[[nodiscard]] std::string json_of(const CompareReport& report);

}  // namespace orispline::cli
