// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "compare.hpp"
#include "convert.hpp"
#include "inspect.hpp"
#include "plot.hpp"
#include "reduce.hpp"
#include "retime.hpp"
#include "sample.hpp"
#include "smooth.hpp"
#include "tune.hpp"

// Which options the larger commands have, and what the help says about them.

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

void add_sample_options(CLI::App& app, SampleOptions& options);
void add_convert_options(CLI::App& app, ConvertOptions& options);
void add_inspect_options(CLI::App& app, InspectOptions& options);
void add_method_options(CLI::App& app, MethodOptions& options);
void add_smooth_options(CLI::App& app, SmoothOptions& options);
void add_tune_options(CLI::App& app, TuneOptions& options);
void add_reduce_options(CLI::App& app, ReduceOptions& options);
void add_retime_options(CLI::App& app, RetimeOptions& options);
void add_compare_options(CLI::App& app, CompareOptions& options);
void add_plot_options(CLI::App& app, PlotOptions& options);

}  // namespace orispline::cli
