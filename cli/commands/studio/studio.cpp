// SPDX-License-Identifier: Apache-2.0
#include "commands/studio/studio.hpp"

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

#include "commands/studio/studio_request.hpp"
#include "commands/studio/studio_template.hpp"
#include "options/file_places.hpp"
#include "output/browser.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"
#include "output/temporary_file.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view ending = ".html";

/// What is about keys wants keys.
Expected<void> check_has_keys(const StudioArguments& options) {
  if (options.keys) return {};
  std::string option;
  for (const auto& [name, typed] : options.reading.reading)
    if (typed.are_given()) option = flag_of(name);
  if (options.beside) option = "--beside";
  if (options.method) option = "--method";
  if (option.empty()) return {};
  return usage_failure(formatted("{}: found no INPUT, wanted the file of keys that it is about", option));
}

Expected<void> check_place(const StudioArguments& options) {
  if (!options.output) return {};
  if (options.output->empty()) return usage_failure("-o: found an empty name, wanted FILE or -");
  std::vector<OtherFile> read;
  if (options.keys) read.push_back({"INPUT", *options.keys});
  return check_output_apart("-o", *options.output, read)
      .and_then([&] {
        return check_extension("-o", *options.output, {ending, ".htm"});
      })
      .and_then([&] { return check_output(*options.output); });
}

/// The document in the page; none for the start screen.
Expected<std::string> data_in(const StudioArguments& options) {
  if (!options.keys) return std::string();
  return studio_request(options).and_then(jobs::studio).map([](jobs::StudioOutcome outcome) {
    warn(std::move(outcome.warnings));
    return std::move(outcome.data);
  });
}

/// Gives the path of the page; none where it went to a stream.
Expected<std::string> written(const StudioArguments& options, std::string_view page) {
  if (!options.output) return write_temporary_file("orispline-studio", ending, page);
  return open_output(*options.output).and_then([&](Noted<io::OutputFile> output) {
    return output.file.write(page).and_then([&] { return output.file.finish(); }).map([&] {
      return io::is_stream(*options.output) ? std::string() : *options.output;
    });
  });
}

}  // namespace

Expected<void> studio(const StudioArguments& options) {
  if (studio_template().empty())
    return usage_failure(
        "studio: orispline was built without the page of the studio, wanted a build after 'make studio'");
  return check_has_keys(options)
      .and_then([&] { return check_place(options); })
      .and_then([&] { return data_in(options); })
      .and_then([&](const std::string& data) { return written(options, jobs::studio_page(studio_template(), data)); })
      .and_then([&](const std::string& path) -> Expected<void> {
        if (path.empty()) return {};
        if (!options.no_open) open_in_browser(path);
        return print_document(formatted("{}\n", printable(path)));
      });
}

}  // namespace orispline::cli
