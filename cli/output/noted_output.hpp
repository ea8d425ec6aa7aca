// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <orispline/io/sample_writer.hpp>

#include "output/interruption.hpp"

namespace orispline::cli {

/// An output that is being written, and the note by which an interruption removes what there is of it.
template <class File>
struct Noted {
  std::unique_ptr<RemovedWhenInterrupted> note;  // outlives the file
  File file;
};

/// What io::OutputFile::open() gives, noted before an interruption can come between.
[[nodiscard]] Expected<Noted<io::OutputFile>> open_output(const std::string& path);

/// What io::SampleWriter::open() gives, noted in the same way.
[[nodiscard]] Expected<Noted<io::SampleWriter>> open_samples(const std::string& path, const io::SampleColumns& columns,
                                                             std::size_t rows);

/// Whether open_output() would open it, asked before long work; not of several inputs, where the work on one is short
/// beside that on all. Error: bad_access.
[[nodiscard]] Expected<void> check_output(const std::string& path);

}  // namespace orispline::cli
