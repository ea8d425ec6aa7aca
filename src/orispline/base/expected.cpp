// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/expected.hpp>

namespace orispline {

std::string describe(const Error& error) {
  std::string text = error.where.file;
  if (error.where.line) text += ":" + std::to_string(*error.where.line);
  if (error.where.line && error.where.column) text += ":" + std::to_string(*error.where.column);
  if (!text.empty()) text += ": ";
  if (error.where.key) text += "key " + std::to_string(*error.where.key) + ": ";
  if (error.where.time_index) text += "time " + std::to_string(*error.where.time_index) + ": ";
  if (error.where.curve) text += "curve " + std::to_string(*error.where.curve) + ": ";
  return text + error.message;
}

}  // namespace orispline
