// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/io/sample_writer.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "options/input_options.hpp"

namespace orispline::cli {

/// How the user wants a file to be written, as typed.
struct OutputOptions {
  std::string path{io::standard_stream};
  std::string_view option = "-o";                                    ///< by which the path was named
  std::map<std::string_view, std::optional<std::string>> writing{};  ///< by the names of io::writing_options()
  std::vector<const scenes::SceneFormat*> scenes{};                  ///< files of skeletons that may be written too
  std::optional<std::string> position_scale{};                       ///< of a skeleton: metres in the unit of INPUT
  std::optional<std::string> compress{};                             ///< of a skeleton in glTF
};

/// All formats of skeletons that are written.
[[nodiscard]] std::vector<const scenes::SceneFormat*> scenes_written();

/// How their names end: `.glb or .gltf`; empty where there are none.
[[nodiscard]] std::string endings_of(const std::vector<const scenes::SceneFormat*>& formats);

/// The format of skeletons of that word, which may be an ending too: `gltf`, `glb`; null if there is none.
[[nodiscard]] const scenes::SceneFormat* scene_format_in(const std::string& word);

/// Error (bad_argument): --output-format names a format of skeletons, which go by their names.
[[nodiscard]] Expected<void> check_no_skeleton_format(const OutputOptions& options);

/// The format of the output and the form of its orientations; the rest of the columns is left to the command.
[[nodiscard]] Expected<io::SampleColumns> output_columns(const OutputOptions& options);

/// The columns where INPUT is of that format: a name such as `keys.txt`, which says nothing of the format, means that
/// of INPUT if it holds what is asked for.
[[nodiscard]] io::SampleColumns columns_like(const io::FormatInfo& input, io::SampleColumns columns,
                                             const OutputOptions& options);

/// Error (bad_argument): a format that rounds times, with which `promise`, such as `the limits`, need not hold.
[[nodiscard]] Expected<void> check_times_are_kept(const io::FormatInfo& format, std::string_view option,
                                                  std::string_view promise);

/// The format that is asked for by name, if any.
[[nodiscard]] Expected<std::optional<const io::FormatInfo*>> output_format(const OutputOptions& options);

/// The output, in a message about another file: `that of -o`.
[[nodiscard]] std::string_view place_of_output(const OutputOptions& options);

/// The extension of files in --output-folder, if a format is asked for; else empty. Error (bad_argument): a file is
/// named besides, what is written goes to one of them.
[[nodiscard]] Expected<std::string_view> folder_extension(const OutputOptions& options, std::string_view written);

/// `CSV or TUM`: the formats that samples are written in of which this is true.
[[nodiscard]] std::string formats_that(bool (*are)(const io::FormatInfo&));

/// Error (bad_argument): keys have settings with a value each, or rates, with which `promise`, such as `the limits
/// hold`, and files of that format have no column for them. `output`: the file or its option.
[[nodiscard]] Expected<void> check_settings_fit(const Track& keys, const io::SampleColumns& columns,
                                                std::string_view output, std::string_view promise);

}  // namespace orispline::cli
