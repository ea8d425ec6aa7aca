// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "options/output_options.hpp"
#include "options/report_options.hpp"
#include "options/smoothness.hpp"
#include "options/summary_options.hpp"

// Options that several commands have, and what the help says about them.

namespace orispline::cli {

/// The type name of arguments that are files.
inline constexpr auto file_type = "FILE", folder_type = "FOLDER";
/// Of arguments whose words the registry knows.
inline constexpr auto method_type = "METHOD", methods_type = "METHOD,...", ends_type = "RULE|START,END",
                      setting_type = "NAME=VALUE";

/// INPUT and how it is read, part of several commands.
void add_input_options(CLI::App& app, InputOptions& options, std::string_view default_signs = "shortest");

/// How it is read, without INPUT itself.
void add_reading_options(CLI::App& app, InputOptions& options, std::string_view default_signs = "shortest");

/// Where the output goes and in which form, part of several commands.
void add_output_file(CLI::App& app, std::string& path);
void add_summary_options(CLI::App& app, SummaryOptions& options);
void add_smoothness_options(CLI::App& app, SmoothnessOptions& options);
void add_output_options(CLI::App& app, OutputOptions& options);
void add_report_option(CLI::App& app, ReportOptions& options);

/// The settings, ends and rates that shape a curve, part of several commands.
void add_method_options(CLI::App& app, MethodOptions& options);
/// Whether it is a loop.
void add_loop_options(CLI::App& app, MethodOptions& options);

}  // namespace orispline::cli
