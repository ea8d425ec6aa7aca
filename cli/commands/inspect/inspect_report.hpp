// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/key_statistics.hpp>
#include <orispline/families/measured.hpp>
#include <orispline/io/track_file.hpp>

namespace orispline::cli {

/// The continuity that one method really has on the keys.
struct MethodReport {
  std::string name;
  Continuity continuity;  ///< in time
  ShapeContinuity shape;
  std::optional<KeyFindings> findings{};  ///< by the method measured
};

/// What `orispline inspect` found. Places are indices of keys.
struct InspectReport {
  io::TrackFile file{};
  KeyStatistics statistics{};
  KeyframeReport keyframes{};           ///< keys of a wrong norm among the non-unit ones
  std::size_t wrong_norms = 0;          ///< keys whose norm is an error for `sample`
  std::optional<std::string> defect{};  ///< what `sample` says about the file as it is
  std::vector<MethodReport> methods{};

  [[nodiscard]] Decimal time_of(std::size_t key) const { return file.track.time_of(key); }
  [[nodiscard]] std::size_t keys() const noexcept { return file.track.keys.size(); }
};

/// A page for people.
[[nodiscard]] std::string text_of(const InspectReport& report);

/// One JSON document, described in docs/inspect-json.md.
[[nodiscard]] std::string json_of(const InspectReport& report);

}  // namespace orispline::cli
