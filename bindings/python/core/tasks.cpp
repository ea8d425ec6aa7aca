// SPDX-License-Identifier: Apache-2.0
#include "tasks.hpp"

#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/output_file.hpp>

#include "errors.hpp"

namespace nb = nanobind;

namespace orispline::python {

jobs::ChosenMethod method_chosen(const std::optional<MethodText>& stated, const Track& keys,
                                 const jobs::UsualMethod& usual) {
  const auto named = stated ? std::optional(stated->method()) : std::nullopt;
  return value_of(jobs::chosen_method(named, keys, usual));
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
