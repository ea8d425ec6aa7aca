// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/curve/track.hpp>
#include <orispline/fields/field_json.hpp>

// What the summaries and documents of several tasks say alike.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// `5 keys from keys.csv`, without a file `5 keys`.
[[nodiscard]] std::string keys_text(const Track& keys);

/// The name of a file without its folders, else what it is.
[[nodiscard]] std::string shown_name(std::string_view file, std::string_view otherwise);

/// Where the samples of a track are. It outlives them.
[[nodiscard]] Places places_of(const Track& track);

}}}  // namespace orispline::jobs
