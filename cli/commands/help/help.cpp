// SPDX-License-Identifier: Apache-2.0
#include "commands/help/help.hpp"

#include <filesystem>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/output_file.hpp>

#include "commands/help/manual_page.hpp"
#include "options/option_text.hpp"
#include "output/noted_output.hpp"
#include "output/output_folder.hpp"

namespace orispline::cli {

Expected<void> help(const HelpArguments& arguments, const Program& program, const std::deque<Command>& commands) {
  if (!arguments.manual_pages)
    return usage_failure("help: wanted a command, such as 'orispline help sample', or --manual-pages");
  if (arguments.command)
    return usage_failure(formatted(
        "help: found the command {} and --manual-pages, which writes those of all commands; wanted one of both",
        in_quotes(*arguments.command)));
  if (auto made = make_folder(*arguments.manual_pages); !made) return made;
  for (const ManualPage& page : manual_pages(program, commands)) {
    const auto path = std::filesystem::path(*arguments.manual_pages) / (page.name + ".1");
    auto written = open_output(path.string()).and_then([&](Noted<io::OutputFile> output) {
      return output.file.write(page.text).and_then([&] { return output.file.finish(); });
    });
    if (!written) return written;
  }
  return {};
}

}  // namespace orispline::cli
