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

constexpr int highest_order = 3;  // of rates that keys may have

/// The keys as those of a method's curve, with what it has of its own for each of them as columns.
Expected<Track> for_method(Track track, Method method) {
  return family_of_method(method).map([&](const FamilyInfo* family) {
    method = completed(std::move(method), *family, track);
    track.settings = settings_per_key(method, track.keys.size());
    track.recipe = recipe_for(method, track);
    return std::move(track);
  });
}

Warning lost(const io::FormatInfo& format, const std::string& what, const std::string& path) {
  return {.code = "not_written",
          .message = std::string(format.file) + " has no columns for " + what + ", which are left out",
          .where = {.file = path}};
}

Expected<std::vector<Warning>> write_track(Track track, const std::string& path, const io::StatedOptions& stated,
                                           const io::FormatInfo* like) {
  auto columns = io::columns_of_output(path, stated);
  if (!columns) return tl::unexpected(std::move(columns.error()));
  if (like) columns = io::columns_like(*like, *columns, path, stated);
  const io::FormatInfo& format = *columns->format;
  columns->positions = !track.keys.positions().empty();
  columns->derivatives = format.holds.rates ? highest_order : 0;
  // Digits are those of quaternions: other forms are those of a unit quaternion.
  if (columns->form.representation != io::Representation::quaternion) track.as_read.clear();
  std::vector<Warning> warnings;
  if (const auto warning = io::recipe_not_stated(track, *columns, path)) warnings.push_back(*warning);
  if (!format.holds.rates && !track.keys.angular_velocities().empty()) warnings.push_back(lost(format, "rates", path));
  if (!format.holds.rates && track.keys.have_inner_quaternions())
    warnings.push_back(lost(format, "inner quaternions", path));
  if (!format.holds.settings && !track.settings.empty()) {  // without them the keys are for another curve
    warnings.push_back(lost(format, "settings", path));
    track.settings.clear();
    track.recipe = {};
  }
  return io::OutputFile::open(path)
      .and_then([&](io::OutputFile file) {
        return io::write_tracks(file, {&track, 1}, *columns).and_then([&] { return file.finish(); });
      })
      .map([&] { return std::move(warnings); });
}

/// Warnings, as texts.
nb::list write(const Keys& keys, const std::string& path, const io::StatedOptions& stated, const std::string& like,
               const std::optional<MethodText>& stated_method) {
  const auto method = stated_method ? std::optional(stated_method->method()) : std::nullopt;
  auto warnings = [&]() -> Expected<std::vector<Warning>> {
    const nb::gil_scoped_release release;
    auto track = method ? for_method(*keys.track, *method) : Expected<Track>(*keys.track);
    if (!track) return tl::unexpected(std::move(track.error()));
    return write_track(std::move(*track), path, stated, format_of(like));
  }();
  if (!warnings) raise(warnings.error());
  return told(*warnings);
}

}  // namespace

void add_key_writing(nb::module_& module) {
  module.def("write_keys", &write, "keys"_a, "path"_a, "stated"_a, "like"_a, "method"_a.none());
}

}  // namespace orispline::python
