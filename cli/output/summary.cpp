// SPDX-License-Identifier: Apache-2.0
#include "output/summary.hpp"

#include <orispline/base/quoted.hpp>
#include <orispline/fields/warning_json.hpp>
#include <orispline/io/file_format.hpp>

namespace orispline::cli {

std::string destination(const std::string& output) {
  return output == io::standard_stream ? "standard output" : printable(output);
}

Json json_of_warnings() { return warnings_json(warned_here()); }

}  // namespace orispline::cli
