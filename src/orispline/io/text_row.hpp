// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <orispline/base/decimal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Appends a line with a time and numbers, the shortest that read back as the same doubles.
void append_text_row(std::string& text, const Decimal& time, std::span<const double> numbers, char separator);

}}}  // namespace orispline::io
