// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/expected.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

std::string describe(const Error& error) {
  std::string text = error.where.file;
  if (error.where.line) text += formatted(":{}", *error.where.line);
  if (error.where.line && error.where.column) text += formatted(":{}", *error.where.column);
  if (!text.empty()) text += ": ";
  if (error.where.key) text += formatted("key {}: ", *error.where.key);
  if (error.where.time_index) text += formatted("time {}: ", *error.where.time_index);
  if (error.where.curve) text += formatted("curve {}: ", *error.where.curve);
  if (!error.option.empty()) text += error.option + ": ";
  text += error.message;
  return printable(error.remedy.empty() ? text : formatted("{} (option {})", text, error.remedy));
}

}}  // namespace orispline
