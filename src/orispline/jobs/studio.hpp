// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/jobs/curve_of_keys.hpp>

// The page on which keys are edited. docs/studio.md describes it.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// Keys that the page edits; of more it offers to reduce them.
inline constexpr std::size_t most_edited_keys = 1000;

/// What the page begins with.
struct StudioRequest {
  std::string name{};                 ///< of the file that it edits, without its folders
  std::string bytes{};                ///< of that file
  std::shared_ptr<const Track> keys;  ///< that are in it
  ChosenMethod method{};              ///< of the first curve; the page finds the one of the keys by itself
  std::optional<Method> beside{};     ///< of the second curve
};

struct StudioOutcome {
  std::string data;                 ///< the JSON document that the page reads
  std::vector<Warning> warnings{};  ///< of the methods; `many_keys`
};

/// Errors: those of shaped_curve().
[[nodiscard]] Expected<StudioOutcome> studio(const StudioRequest& request);

/// The page with that document, made from its template, which is in pieces; an empty one leaves its start screen.
[[nodiscard]] std::string studio_page(std::span<const std::string_view> pieces, std::string_view data);

}}}  // namespace orispline::jobs
