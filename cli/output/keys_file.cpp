// SPDX-License-Identifier: Apache-2.0
#include "output/keys_file.hpp"

#include "output/gathered_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

Expected<void> write_keys(const std::string& path, const Track& keys, const io::SampleColumns& columns) {
  return open_output(path)
      .and_then([&](Noted<io::OutputFile> output) {
        return io::write_tracks(output.file, {&keys, 1}, columns).and_then([&] {
          return put_in_place(std::move(output));
        });
      })
      .map([&] {
        if (const auto warning = io::recipe_not_stated(keys, columns, path)) warn({*warning});
      });
}

}  // namespace orispline::cli
