// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <orispline/curve/extrapolation.hpp>
#include <orispline/io/sample_columns.hpp>
#include <orispline/jobs/sample_rows.hpp>

#include "options/command.hpp"
#include "options/input_options.hpp"
#include "options/output_options.hpp"

// Which samples are wanted and what their rows have, for all commands that write samples.

namespace orispline::cli {

inline constexpr std::array frame_choices{Choice<io::Frame>{"body", io::Frame::body},
                                          Choice<io::Frame>{"world", io::Frame::world}};

/// As typed.
struct RowOptions {
  std::string command;  ///< its name
  std::optional<std::string> rate, count, list, from, to;
  bool include_end = false;
  bool yes = false;  ///< to any number of samples
  std::optional<std::string> derivatives, frame, extrapolate, outside;
  bool mark_gaps = false;
  std::optional<std::string> band;

  [[nodiscard]] bool names_times() const noexcept { return rate || count || list; }
};

/// The first option that is given, such as `--rate`; empty if there is none.
[[nodiscard]] std::string_view first_given(const RowOptions& options);

/// Understood.
struct RowRequest {
  jobs::TimeRequest times{};
  io::SampleColumns columns{};
  Extrapolation extrapolation = Extrapolation::hold;
  jobs::OutsideRows outside = jobs::OutsideRows::made;
  bool mark_gaps = false;        ///< by rows with a time alone; else they have none
  std::optional<double> band{};  ///< the share of the true motion that it is meant to hold
};

/// When samples are, and what those outside the curve do. `rate`: what --rate does, for the help.
void add_time_options(Command& app, RowOptions& options, const std::string& group, const std::string& rate);
/// What rows have, and that there may be any number of them.
void add_row_options(Command& app, RowOptions& options);

/// How far off the true motion may be.
void add_band_option(Command& app, RowOptions& options);

/// The times of these options, and the columns of the output, where it is one of rows. Without other times those are
/// the frames of the input, if it states how many there are in a second.
[[nodiscard]] Expected<RowRequest> row_request(const RowOptions& options, const InputOptions& input,
                                               const OutputOptions& output);

/// The columns for INPUT of that format, of options that row_request() has understood.
[[nodiscard]] io::SampleColumns columns_for(const RowOptions& options, const OutputOptions& output,
                                            const io::FormatInfo& input);
/// The columns for keys with or without positions.
[[nodiscard]] io::SampleColumns with_positions(io::SampleColumns columns, bool positions);

}  // namespace orispline::cli
