// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include <orispline/families/registry.hpp>
#include <orispline/fields/warning_json.hpp>
#include <orispline/files.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "errors.hpp"
#include "json_text.hpp"
#include "keys.hpp"
#include "options.hpp"
#include "written.hpp"

namespace orispline::c { namespace {

/// Skeletons are read too, from the first file on.
void join_scenes() {
  static const bool joined = (scenes::join_formats(), true);
  static_cast<void>(joined);
}

/// With options by the names that they are stated by.
Error by_stated_names(Error error) {
  if (error.option == "path") error.option = "name";
  if (const auto* const fault = io::reading_option_of(error.option)) error.option = fault->name;
  if (const auto* const remedy = io::reading_option_of(error.remedy)) error.remedy = remedy->name;
  return error;
}

std::string words_of(const Error& error) { return describe(by_stated_names(error)); }

/// What reading did, as members of the JSON of keys.
std::string members_of(const io::TrackFile& file) {
  Json json{{"format", file.format->id}};
  Json repairs;
  io::add_repairs(repairs, file.repairs);
  json["repairs"] = std::move(repairs);
  json["ignored_columns"] = file.ignored_columns;
  json["warnings"] = warnings_json(file.warnings);
  const std::string text = json_text(json);
  return text.substr(1, text.size() - 2);
}

Expected<Keys> read(std::string name, std::string bytes, const io::StatedOptions& stated) {
  io::Reading reading;
  return io::take_options(reading, stated)
      .and_then([&] {
        return io::read_whole_track(io::Input::in_memory(std::move(name), std::move(bytes)), reading,
                                    {families_info(), jobs::family_named, words_of});
      })
      .map([](io::TrackFile file) {
        std::string members = members_of(file);
        return Keys{std::make_shared<const Track>(std::move(file.track)), std::move(members)};
      })
      .map_error(by_stated_names);
}

Expected<Written> written(const Track& track, const std::string& name, const io::StatedOptions& stated) {
  io::OutputFile file = io::OutputFile::in_memory(name);
  return io::columns_of_output(name, stated)
      .and_then([&](const io::SampleColumns& columns) { return io::write_whole_track(file, track, columns); })
      .and_then([&](std::vector<Warning> warnings) {
        return file.finish().map([&] { return Written{std::move(file).bytes(), std::move(warnings)}; });
      })
      .map_error(by_stated_names);
}

/// The options of files take a flag without a text.
Expected<io::StatedOptions> stated_for_files(const char* const* options, std::size_t count) {
  return stated_options(options, count, "");
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_files_json(char** json, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(json, "json").map([&] {
      join_scenes();
      *json = text_of_c(json_text(io::files_json()));
    });
  });
}

orispline_code orispline_keys_read(const void* bytes, size_t size, const char* name, const char* const* options,
                                   size_t option_count, orispline_keys** keys, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(keys, "keys")
        .and_then([&] { return check_pointer(name, "name"); })
        .and_then([&] { return size == 0 ? Expected<void>() : check_pointer(bytes, "bytes"); })
        .and_then([&] { return stated_for_files(options, option_count); })
        .and_then([&](const io::StatedOptions& stated) {
          join_scenes();
          return read(name, std::string(static_cast<const char*>(bytes), size), stated);
        })
        .map([&](Keys made) { *keys = handle_of<orispline_keys>(std::move(made)); });
  });
}

orispline_code orispline_keys_write(const orispline_keys* keys, const char* name, const char* const* options,
                                    size_t option_count, char** bytes, size_t* size, char** warnings,
                                    orispline_error** error) {
  return guarded(error, [&]() -> Expected<void> {
    if (warnings) *warnings = nullptr;
    if (auto there = cleared(bytes, "bytes"); !there) return there;
    const auto body = checked(keys);
    if (!body) return tl::unexpected(body.error());
    return check_pointer(size, "size")
        .and_then([&] { return check_pointer(name, "name"); })
        .and_then([&] { return stated_for_files(options, option_count); })
        .and_then([&](const io::StatedOptions& stated) {
          join_scenes();
          return written(*(*body)->track, name, stated);
        })
        .map([&](const Written& file) { give(file, bytes, size, warnings); });
  });
}
