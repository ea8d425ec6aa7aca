// SPDX-License-Identifier: Apache-2.0
#include "output/standard_output.hpp"

#include <cstdio>
#include <set>
#include <string>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/output_file.hpp>

#include "options/option_text.hpp"
#include "output/gathered_output.hpp"

namespace orispline::cli {

Expected<void> print_document(std::string_view text) {
  if (Gathered* const gathered = gathered_here()) return gathered->documents.emplace_back(text), Expected<void>();
  auto output = io::OutputFile::open(std::string(io::standard_stream));
  if (!output) return tl::unexpected(output.error());
  return output->write(text).and_then([&] { return output->finish(); });
}

void tell(std::string_view text) {
  if (Gathered* const gathered = gathered_here()) {
    gathered->told += text;
    return;
  }
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void warn(std::string_view message) {
  if (Gathered* const gathered = gathered_here()) gathered->warnings.emplace_back(message);
  else tell(formatted("orispline: warning: {}\n", printable(message)));
}

void warn(std::vector<Warning> warnings) {
  std::set<std::string> told;
  if (const Gathered* const gathered = gathered_here())
    for (Warning& warning : warnings)  // which is named once for all that is said of it
      if (warning.where.file == gathered->input && !warning.where.line) warning.where.file.clear();
  for (const Warning& warning : warnings)
    if (const auto [text, is_new] = told.insert(describe(with_flags(warning))); is_new) warn(*text);
}

}  // namespace orispline::cli
