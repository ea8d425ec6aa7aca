// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

// The language of manual pages, as far as ours use it; groff and mandoc read it.

namespace orispline::cli {

/// A text as it is: every sign as the user types it, for man prints other ones for some, such as a minus; in ASCII.
[[nodiscard]] std::string roff_text(std::string_view text);

[[nodiscard]] std::string roff_bold(std::string_view text);
[[nodiscard]] std::string roff_italic(std::string_view text);

/// `.SH "NAME"`, a section of a page.
[[nodiscard]] std::string roff_section(std::string_view title);
/// `.SS "Reading"`, a part of a section.
[[nodiscard]] std::string roff_part(std::string_view title);
/// A term, which is in roff already, with the words that explain it below.
[[nodiscard]] std::string roff_term(std::string_view term, std::string_view words);
/// Lines that are filled to the width of the page, below the title of a section.
[[nodiscard]] std::string roff_filled(std::string_view lines);
/// The same below other text.
[[nodiscard]] std::string roff_paragraph(std::string_view lines);
/// Lines that stay as they are, below the title of a section.
[[nodiscard]] std::string roff_lines(std::string_view lines);

}  // namespace orispline::cli
