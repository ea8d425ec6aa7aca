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

namespace {

void say(std::string_view message) {
  if (Gathered* const gathered = gathered_here()) gathered->warnings.emplace_back(message);
  else tell(formatted("orispline: warning: {}\n", printable(message)));
}

}  // namespace

void warn(std::string_view message) { warn(std::vector{Warning{.message = std::string(message)}}); }

void warn(std::vector<Warning> warnings) {
  std::set<std::string> told;
  const Gathered* const gathered = gathered_here();
  for (Warning& warning : warnings) {
    warning = with_flags(std::move(warning));
    const auto [text, is_new] = told.insert(describe(warning));
    if (!is_new) continue;
    warned_here().push_back(warning);
    if (gathered && warning.where.file == gathered->input && !warning.where.line) {
      warning.where.file.clear();  // which is named once for all that is said of it
      say(describe(warning));
    } else {
      say(*text);
    }
  }
}

}  // namespace orispline::cli
