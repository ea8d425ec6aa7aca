// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orispline/analysis/compared_keys.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/jobs/align.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct Page;
struct Table;
}  // namespace report
namespace pages {
struct PageHead;
}

namespace jobs {

/// A method with its settings, and as its user names it: `quintic:tension=0.6`.
struct LabelledMethod {
  std::string label;
  Method method;
};

/// Every method there is, by its name.
[[nodiscard]] ORISPLINE_EXPORT std::vector<LabelledMethod> all_methods();

struct CompareRequest {
  std::shared_ptr<const Track> keys{};       ///< a recording, of which some samples become keys
  std::shared_ptr<const Track> reference{};  ///< a recording, where `keys` are the keys themselves
  std::vector<Decimation> decimations{};     ///< of a recording without another one
  std::vector<LabelledMethod> methods{};
  std::vector<std::string> named{};  ///< labels of those that somebody asked for by name, in that order
  bool tune = false;                 ///< methods with tensions once more, tuned
  bool align = false;                ///< bring the keys onto the reference first
  MeasureOptions measured{};
  bool has_inertia = false;  ///< whether that of `measured` is the body's: then torques are measured too
  std::string sort{"rms"};   ///< the word of a measure
  unsigned threads = 0;      ///< 0: one for each core

  [[nodiscard]] std::optional<Eigen::Matrix3d> inertia() const {
    return has_inertia ? std::optional(measured.inertia) : std::nullopt;
  }
};

/// Error (bad_argument): what is wrong whatever the keys are.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const CompareRequest& request);

/// The methods with their measures, the best first on each set of keys.
struct ORISPLINE_EXPORT CompareOutcome {
  CompareRequest request;                   ///< with the keys as they were compared
  std::optional<AlignOutcome> alignment{};  ///< of the keys, where it was asked for
  ComparedData data{};
  std::vector<ComparedMethod> methods{};  ///< an error has its place in the file
  std::vector<Warning> warnings{};

  /// The measures that there are.
  [[nodiscard]] std::vector<MeasureInfo> measures() const;
  /// The value of a measure in its unit; absent where the method has none.
  [[nodiscard]] std::optional<double> value(const MeasureInfo& measure, const ComparedMethod& method) const;
};

/// Errors: those of check(); bad_data for fewer than two keys and for a reference that does not overlap them;
/// bad_argument for a measure of rates that are not logged and for settings of which there are neither one nor as many
/// as keys; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<CompareOutcome> compare(CompareRequest request, const Progress& progress = {});

/// A list, described in docs/inspect-json.md.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const CompareOutcome& outcome);
/// One table for programs, with a header.
[[nodiscard]] ORISPLINE_EXPORT std::string csv_of(const CompareOutcome& outcome);
/// `flight.csv: every 8th sample kept, 11 keys, 81 samples compared`, `keys.csv against truth.csv, …`, with the names
/// of the files and not their folders.
[[nodiscard]] ORISPLINE_EXPORT std::string title_of(const CompareOutcome& outcome, std::size_t key_set);
/// One for each set of keys, for people.
[[nodiscard]] ORISPLINE_EXPORT std::vector<report::Table> tables_of(const CompareOutcome& outcome);
/// These tables as text, in lines as long as they are.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const CompareOutcome& outcome);
/// The best method of each set of keys, in one line without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const CompareOutcome& outcome);
/// With ORISPLINE_PAGE.
[[nodiscard]] ORISPLINE_EXPORT report::Page page_of(const CompareOutcome& outcome, const pages::PageHead& head);

}  // namespace jobs

}}  // namespace orispline
