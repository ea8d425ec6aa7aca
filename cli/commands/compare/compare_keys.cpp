// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_keys.hpp"

#include <utility>

#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// Rows are sorted by an option of another name here, where that of this name is for the table.
Error with_its_options(Error error) {
  if (error.remedy == "sort") error.remedy = "sort_rows";
  return error;
}

Expected<io::TrackFile> warned_of(Expected<io::TrackFile> file) {
  if (!file) return tl::unexpected(with_its_options(std::move(file.error())));
  warn(file->warnings);
  return file;
}

}  // namespace

Expected<ComparedFiles> compared_files(const InputRequest& input, const std::optional<std::string>& reference) {
  auto file = warned_of(io::read_track(input.path, input.read, input.signs));
  if (!file) return tl::unexpected(std::move(file.error()));
  ComparedFiles files{.repairs = file->repairs};
  if (reference) {
    auto recording = warned_of(io::read_track_beside(*file, *reference, input.read));
    if (!recording) return tl::unexpected(std::move(recording.error()));
    files.reference = std::make_shared<const Track>(std::move(recording->track));
  }
  files.keys = std::make_shared<const Track>(std::move(file->track));
  return files;
}

}  // namespace orispline::cli
