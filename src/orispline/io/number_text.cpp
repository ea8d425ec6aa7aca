// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/number_text.hpp>

#include <fmt/compile.h>

namespace orispline::io {

// Compiled, fmt's format is as fast as `std::to_chars`, and its text is that of "{}" everywhere else.
char* ShortestText::write(char* to, double value) { return fmt::format_to(to, FMT_COMPILE("{}"), value); }

}  // namespace orispline::io
