// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/command.hpp"
#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "options/output_options.hpp"
#include "options/report_options.hpp"
#include "options/summary_options.hpp"

// Options that several commands have, and what the help says about them.

namespace orispline::cli {

/// INPUT and how it is read, part of several commands.
void add_input_options(Command& app, InputOptions& options,
                       std::string_view default_signs = "as INPUT says, else shortest");

/// How it is read, without INPUT itself.
void add_reading_options(Command& app, InputOptions& options,
                         std::string_view default_signs = "as INPUT says, else shortest");

/// The options of those that concern skeletons as a whole.
void add_scene_reading_options(Command& app, InputOptions& options);

/// Where the output goes and in which form, part of several commands.
void add_output_file(Command& app, std::string& path);
void add_summary_options(Command& app, SummaryOptions& options);
void add_output_options(Command& app, OutputOptions& options);
/// Of a command that prints what it found where no file is named; `sentence` says what goes into the file.
void add_made_output(Command& app, OutputOptions& output, SummaryOptions& summary, std::string_view sentence);
/// How long a unit of INPUT is, of a command that writes skeletons.
void add_gltf_options(Command& app, OutputOptions& options);
void add_report_option(Command& app, ReportOptions& options);

/// The settings, ends and rates that shape a curve, part of several commands.
void add_method_options(Command& app, MethodOptions& options);
/// `--blending FILE`, which those have too.
void add_blending_option(Command& app, std::vector<std::string>& files);
/// Whether it is a loop.
void add_loop_options(Command& app, MethodOptions& options);

}  // namespace orispline::cli
