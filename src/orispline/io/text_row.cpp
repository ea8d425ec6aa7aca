// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/text_row.hpp>

#include <array>
#include <cmath>

#include <orispline/base/number_text.hpp>
#include <orispline/io/sample_columns.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

void append_text_row(std::string& text, const Decimal& time, std::span<const double> numbers, char separator) {
  time.append_to(text);
  std::array<char, RowNumbers::most*(1 + longest_shortest_text) + shortest_text_room> row;
  char* end = row.data();
  for (const double value : numbers) {
    *end++ = separator;
    if (!std::isinf(value)) end = write_shortest_text(end, value);  // a band that knows nothing is empty
  }
  *end++ = '\n';
  text.append(row.data(), end);
}

}}}  // namespace orispline::io
