// SPDX-License-Identifier: Apache-2.0
#include "output/noted_output.hpp"

#include <utility>

namespace orispline::cli {
namespace {

template <class File>
Noted<File> noted(File file) {
  auto note = std::make_unique<RemovedWhenInterrupted>(file.part());
  return {std::move(note), std::move(file)};
}

}  // namespace

Expected<Noted<io::OutputFile>> open_output(const std::string& path) {
  const InterruptionHeld held(path);
  return io::OutputFile::open(path).map(noted<io::OutputFile>);
}

Expected<Noted<io::SampleWriter>> open_samples(const std::string& path, const io::SampleColumns& columns,
                                               std::size_t rows) {
  const InterruptionHeld held(path);
  return io::SampleWriter::open(path, columns, rows).map(noted<io::SampleWriter>);
}

}  // namespace orispline::cli
