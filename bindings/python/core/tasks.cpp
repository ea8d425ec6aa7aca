// SPDX-License-Identifier: Apache-2.0
#include "tasks.hpp"

#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/output_file.hpp>

#include "errors.hpp"

namespace nb = nanobind;

namespace orispline::python {

Method method_for(const std::optional<std::string>& stated, const Track& track, std::string_view usual,
                  bool (*fits)(const FamilyInfo&)) {
  if (stated) return value_of(method_from_text(*stated));
  std::optional<Method> own = value_of(method_of(track.recipe, track.name));
  if (own && fits(*value_of(find_family(own->name)))) return std::move(*own);
  return value_of(method_from_text(usual));
}

Track at_times(const Keys& keys, const std::optional<Numbers>& times) {
  if (!times) return *keys.track;
  const auto seconds = span_of(*times);
  return value_of(keys.track->with_times({seconds.begin(), seconds.end()}));
}

void write_page(const std::string& path, const report::Page& page) {
  value_of([&] {
    const nb::gil_scoped_release release;
    return io::OutputFile::open(path).and_then([&](io::OutputFile file) {
      return file.write(report::document(page)).and_then([&] { return file.finish(); });
    });
  }());
}

}  // namespace orispline::python
