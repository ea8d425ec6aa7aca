// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/curve/track.hpp>
#include <orispline/fields/field_json.hpp>

// What the summaries and documents of several tasks say alike.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// `5 keys from keys.csv`, without a file `5 keys`.
[[nodiscard]] std::string keys_text(const Track& keys);

/// Where the samples of a track are. It outlives them.
[[nodiscard]] Places places_of(const Track& track);

}}}  // namespace orispline::jobs
