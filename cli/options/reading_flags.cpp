// SPDX-License-Identifier: Apache-2.0
#include "options/reading_flags.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <orispline/base/formatted.hpp>

#include "options/input_options.hpp"

namespace orispline::cli {
namespace {

/// A flag for an option of io::ReadOptions, and what is said of it where it would help.
struct ReadingFlag {
  std::string_view option, flag, use;
};

constexpr std::array reading_flags{
    ReadingFlag{"format", "--input-format", ""},
    ReadingFlag{"columns", "--columns", " NAME=COLUMN,... says which is which"},
    ReadingFlag{"order", "--order", " wxyz|xyzw"},
    ReadingFlag{"representation", "--input-orientation", " quaternion|euler|matrix|rotvec"},
    ReadingFlag{"euler", "--euler", " ORDER"},
    ReadingFlag{"angle_unit", "--angle-unit", " deg|rad"},
    ReadingFlag{"time_scale", "--time-scale", " X"},
    ReadingFlag{"fps", "--fps", " N"},
    ReadingFlag{"drop_duplicates", "--drop-duplicates", " keeps the first"},
    ReadingFlag{"drop_invalid", "--drop-invalid", " drops such rows"},
    ReadingFlag{"norms", "--normalise", " takes any norm but 0"},
    ReadingFlag{"recipe", "--ignore-recipe", " reads the keys without it"},
    ReadingFlag{"sort", "--sort", " orders the rows"},
    ReadingFlag{"sort_rows", "--sort-rows", " orders the rows"}};  // of compare, where --sort is for its table

const ReadingFlag* flag_for(std::string_view option) {
  const auto found = std::ranges::find(reading_flags, option, &ReadingFlag::option);
  return found == reading_flags.end() ? nullptr : found;
}

}  // namespace

Error with_reading_flags(Error error) {
  if (const ReadingFlag* const fault = flag_for(error.option)) {
    error.message = formatted("{}: {}", fault->flag, error.message);
    error.option.clear();
  }
  if (const ReadingFlag* const remedy = flag_for(error.remedy)) {
    error.message += formatted(" ({}{})", remedy->flag, remedy->use);
    error.remedy.clear();
  }
  return error;
}

}  // namespace orispline::cli
