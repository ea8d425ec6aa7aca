// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/report/table.hpp>

#include "papers/picture.hpp"

namespace orispline::cli {

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
  std::vector<Eigen::Quaterniond> as_given{};  ///< with the signs of their file; empty: those of the keys
};

/// A true motion, sampled, with keys of it, and what is said of them.
struct Flight {
  std::string name;                                ///< of the keys: `five keys of the flight's first turn`
  std::vector<double> times{};                     ///< [s], from the first key to the last
  std::vector<Motion> truth{};                     ///< one per time
  std::vector<Eigen::Quaterniond> orientations{};  ///< those of the truth
  Keyframes keys{};
  std::string note{};
};

/// A figure, table or example of one of the papers, computed anew.
struct Experiment {
  std::string_view name;  ///< the paper's number, a dash, the part
  std::string_view title;
  Expected<Findings> (*run)();
  Expected<Findings> (*run_with)(const KeysInstead&) = nullptr;  ///< null: keys alone are not taken
  Expected<Findings> (*run_on)(const Flight&) = nullptr;         ///< null: keys with a truth are not taken

  /// The number of the paper: `000`.
  [[nodiscard]] constexpr std::string_view paper() const { return name.substr(0, name.find('-')); }
  [[nodiscard]] constexpr bool takes_keys() const { return run_with || run_on; }
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
[[nodiscard]] Expected<Findings> one_tension_of(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> rigid_motions();
[[nodiscard]] Expected<Findings> rigid_motions_of(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> hermite_compared();
[[nodiscard]] Expected<Findings> hermite_compared_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> schemes_compared();
[[nodiscard]] Expected<Findings> schemes_compared_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> quintic_identities();
[[nodiscard]] Expected<Findings> quintic_at_zero();
[[nodiscard]] Expected<Findings> quintic_at_zero_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> quintic_claims();
[[nodiscard]] Expected<Findings> quintic_claims_on(const KeysInstead& keys);
// He et al. 2022, Beta curves.
[[nodiscard]] Expected<Findings> beta_example1();
[[nodiscard]] Expected<Findings> beta_example1_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> beta_example2();
[[nodiscard]] Expected<Findings> beta_example2_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> beta_local();
[[nodiscard]] Expected<Findings> beta_local_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> beta_shapes();
[[nodiscard]] Expected<Findings> beta_shapes_on(const Flight& flight);
// Eberly, quaternions.
[[nodiscard]] Expected<Findings> quaternion_identities();
[[nodiscard]] Expected<Findings> angular_cubic();
// The 6th degree.
[[nodiscard]] Expected<Findings> flight_compared();
[[nodiscard]] Expected<Findings> flight_compared_on(const Flight& flight);
[[nodiscard]] Expected<Findings> sudden_turn();
[[nodiscard]] Expected<Findings> turns_of(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> sextic_identities();
[[nodiscard]] Expected<Findings> sextic_at_zero();
[[nodiscard]] Expected<Findings> sextic_at_zero_on(const KeysInstead& keys);
[[nodiscard]] Expected<Findings> sextic_claims();
[[nodiscard]] Expected<Findings> sextic_claims_on(const Flight& flight);
}  // namespace experiment

}  // namespace orispline::cli
