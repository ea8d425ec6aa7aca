// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>

#include "options/command.hpp"

namespace orispline::cli {

/// The inputs of a command that takes several, as typed.
struct SeveralInputs {
  std::string command;             ///< its name
  std::vector<std::string> paths;  ///< files and folders
  std::optional<std::string> list, folder, threads;
  bool all_or_none = false;
};

/// A file of them, and its name in the output folder: with the folders that it is in below one that was named.
struct InputFile {
  std::string path, name;
};

struct InputFiles {
  std::vector<InputFile> files{};
  std::vector<Warning> warnings{};
};

/// INPUT..., --inputs, --output-folder and --all-or-none, part of several commands; what is written: `keys`; and what
/// several are for.
void add_several_inputs(Command& app, SeveralInputs& options, std::string_view written,
                        std::string_view several = "with --output-folder");
/// Threads that work on them, for commands that have no threads of their own.
void add_input_threads(Command& app, SeveralInputs& options);

/// All files that are meant, at least one, in the order in which they are named and by their names in folders. Errors:
/// bad_argument; bad_access for a list or a folder that cannot be read; bad_data for a folder without a file.
[[nodiscard]] Expected<InputFiles> files_of(const SeveralInputs& options);

/// Where no output folder is named: the one input. Error (bad_argument): there are several.
[[nodiscard]] Expected<std::string> only_input(const SeveralInputs& options, std::string_view written);

}  // namespace orispline::cli
