// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/words.hpp>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

std::string keys_text(const Track& keys) {
  const std::string count = counted(keys.keys.size(), "key");
  return keys.name.empty() ? count : formatted("{} from {}", count, printable(keys.name));
}

std::string shown_name(std::string_view file, std::string_view otherwise) {
  return file.empty() ? std::string(otherwise) : printable(file_name_of(file));
}

Places places_of(const Track& track) {
  return {track.lines, [&track](std::size_t sample) { return track.time_of(sample); }};
}

}}}  // namespace orispline::jobs
