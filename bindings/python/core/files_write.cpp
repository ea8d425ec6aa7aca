// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>

#include "errors.hpp"
#include "files.hpp"
#include "keys.hpp"
#include "method_text.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

/// The keys as those of a method's curve, with what it has of its own for each of them as columns.
Expected<Track> for_method(Track track, Method method) {
  return family_of_method(method).map([&](const FamilyInfo* family) {
    method = completed(std::move(method), *family, track);
    track.settings = settings_per_key(method, track.keys.size());
    track.recipe = recipe_for(method, track);
    return std::move(track);
  });
}

struct Written {
  std::string bytes;  ///< of a file in memory
  std::vector<Warning> warnings;
};

Expected<Written> write_track(Track track, const std::string& path, bool in_memory, const io::StatedOptions& stated,
                              const io::FormatInfo* like) {
  auto columns = io::columns_of_output(path, stated);
  if (!columns) return tl::unexpected(std::move(columns.error()));
  if (like) columns = io::columns_like(*like, *columns, path, stated);
  auto opened = in_memory ? io::OutputFile::in_memory(path) : io::OutputFile::open(path);
  return std::move(opened).and_then([&](io::OutputFile file) {
    return io::write_whole_track(file, std::move(track), *columns).and_then([&](std::vector<Warning> warnings) {
      return file.finish().map([&] { return Written{std::move(file).bytes(), std::move(warnings)}; });
    });
  });
}

/// The bytes of a file in memory, and warnings.
nb::tuple write_keys(const Keys& keys, const std::string& path, bool in_memory, const io::StatedOptions& stated,
                     const std::string& like, const std::optional<MethodText>& stated_method) {
  const auto method = stated_method ? std::optional(stated_method->method()) : std::nullopt;
  const auto written = [&]() -> Expected<Written> {
    const nb::gil_scoped_release release;
    auto track = method ? for_method(*keys.track, *method) : Expected<Track>(*keys.track);
    if (!track) return tl::unexpected(std::move(track.error()));
    return write_track(std::move(*track), path, in_memory, stated, format_of(like));
  }();
  if (!written) raise(written.error());
  return nb::make_tuple(nb::bytes(written->bytes.data(), written->bytes.size()), told(written->warnings));
}

}  // namespace

void add_key_writing(nb::module_& module) {
  module.def("write_keys", &write_keys, "keys"_a, "path"_a, "in_memory"_a, "stated"_a, "like"_a, "method"_a.none());
}

}  // namespace orispline::python
