// SPDX-License-Identifier: Apache-2.0
#include "output/keys_file.hpp"

#include "output/interruption.hpp"

namespace orispline::cli {

Expected<void> write_keys(const std::string& path, const Track& keys, const io::SampleColumns& columns) {
  InterruptionHeld held(path);
  return io::OutputFile::open(path).and_then([&](io::OutputFile file) {
    const RemovedWhenInterrupted unfinished(file.part(), held);
    return io::write_tracks(file, {&keys, 1}, columns).and_then([&] { return file.finish(); });
  });
}

}  // namespace orispline::cli
