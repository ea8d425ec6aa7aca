// SPDX-License-Identifier: Apache-2.0
#include "options/several_inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/line_reader.hpp>

#include "options/file_places.hpp"
#include "options/option_text.hpp"

namespace orispline::cli {

namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

/// The files in a folder and in those below it.
class FolderFiles {
 public:
  FolderFiles(std::string folder, const std::optional<std::string>& outputs)
      : folder_(std::move(folder)), outputs_(outputs) {}

  [[nodiscard]] Expected<void> append_to(InputFiles& inputs) {
    std::error_code reason;
    fs::recursive_directory_iterator entry(folder_, reason);
    for (; !reason && entry != fs::recursive_directory_iterator(); entry.increment(reason)) {
      std::error_code unknown;  // such as a link to nowhere
      if (entry->is_directory(unknown) && passes_over(entry->path())) entry.disable_recursion_pending();
      if (entry->is_regular_file(unknown) && !is_hidden(entry->path())) take(entry->path());
    }
    if (reason) return failure(ErrorCode::bad_access, "cannot read: " + reason.message(), {.file = folder_});
    if (files_.empty())
      return failure(
          ErrorCode::bad_data,
          formatted("found no file in this folder whose name ends as {} files do", io::any_of(io::formats_read())),
          {.file = folder_});
    std::ranges::sort(files_, {}, &InputFile::path);
    std::ranges::move(files_, std::back_inserter(inputs.files));
    if (others_ > 0)
      inputs.warnings.push_back({.code = "other_files",
                                 .message = formatted("{} of other kinds left out, such as {}; a file that is named "
                                                      "by itself is read whatever its name",
                                                      counted(others_, "file"), other_),
                                 .where = {.file = folder_}});
    return {};
  }

 private:
  /// What was written there before is no input.
  [[nodiscard]] bool passes_over(const fs::path& folder) const {
    return is_hidden(folder) || (outputs_ && is_same_file(folder.string(), *outputs_));
  }
  void take(const fs::path& path) {
    if (has_name_of(&io::FormatInfo::is_read, path.string()))
      files_.push_back({path.string(), path.lexically_relative(folder_).string()});
    else if (others_++ == 0 || path.filename().string() < other_) other_ = path.filename().string();
  }

  std::string folder_;
  const std::optional<std::string>& outputs_;
  std::vector<InputFile> files_;
  std::size_t others_ = 0;
  std::string other_;
};

Expected<std::vector<std::string>> lines_of(const std::string& list) {
  auto reader = io::LineReader::open(list);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  std::vector<std::string> lines;
  while (true) {
    const auto line = reader->next();
    if (!line) return tl::unexpected(line.error());
    if (!*line) break;
    if (!(*line)->empty()) lines.emplace_back(**line);
  }
  if (lines.empty())
    return failure(ErrorCode::bad_data, "found no line, wanted the path of a file in each", {.file = list});
  return lines;
}

bool is_folder(const std::string& path) {
  std::error_code unknown;
  return fs::is_directory(path, unknown);
}

Expected<std::vector<std::string>> paths_of(const SeveralInputs& options) {
  std::vector<std::string> paths = options.paths;
  if (options.list) {
    auto lines = lines_of(*options.list);
    if (!lines) return lines;
    std::ranges::move(*lines, std::back_inserter(paths));
  }
  if (paths.empty())
    return usage_failure(formatted("{0}: INPUT is missing; 'orispline help {0}' shows what to type", options.command));
  return paths;
}

/// The first of several, in a message.
std::string some_of(const std::vector<std::string>& paths) {
  constexpr std::size_t shown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, paths.size()); ++i)
    text.append(i == 0 ? "" : i + 1 == paths.size() ? " and " : ", ").append(in_quotes(paths[i]));
  return paths.size() > shown ? text + ", …" : text;
}

}  // namespace

void add_several_inputs(Command& app, SeveralInputs& o, std::string_view written, std::string_view several) {
  o.command = app.name;
  app.add_option("INPUT", o.paths,
                 formatted("{} file of keyframes; '-' is standard input; several files, or folders of them, {}",
                           io::any_of(io::formats_read()), several))
      ->type_name(file_type);
  const std::string group = "Several inputs";
  app.add_option("--inputs", o.list,
                 "Read the paths of further inputs from this file, one in a line; '-' is standard "
                 "input")
      ->type_name(file_type)
      ->group(group);
  app.add_option("--output-folder", o.folder,
                 formatted("Write the {} of each input into a file of the same name there; a bad input is named and "
                           "does not stop the others",
                           written))
      ->type_name(folder_type)
      ->group(group);
  app.add_flag("--all-or-none", o.all_or_none, "Write no output there unless all inputs succeed")->group(group);
}

void add_input_threads(Command& app, SeveralInputs& o) {
  app.add_option("--threads", o.threads, "Threads that work on the inputs, with the same results [all cores]")
      ->type_name("N")
      ->group("Several inputs");
}

Expected<InputFiles> files_of(const SeveralInputs& options) {
  auto paths = paths_of(options);
  if (!paths) return tl::unexpected(std::move(paths.error()));
  InputFiles inputs;
  for (std::string& path : *paths) {
    if (is_folder(path)) {
      if (auto found = FolderFiles(path, options.folder).append_to(inputs); !found)
        return tl::unexpected(std::move(found.error()));
      continue;
    }
    std::string name = fs::path(path).filename().string();
    inputs.files.push_back({std::move(path), std::move(name)});
  }
  return inputs;
}

Expected<std::string> only_input(const SeveralInputs& options, std::string_view written) {
  auto paths = paths_of(options);
  if (!paths) return tl::unexpected(std::move(paths.error()));
  if (paths->size() > 1)
    return usage_failure(formatted("found {} inputs, {}; wanted one, or --output-folder FOLDER for their {}",
                                   paths->size(), some_of(*paths), written));
  if (is_folder(paths->front()))
    return usage_failure(
        formatted("INPUT: found the folder '{}', wanted --output-folder FOLDER for the {} of its files", paths->front(),
                  written));
  return std::move(paths->front());
}

}  // namespace orispline::cli
