// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/families/key_findings.hpp>
#include <orispline/fields/field_json.hpp>

// What the summaries and documents of several tasks say alike.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// `5 keys from keys.csv`, without a file `5 keys`; or what else they are.
[[nodiscard]] std::string keys_text(const Track& keys, std::string_view one = "key");

/// Times counted from elsewhere.
[[nodiscard]] std::vector<double> shifted(std::span<const double> times, double shift);

/// The name of a file without its folders, else what it is.
[[nodiscard]] std::string shown_name(std::string_view file, std::string_view otherwise);

/// `key noise 0.5: 46 %, spline: 31 %, …; polynomial believed 0.8; trust 0.9`.
[[nodiscard]] std::string findings_text(const KeyFindings& findings);
/// What the keys say as JSON, with the numbers as settings of the method `measured`; null where there are none.
[[nodiscard]] Json findings_json(const std::optional<KeyFindings>& findings);

/// By the names of the components.
[[nodiscard]] Json rotation_json(const Eigen::Quaterniond& q);

/// Where the samples of a track are. It outlives them.
[[nodiscard]] Places places_of(const Track& track);

}}}  // namespace orispline::jobs
