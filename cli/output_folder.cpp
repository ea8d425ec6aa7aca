// SPDX-License-Identifier: Apache-2.0
#include "output_folder.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include <orispline/io/output_file.hpp>

#include "option_text.hpp"

namespace orispline::cli {
namespace {

namespace fs = std::filesystem;

std::string_view extension_of(io::FileFormat format) {
  return format == io::FileFormat::tum ? ".tum" : format == io::FileFormat::npy ? ".npy" : ".csv";
}

bool are_one_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;  // of files that are not there
  return fs::equivalent(a, b, ignored);
}

}  // namespace

Expected<void> make_folder(const std::string& folder) {
  std::error_code reason;
  fs::create_directories(folder, reason);
  if (!reason) return {};
  return failure(ErrorCode::bad_access, "cannot make this folder: " + reason.message(), {.file = folder});
}

Expected<std::vector<std::string>> outputs_in(const std::string& folder, std::span<const std::string> inputs,
                                              std::optional<io::FileFormat> format) {
  std::vector<std::string> outputs;
  for (const std::string& input : inputs) {
    if (input == io::standard_stream) return usage_failure("--output-folder: found '-' for an input, wanted files");
    fs::path name = fs::path(input).filename();
    if (name.empty()) return usage_failure(fmt::format("--output-folder: found '{}', wanted a file", input));
    if (format) name.replace_extension(extension_of(*format));
    std::string output = (fs::path(folder) / name).string();
    if (const auto same = std::ranges::find(outputs, output); same != outputs.end())
      return usage_failure(fmt::format("--output-folder: found {} and {}, wanted inputs of different names",
                                       inputs[static_cast<std::size_t>(same - outputs.begin())], input));
    if (std::ranges::any_of(inputs, [&](const std::string& other) { return are_one_file(other, output); }))
      return usage_failure(fmt::format("--output-folder: found {}, wanted a folder without the inputs", folder));
    outputs.push_back(std::move(output));
  }
  return outputs;
}

}  // namespace orispline::cli
