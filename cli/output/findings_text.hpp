// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <orispline/curve/track.hpp>
#include <orispline/families/measured.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// What the orientations say to the method measured; nothing for another one.
[[nodiscard]] std::optional<KeyFindings> findings_by(const Method& method, const Track& track);

/// The method with these as settings, so that they are not found again for the same curve.
[[nodiscard]] Method with_found(const Method& method, const std::optional<KeyFindings>& findings);

/// `key noise 0.5: 46 %, spline: 31 %, …; polynomial believed 0.8; trust 0.9`.
[[nodiscard]] std::string text_of(const KeyFindings& findings);

/// The same as JSON, with the numbers as the method's settings; null where there are none.
[[nodiscard]] Json findings_json(const std::optional<KeyFindings>& findings);

}  // namespace orispline::cli
