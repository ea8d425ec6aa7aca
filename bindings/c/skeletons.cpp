// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/suggestion.hpp>
#include <orispline/fields/typed_numbers.hpp>
#include <orispline/files.hpp>
#include <orispline/math/euler.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "errors.hpp"
#include "options.hpp"
#include "values.hpp"
#include "written.hpp"

namespace orispline::c { namespace {

using Stated = io::StatedOptions;

/// Error (bad_argument): an option that is none of these.
template <std::size_t Count>
Expected<void> check_names(const Stated& stated, const std::array<std::string_view, Count>& known) {
  for (const auto& [name, text] : stated)
    if (std::ranges::find(known, name) == known.end()) return bad_option(name, unknown_word("option", name, known));
  return {};
}

Value skeleton_of(scenes::Scene scene) {
  auto motion = std::make_shared<const MotionFile>(scenes::motion_file_of(scene));
  scene.skeleton = {};
  scene.clips = {};
  return {std::move(motion), std::make_shared<const scenes::Scene>(std::move(scene))};
}

Expected<Value> read_skeleton(std::string name, std::string bytes, const Stated& stated) {
  io::Reading reading;
  return check_names(stated,
                     std::array<std::string_view, 5>{"clip", "drop_duplicates", "signs", "salvage", "rest_frame"})
      .and_then([&] { return io::take_options(reading, stated); })
      .and_then([&] {
        return scenes::read_scene(io::Input::in_memory(std::move(name), std::move(bytes)),
                                  {.drop_duplicates = reading.options.drop_duplicates,
                                   .signs = reading.options.scene.signs,
                                   .salvage = reading.options.scene.salvage,
                                   .rest_frame = reading.options.scene.rest_frame});
      })
      .and_then([&](scenes::Scene scene) { return scenes::with_clips(std::move(scene), reading.options.scene.clips); })
      .map(skeleton_of);
}

Expected<scenes::SceneWriting> writing_in(const Stated& stated) {
  scenes::SceneWriting writing;
  if (auto known =
          check_names(stated, std::array<std::string_view, 4>{"output_euler", "rate", "position_scale", "compress"});
      !known)
    return tl::unexpected(std::move(known.error()));
  for (const auto& [name, text] : stated) {
    if (name == "rate" || name == "position_scale") {
      const auto number = typed::positive(text);
      if (!number) return bad_option(name, number.error().message);
      (name == "rate" ? writing.rate : writing.position_scale) = *number;
      continue;
    }
    if (name == "compress") {
      const auto compression = key_compression_in(text);
      if (!compression) return tl::unexpected(compression.error());
      writing.compression = *compression;
      continue;
    }
    writing.euler = euler_order_of(text);
    if (!writing.euler || writing.euler->is_proper())
      return bad_option(name, formatted("found '{}', wanted three different axes, such as ZYX", text));
  }
  return writing;
}

Expected<Written> written(const Value& value, const std::string& name, const Stated& stated) {
  const auto* const motion = std::get_if<std::shared_ptr<const MotionFile>>(&value.value);
  if (!motion) return bad_option("value", "found no skeleton, wanted one");
  return writing_in(stated)
      .and_then([&](const scenes::SceneWriting& writing) {
        return scenes::written_scene(scenes::with_motion(*value.file, **motion), name, writing);
      })
      .map([](scenes::SceneWritten file) {
        return Written{std::move(file.bytes), std::move(file.warnings)};
      });
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_value_of_skeleton(const void* bytes, size_t size, const char* name, const char* const* options,
                                           size_t option_count, orispline_value** value, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(value, "value")
        .and_then([&] { return check_pointer(name, "name"); })
        .and_then([&] { return size == 0 ? Expected<void>() : check_pointer(bytes, "bytes"); })
        .and_then([&] { return stated_options(options, option_count, ""); })
        .and_then([&](const Stated& stated) {
          return read_skeleton(name, std::string(static_cast<const char*>(bytes), size), stated);
        })
        .map([&](Value made) { *value = handle_of<orispline_value>(std::move(made)); });
  });
}

orispline_code orispline_value_write(const orispline_value* value, const char* name, const char* const* options,
                                     size_t option_count, char** bytes, size_t* size, char** warnings,
                                     orispline_error** error) {
  return guarded(error, [&]() -> Expected<void> {
    if (warnings) *warnings = nullptr;
    if (auto there = cleared(bytes, "bytes"); !there) return there;
    const auto body = checked(value);
    if (!body) return tl::unexpected(body.error());
    return check_pointer(size, "size")
        .and_then([&] { return check_pointer(name, "name"); })
        .and_then([&] { return stated_options(options, option_count, ""); })
        .and_then([&](const Stated& stated) { return written(**body, name, stated); })
        .map([&](const Written& file) { give(file, bytes, size, warnings); });
  });
}
