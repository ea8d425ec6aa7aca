// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
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
};

/// A figure, table or example of one of the papers, computed anew.
struct Experiment {
  std::string_view name;  ///< the paper's number, a dash, the part
  std::string_view title;
  Expected<Findings> (*run)();
};

/// All of them, by paper.
[[nodiscard]] std::span<const Experiment> experiments() noexcept;

namespace experiment {
// Tan et al. 2018, the quintic.
[[nodiscard]] Expected<Findings> blending_functions();
[[nodiscard]] Expected<Findings> one_tension();
[[nodiscard]] Expected<Findings> rigid_motions();
[[nodiscard]] Expected<Findings> schemes_compared();
// He et al. 2022, Beta curves.
[[nodiscard]] Expected<Findings> beta_example1();
[[nodiscard]] Expected<Findings> beta_example2();
// Eberly, quaternions.
[[nodiscard]] Expected<Findings> quaternion_identities();
[[nodiscard]] Expected<Findings> angular_cubic();
// The 6th degree.
[[nodiscard]] Expected<Findings> flight_compared();
[[nodiscard]] Expected<Findings> sudden_turn();
}  // namespace experiment

}  // namespace orispline::cli
