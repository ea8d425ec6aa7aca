// SPDX-License-Identifier: Apache-2.0
#include "commands/help/manual_page.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/file_format.hpp>

#include "commands/help/roff.hpp"
#include "output/exit_code.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view examples_head = "Examples:\n";

bool is_positional(const Option& option) { return !option.names.starts_with('-'); }

bool takes_several(const Option& option) { return std::holds_alternative<std::vector<std::string>*>(option.typed); }

std::string page_name(const Program& program, const Command& command) {
  return formatted("{}-{}", program.name, command.name);
}

/// `orispline-sample(1)`
std::string reference(std::string_view page) { return roff_bold(page) + "(1)"; }

/// With even gaps between words, and words that are whole.
std::string head(const Program& program, std::string_view name, std::string_view description) {
  std::string capitals(name), line(description);
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  line.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(line.front())));
  if (line.ends_with('.')) line.pop_back();
  return formatted(".TH {} 1 \"\" \"{}\" \"User Commands\"\n.nh\n.ad l\n{}{} \\- {}\n", roff_text(capitals),
                   roff_text(program.version), roff_section("NAME"), roff_text(name), roff_text(line));
}

/// The parts of a footer between blank lines.
std::vector<std::string_view> parts_of(std::string_view footer) {
  std::vector<std::string_view> parts;
  for (std::size_t end = footer.find("\n\n"); end != footer.npos; end = footer.find("\n\n")) {
    parts.push_back(footer.substr(0, end));
    footer.remove_prefix(end + 2);
  }
  parts.push_back(footer);
  return parts;
}

/// A line whose end is that of a sentence ends a paragraph.
std::string paragraphs(std::string_view part) {
  std::string text, paragraph;
  for (const std::string_view line : pieces_of(part, '\n')) {
    paragraph.append(paragraph.empty() ? "" : "\n").append(line);
    if (line.ends_with('.')) text += roff_paragraph(std::exchange(paragraph, {}));
  }
  return paragraph.empty() ? text : text + roff_paragraph(paragraph);
}

/// What the footer says besides examples and exit codes, which have sections of their own.
std::string remarks(std::string_view footer) {
  std::string text;
  for (const std::string_view part : parts_of(footer))
    if (!part.empty() && !part.starts_with(examples_head) && part != exit_codes()) text += paragraphs(part);
  return text;
}

std::string examples(std::string_view footer) {
  std::string text;
  for (std::string_view part : parts_of(footer)) {
    if (!part.starts_with(examples_head)) continue;
    part.remove_prefix(examples_head.size());
    std::string lines;
    for (std::string_view line : pieces_of(part, '\n'))
      lines.append(lines.empty() ? "" : "\n").append(line.substr(std::min(line.find_first_not_of(' '), line.size())));
    text += roff_section("EXAMPLES") + roff_lines(lines);
  }
  return text;
}

std::string exit_status() {
  std::string text = roff_section("EXIT STATUS");
  for (const ExitMeaning& exit : exit_meanings)
    text += roff_term(roff_bold(formatted("{}", static_cast<int>(exit.code))), exit.meaning);
  return text;
}

/// What stands for an option's argument: `FILE`, `csv|tum`, `NAME ...`.
std::string argument(const Option& option) {
  if (option.is_flag()) return "";
  return " " + roff_italic(option.argument) + (takes_several(option) ? " ..." : "");
}

std::string explained(const Option& option) {
  std::string term;
  for (const std::string_view name : pieces_of(option.names, ','))
    term += (term.empty() ? "" : ", ") + (is_positional(option) ? roff_italic(name) : roff_bold(name));
  if (!is_positional(option) || option.argument != option.names) term += argument(option);
  return roff_term(term, option.sentence + (option.is_required ? " (required)" : ""));
}

std::string synopsis(const Program& program, const Command& command) {
  std::string text = formatted("{}{} [\\fIOPTION\\fR]...", roff_section("SYNOPSIS"),
                               roff_bold(formatted("{} {}", program.name, command.name)));
  for (const Option& option : command.options) {
    if (!is_positional(option) && option.is_required)
      text += formatted(" {}{}", roff_bold(pieces_of(option.names, ',').back()), argument(option));
    if (!is_positional(option)) continue;
    const std::string typed = roff_italic(option.names) + (takes_several(option) ? "..." : "");
    text += option.is_required ? " " + typed : formatted(" [{}]", typed);
  }
  return text + "\n";
}

std::string arguments(const Command& command) {
  std::string text;
  for (const Option& option : command.options)
    if (is_positional(option)) text += explained(option);
  return text.empty() ? text : roff_section("ARGUMENTS") + text;
}

/// Every command has it, and the program.
std::string help_option() {
  return roff_term(formatted("{}, {}", roff_bold("-h"), roff_bold("--help")), "Print the help and exit");
}

/// In the sections of the help, those without one first.
std::string options(const Command& command) {
  std::vector<std::string> sections{""};
  for (const Option& option : command.options)
    if (std::ranges::find(sections, option.section) == sections.end()) sections.push_back(option.section);
  std::string text = roff_section("OPTIONS") + help_option();
  for (const std::string& section : sections) {
    if (!section.empty()) text += roff_part(section);
    for (const Option& option : command.options)
      if (!is_positional(option) && option.section == section) text += explained(option);
  }
  return text;
}

/// The page of the program, and those of other commands that an example or a sentence names.
std::string see_also(const Program& program, const Command& command, const std::deque<Command>& commands) {
  std::string said = command.footer;
  for (const Option& option : command.options) said += option.sentence;
  std::string text = formatted("{}{}", roff_section("SEE ALSO"), reference(program.name));
  for (const Command& other : commands)
    if (&other != &command && said.find(formatted("{} {}", program.name, other.name)) != said.npos)
      text += formatted(",\n{}", reference(page_name(program, other)));
  return formatted("{}\n{}", text,
                   roff_paragraph("The page of the program lists the methods and the formats of files."));
}

std::string page_of_command(const Program& program, const Command& command, const std::deque<Command>& commands) {
  return head(program, page_name(program, command), command.description) + synopsis(program, command) +
         roff_section("DESCRIPTION") + roff_filled(command.description + ".") + remarks(command.footer) +
         arguments(command) + options(command) + examples(command.footer) + exit_status() +
         see_also(program, command, commands);
}

std::string formats_of_files() {
  std::string text = roff_section("FORMATS");
  for (const io::FormatInfo* format : io::formats_read())
    text += roff_term(roff_bold(format->id), formatted("{}: {}", format->title, format->summary));
  for (const io::FormatInfo* format : io::formats_written())
    if (!format->is_read())
      text += roff_term(roff_bold(format->id), formatted("{}: {}; written only", format->title, format->summary));
  return text + roff_paragraph("The page docs/files.md of the documentation says what the files hold.");
}

std::string methods() {
  std::string text = roff_section("METHODS");
  for (const FamilyInfo& family : families_info()) text += roff_term(roff_bold(family.name), family.title);
  return text;
}

std::string page_of_program(const Program& program, const std::deque<Command>& commands) {
  const std::string name = roff_bold(program.name);
  std::string text = head(program, program.name, program.description) + roff_section("SYNOPSIS") +
                     formatted("{} \\fICOMMAND\\fR [\\fIOPTION\\fR]... [\\fIARGUMENT\\fR]...\n.br\n{} [{} | {}]\n",
                               name, name, roff_bold("--help"), roff_bold("--version")) +
                     roff_section("DESCRIPTION") + roff_filled(program.description) + remarks(program.footer) +
                     roff_paragraph("Every command has a page of its own.") + roff_section("COMMANDS");
  for (const Command& command : commands)
    text += roff_term(reference(page_name(program, command)), command.description);
  return text + roff_section("OPTIONS") + help_option() +
         roff_term(roff_bold("--version"), "Print the version and exit") + methods() + formats_of_files() +
         examples(program.footer) + exit_status();
}

}  // namespace

std::vector<ManualPage> manual_pages(const Program& program, const std::deque<Command>& commands) {
  std::vector<ManualPage> pages{{program.name, page_of_program(program, commands)}};
  for (const Command& command : commands)
    pages.push_back({page_name(program, command), page_of_command(program, command, commands)});
  return pages;
}

}  // namespace orispline::cli
