// SPDX-License-Identifier: Apache-2.0
#include "output/output_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include <orispline/base/formatted.hpp>
#include <orispline/io/output_file.hpp>

#include "options/file_places.hpp"
#include "options/option_text.hpp"

namespace orispline::cli {
namespace {

namespace fs = std::filesystem;

Expected<void> made(const std::string& folder, const std::error_code& reason) {
  if (!reason) return {};
  return failure(ErrorCode::bad_access, "cannot make this folder: " + reason.message(), {.file = folder});
}

}  // namespace

Expected<void> make_folder(const std::string& folder) {
  std::error_code reason;
  fs::create_directories(folder, reason);
  return made(folder, reason);
}

Expected<void> check_folder(const std::string& folder) {
  std::error_code reason;
  fs::path missing, there = fs::absolute(folder, reason);
  for (; !reason && !fs::exists(there, reason) && there.has_relative_path(); there = there.parent_path())
    missing = there;
  if (fs::exists(there) && !fs::is_directory(there)) reason = std::make_error_code(std::errc::not_a_directory);
  else if (!missing.empty() && access(there.c_str(), W_OK | X_OK) != 0) reason = {errno, std::generic_category()};
  return made(folder, reason);
}

Expected<std::vector<std::string>> outputs_in(const std::string& folder, std::span<const std::string> inputs,
                                              const io::FormatInfo* format) {
  std::vector<std::string> outputs;
  for (const std::string& input : inputs) {
    if (input == io::standard_stream) return usage_failure("--output-folder: found '-' for an input, wanted files");
    fs::path name = fs::path(input).filename();
    if (name.empty()) return usage_failure(formatted("--output-folder: found '{}', wanted a file", input));
    if (format) name.replace_extension(format->extensions.front());
    std::string output = (fs::path(folder) / name).string();
    if (const auto same = std::ranges::find(outputs, output); same != outputs.end())
      return usage_failure(formatted("--output-folder: found {} and {}, wanted inputs of different names",
                                     inputs[static_cast<std::size_t>(same - outputs.begin())], input));
    if (std::ranges::any_of(inputs, [&](const std::string& other) { return is_same_file(other, output); }))
      return usage_failure(formatted("--output-folder: found {}, wanted a folder without the inputs", folder));
    outputs.push_back(std::move(output));
  }
  return outputs;
}

}  // namespace orispline::cli
