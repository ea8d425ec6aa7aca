// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/report/svg.hpp>
#include <orispline/report/table.hpp>

namespace orispline::cli {

struct Picture {
  std::string name;  ///< of its file, without the extension
  report::Drawing drawing;
};

/// What an experiment computed.
struct Findings {
  std::vector<report::Table> tables;
  std::vector<Picture> pictures{};
  std::vector<pages::NamedCurve> motions{};  ///< to look at on a page
  Keyframes truth{};                         ///< what they are compared with; without keys: nothing
};

/// Keys in the place of the paper's, which are not published, and what is said of them.
struct KeysInstead {
  Keyframes keys;
  std::string note;
};

/// A figure, table or example of one of the papers, computed anew.
struct Experiment {
  std::string_view name;  ///< the paper's number, a dash, the part
  std::string_view title;
  Expected<Findings> (*run)();
  Expected<Findings> (*run_with)(const KeysInstead&) = nullptr;  ///< null: its keys are part of it

  /// The number of the paper: `000`.
  [[nodiscard]] constexpr std::string_view paper() const { return name.substr(0, name.find('-')); }
};

/// All of them, by paper.
[[nodiscard]] std::span<const Experiment> experiments() noexcept;

/// The word for a paper beside its number: who wrote it, or its curve where the copy at hand names nobody.
[[nodiscard]] std::string_view author_of(const Experiment& experiment) noexcept;
/// The name with that word in the place of the number: `tan-table1`.
[[nodiscard]] std::string name_by_author(const Experiment& experiment);

namespace experiment {
// Tan et al. 2018, the quintic.
[[nodiscard]] Expected<Findings> blending_functions();
[[nodiscard]] Expected<Findings> one_tension();
[[nodiscard]] Expected<Findings> rigid_motions();
[[nodiscard]] Expected<Findings> rigid_motions_of(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> hermite_compared();
[[nodiscard]] Expected<Findings> hermite_compared_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> schemes_compared();
[[nodiscard]] Expected<Findings> schemes_compared_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> quintic_claims();
[[nodiscard]] Expected<Findings> quintic_claims_on(const KeysInstead& keys);
// He et al. 2022, Beta curves.
[[nodiscard]] Expected<Findings> beta_example1();
[[nodiscard]] Expected<Findings> beta_example2();
[[nodiscard]] Expected<Findings> beta_shapes();
// Eberly, quaternions.
[[nodiscard]] Expected<Findings> quaternion_identities();
[[nodiscard]] Expected<Findings> angular_cubic();
// The 6th degree.
[[nodiscard]] Expected<Findings> flight_compared();
[[nodiscard]] Expected<Findings> sudden_turn();
[[nodiscard]] Expected<Findings> turns_of(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> sextic_claims();
}  // namespace experiment

}  // namespace orispline::cli
