// SPDX-License-Identifier: Apache-2.0
#include "output/output_folder.hpp"

#include <cerrno>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/file_system.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "options/file_places.hpp"
#include "options/option_text.hpp"
#include "options/output_options.hpp"

namespace orispline::cli {

namespace {

namespace fs = std::filesystem;

Expected<void> made(const std::string& folder, const std::error_code& reason) {
  if (!reason) return {};
  return failure(ErrorCode::bad_access, "cannot make this folder: " + reason.message(), {.file = folder});
}

/// The files that are there, by what the system knows them by: one look at each, however many they are.
class FilesThere {
 public:
  void add(const std::string& path) {
    if (const auto file = identity(path)) files_.insert(*file);
  }
  [[nodiscard]] bool has(const std::string& path) const {
    const auto file = identity(path);
    return file && files_.contains(*file);
  }

 private:
  using Identity = std::pair<dev_t, ino_t>;

  [[nodiscard]] static std::optional<Identity> identity(const std::string& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return Identity{found.st_dev, found.st_ino};
  }

  std::set<Identity> files_;
};

std::string output_name(const InputFile& input, std::string_view extension, SceneOutputs scenes) {
  fs::path name = input.name;
  const orispline::scenes::SceneFormat* const format = orispline::scenes::scene_format_of(input.name);
  if (format && extension.empty() && scenes != SceneOutputs::rows) {
    const bool is_kept = scenes == SceneOutputs::same || format == &orispline::scenes::gltf_format;
    return is_kept ? input.name : name.replace_extension(".glb").string();
  }
  if (!extension.empty()) name.replace_extension(extension);
  else if (!has_name_of(&io::FormatInfo::is_written, input.name))
    name.replace_extension(io::csv_format.extensions.front());
  return name.string();
}

}  // namespace

Expected<void> make_folder(const std::string& folder) {
  std::error_code reason;
  fs::create_directories(io::behind_links(folder), reason);
  return made(folder, reason);
}

Expected<void> check_folder(const std::string& folder) {
  std::error_code reason;
  fs::path missing, there = fs::absolute(io::behind_links(folder), reason);
  for (; !reason && !fs::exists(there, reason) && there.has_relative_path(); there = there.parent_path())
    missing = there;
  if (fs::exists(there) && !fs::is_directory(there)) reason = std::make_error_code(std::errc::not_a_directory);
  else if (!missing.empty() && access(there.c_str(), W_OK | X_OK) != 0) reason = {errno, std::generic_category()};
  return made(folder, reason);
}

Error with_written(Error error, std::size_t files) {
  error.message += files == 0   ? "; nothing was written"
                   : files == 1 ? "; 1 file was written and is complete"
                                : formatted("; {} files were written and are complete", files);
  return error;
}

Expected<std::vector<std::string>> outputs_in(const std::string& folder, std::span<const InputFile> inputs,
                                              std::string_view extension, const std::optional<std::string>& list,
                                              SceneOutputs scenes) {
  FilesThere read;
  if (list) read.add(*list);
  std::map<std::string, const InputFile*> written;
  std::vector<std::string> outputs;
  for (const InputFile& input : inputs) {
    if (input.path == io::standard_stream)
      return usage_failure("--output-folder: found '-' for an input, wanted files");
    if (input.name.empty()) return usage_failure(formatted("--output-folder: found '{}', wanted a file", input.path));
    read.add(input.path);
    outputs.push_back((fs::path(folder) / output_name(input, extension, scenes)).string());
    const auto [first, is_new] = written.emplace(outputs.back(), &input);
    if (!is_new && first->second->path == input.path)
      return usage_failure(formatted("--output-folder: found {} twice, wanted each input once", input.path));
    if (!is_new)
      return usage_failure(formatted("--output-folder: found {} and {}, wanted inputs of different names",
                                     first->second->path, input.path));
  }
  for (const std::string& output : outputs)
    if (read.has(output))
      return usage_failure(formatted("--output-folder: found {}, wanted a folder without the inputs{}", folder,
                                     list ? " and their list" : ""));
  return outputs;
}

}  // namespace orispline::cli
