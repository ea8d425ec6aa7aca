// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>

#include "options/several_inputs.hpp"

namespace orispline::cli {

/// With the folders that it is in; it may be there. Error: bad_access.
[[nodiscard]] Expected<void> make_folder(const std::string& folder);

/// Whether make_folder() would make it, or it is there; leaves nothing behind. Error: bad_access.
[[nodiscard]] Expected<void> check_folder(const std::string& folder);

/// The error, with how many files of the folder are complete all the same.
[[nodiscard]] Error with_written(Error error, std::size_t files);

/// What becomes of files of skeletons in an output folder.
enum class SceneOutputs {
  rows,  ///< of one joint: as of other inputs
  same,  ///< files of the same name
  glb,   ///< glTF, under the same name where that is it
};

/// Where the outputs of several inputs go: files of the same names in the folder, with that extension if one is given,
/// else as they are where we write such files, else with that of CSV. Errors: bad_argument for standard input, for two
/// outputs in one place and for an output that is an input, or the list of them.
[[nodiscard]] Expected<std::vector<std::string>> outputs_in(const std::string& folder,
                                                            std::span<const InputFile> inputs,
                                                            std::string_view extension,
                                                            const std::optional<std::string>& list,
                                                            SceneOutputs scenes = SceneOutputs::rows);

}  // namespace orispline::cli
