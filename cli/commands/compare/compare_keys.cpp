// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_keys.hpp"

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

Expected<ComparedFiles> compared_files(const CompareRequest& request, const std::optional<std::string>& reference) {
  const auto input = warned_of(io::read_track(request.input.path, request.input.read, request.input.signs));
  if (!input) return tl::unexpected(input.error());
  const auto with_repairs = [&](ComparedData data) {
    warn(data.warnings);
    return ComparedFiles{std::move(data), input->repairs};
  };
  if (!reference) return beside_own_samples(input->track, request.decimations).map(with_repairs);
  return warned_of(io::read_track_beside(*input, *reference, request.input.read)).and_then([&](const auto& truth) {
    return beside_recording(input->track, truth.track).map(with_repairs);
  });
}

}  // namespace orispline::cli
