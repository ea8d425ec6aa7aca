// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/analysis/compared_keys.hpp>

#include "commands/compare/compare_keys.hpp"

namespace orispline::cli {

/// What `orispline compare` found, sorted within each set of keys.
struct CompareReport {
  ComparedData data;
  io::RepairReport repairs{};
  std::vector<ComparedMethod> methods{};  ///< an error has its place in the file
  std::optional<Eigen::Matrix3d> inertia{};
  LeaveOut leave_out = LeaveOut::no;
  std::string sort{};
};

/// The measures that the report has: of rates where they are logged, of torques where the inertia is known.
[[nodiscard]] std::vector<MeasureInfo> measures_of(const CompareReport& report);

/// The value of a measure in its unit; absent where the method has none.
[[nodiscard]] std::optional<double> value_of(const MeasureInfo& measure, const ComparedMethod& method,
                                             const ComparedData& data);

/// A word of `--sort`.
[[nodiscard]] Expected<std::string> sort_word_in(OptionText option);
/// `rms|mean|…`
[[nodiscard]] std::string sort_words();

/// Whether a word of `--sort` is that of a measure of torques, which are taken where the inertia is known.
[[nodiscard]] bool is_torque(std::string_view word);

/// Puts the best method first in each set of keys, what failed last. Error (bad_argument): rates are not logged.
[[nodiscard]] Expected<void> sort(CompareReport& report);

/// `flight.csv: every 8th sample kept`, `keys.csv against truth.csv`, with the names of the files and not their
/// folders.
[[nodiscard]] std::string title_of(const CompareReport& report, const ComparedKeys& keys);

/// A table for each set of keys, for people.
///
/// In lines of so many characters: what has no room is left out, and named.
[[nodiscard]] std::string text_of(const CompareReport& report, std::optional<std::size_t> width);
/// The best method of each set of keys, in one line.
[[nodiscard]] std::string line_of(const CompareReport& report);
/// One table with a header.
[[nodiscard]] std::string csv_of(const CompareReport& report);

/// One JSON document, described in docs/inspect-json.md.
[[nodiscard]] std::string json_of(const CompareReport& report);

}  // namespace orispline::cli
