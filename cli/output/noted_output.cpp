// SPDX-License-Identifier: Apache-2.0
#include "output/noted_output.hpp"

#include <filesystem>
#include <utility>

#include "output/gathered_output.hpp"
#include "output/output_folder.hpp"

namespace orispline::cli {

namespace {

/// Of pipes and devices there is no note, and they may take long to open: there nothing waits.
std::unique_ptr<const InterruptionHeld> held_while_opening(const std::string& path) {
  return io::is_stream(path) ? nullptr : std::make_unique<const InterruptionHeld>();
}

template <class File>
Noted<File> noted(File file) {
  auto note = std::make_unique<RemovedWhenInterrupted>(file.part());
  return {std::move(note), std::move(file)};
}

/// Of several outputs: the folder is made with the first file in it.
Expected<void> make_folder_of(const std::string& path) {
  return gathered_here() ? make_folder(std::filesystem::path(path).parent_path().string()) : Expected<void>();
}

}  // namespace

Expected<Noted<io::OutputFile>> open_output(const std::string& path) {
  const auto held = held_while_opening(path);
  return make_folder_of(path).and_then([&] { return io::OutputFile::open(path); }).map(noted<io::OutputFile>);
}

Expected<Noted<io::SampleWriter>> open_samples(const std::string& path, const io::SampleColumns& columns,
                                               std::size_t rows) {
  const auto held = held_while_opening(path);
  return make_folder_of(path)
      .and_then([&] { return io::SampleWriter::open(path, columns, rows); })
      .map(noted<io::SampleWriter>);
}

Expected<void> check_output(const std::string& path) {
  return gathered_here() ? Expected<void>() : io::check_output(path);
}

}  // namespace orispline::cli
