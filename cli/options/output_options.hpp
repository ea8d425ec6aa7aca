// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orispline/io/sample_writer.hpp>

#include "options/input_options.hpp"

namespace orispline::cli {

inline constexpr std::array output_format_choices{format_choices[0], format_choices[1], format_choices[2],
                                                  Choice<io::FileFormat>{"npy", io::FileFormat::npy}};

/// How the user wants a file to be written, as typed.
struct OutputOptions {
  std::string path{io::standard_stream};
  std::optional<std::string> format, orientation, euler, angle_unit;
};

/// The format of the output and the form of its orientations; the rest of the columns is left to the command.
[[nodiscard]] Expected<io::SampleColumns> output_columns(const OutputOptions& options);

/// Error (bad_argument): a format that rounds times, with which `promise`, such as `the limits`, need not hold.
[[nodiscard]] Expected<void> check_times_are_kept(io::FileFormat format, std::string_view option,
                                                  std::string_view promise);

/// `a TUM file`
[[nodiscard]] std::string a_file_of(io::FileFormat format);

}  // namespace orispline::cli
