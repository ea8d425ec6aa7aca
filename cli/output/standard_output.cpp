// SPDX-License-Identifier: Apache-2.0
#include "output/standard_output.hpp"

#include <cstdio>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/output_file.hpp>

namespace orispline::cli {

Expected<void> print_document(std::string_view text) {
  auto output = io::OutputFile::open(std::string(io::standard_stream));
  if (!output) return tl::unexpected(output.error());
  return output->write(text).and_then([&] { return output->finish(); });
}

void tell(std::string_view text) noexcept {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void warn(std::string_view message) { tell(formatted("orispline: warning: {}\n", message)); }

void warn_if_any(const std::optional<std::string>& message) {
  if (message) warn(*message);
}

}  // namespace orispline::cli
