// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/key_statistics.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline::cli {

/// The continuity that one method really has on the keys.
struct MethodReport {
  std::string method;
  Continuity continuity;
};

/// What `orispline inspect` found. Places are indices of keys.
struct InspectReport {
  io::KeyFile file{};  ///< for the lines, the epoch and the repairs; without the keyframes
  std::vector<double> times{};
  KeyStatistics statistics{};
  KeyframeReport keyframes{};           ///< keys of a wrong norm among the non-unit ones
  std::size_t wrong_norms = 0;          ///< keys whose norm is an error for `sample`
  std::optional<std::string> defect{};  ///< what `sample` says about the file as it is
  std::vector<MethodReport> methods{};

  [[nodiscard]] io::Decimal time_of(std::size_t key) const { return file.epoch + io::Decimal::from_double(times[key]); }
};

/// A page for people.
[[nodiscard]] std::string text_of(const InspectReport& report);

}  // namespace orispline::cli
