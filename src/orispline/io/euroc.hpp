// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace orispline::io {

/// The first line of an EuRoC trajectory as this project writes it: that of the dataset.
inline constexpr std::string_view euroc_header =
    "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []";

/// Columns that every EuRoC trajectory begins with.
inline constexpr std::size_t euroc_columns = 8;

/// Whether a header, in a comment or not, names the columns of an EuRoC trajectory in their order. Units in brackets
/// may be left out; `timestamp_ns` is a time too; other columns may follow.
[[nodiscard]] bool names_euroc(std::string_view header) noexcept;
[[nodiscard]] bool names_euroc(std::span<const std::string_view> cells) noexcept;

}  // namespace orispline::io
