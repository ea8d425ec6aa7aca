// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/format_choice.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/io/other_kinds.hpp>
#include <orispline/io/time_column.hpp>

#include <algorithm>
#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

using Candidates = std::vector<const FormatInfo*>;

/// What a file of this name may be, the most likely first.
Candidates candidates_for(const std::string& path, const ReadOptions& options) {
  if (options.format) return {options.format};
  Candidates some;
  std::ranges::copy_if(formats(), std::back_inserter(some), [&](const auto* f) { return f->has_extension_of(path); });
  return some.empty() ? formats_read() : some;
}

Expected<void> check_time_scale(const ReadOptions& options) {
  if (options.clock.frames_per_second && !options.clock.frames_per_second->is_positive())
    return bad_option("fps", formatted("found {} frames per second, wanted a number greater than 0",
                                       options.clock.frames_per_second->to_string()));
  if (options.count_turns && options.sort)
    return bad_option("signs", "found as-typed with `sort`, wanted rows that stand in the order of their turns");
  if (!options.time_scale || options.time_scale->is_positive()) return {};
  return bad_option("time_scale",
                    formatted("the time scale is {}, wanted a number greater than 0", options.time_scale->to_string()));
}

tl::unexpected<Error> not_read(const FormatInfo& format, const std::string& path) {
  return failure(ErrorCode::bad_argument,
                 formatted("keys are not read from {} files, wanted {}", format.title, any_of(formats_read())),
                 {.file = path});
}

Expected<void> move_to_first_row(TextTable& table) {
  const auto first = table.next();
  if (!first) return tl::unexpected(first.error());
  if (!*first) return failure(ErrorCode::bad_data, "empty: no keys", {.file = table.path()});
  return {};
}

/// Tables have neither clips nor joints, nor do they state how many rows they have.
Expected<void> check_scene(const FormatInfo& format, const ReadOptions& options) {
  const SceneTrack& scene = options.scene;
  if (format.reading.tracks || !(scene.is_given() || scene.salvage || scene.rest_frame)) return {};
  const std::string_view option = scene.joint            ? "joint"
                                  : !scene.clips.empty() ? "clip"
                                  : scene.salvage        ? "salvage"
                                  : scene.rest_frame     ? "rest_frame"
                                                         : "space";
  return bad_option(option, formatted("found {}, which has no skeleton, wanted a file of skeletons", format.file));
}

using Source = std::variant<KeyRowsSource, TracksSource>;

/// Of a table at its first row.
Expected<Source> source_in(const FormatInfo& format, TextTable table, const ReadOptions& options) {
  auto layout = format.reading.layout(table, options);
  if (!layout) {
    if (auto kind = other_kind(joined(table.cells(), " ")))
      return failure(ErrorCode::bad_data, std::move(*kind), {.file = table.path()});
    return tl::unexpected(std::move(layout.error()));
  }
  KeyColumns& columns = layout->columns;
  if (options.no_positions) columns.position.reset();
  if (options.count_turns && columns.form.representation != Representation::euler)
    return bad_option(
        "signs", formatted("found as-typed for {} without Euler angles, wanted as-given or shortest", format.file));
  if (options.time_scale && columns.rest_of_time)
    return bad_option("time_scale",
                      "found it with two columns of times, wanted their units at the ends of their names");
  if (options.time_scale) {
    layout->columns.time_unit = *options.time_scale;
    layout->columns.states_time_unit = true;
    layout->columns.whole_times = false;
  } else if (layout->columns.counts_frames) {
    const auto unit = seconds_per_frame(layout->names[layout->columns.time], options.clock);
    if (!unit) return mended_by(unit.error().remedy, unit.error().message, table.here());
    layout->columns.time_unit = *unit;
    layout->columns.states_time_unit = true;
  }
  return KeyRowsSource{&format, std::move(table), std::move(*layout)};
}

Expected<Source> source_of(const FormatInfo& format, LineReader lines, const ReadOptions& options) {
  if (!format.reading.layout) return TracksSource{&format, std::move(lines)};
  TextTable table(std::move(lines));
  if (format.reading.delimiter) table.set_delimiter(*format.reading.delimiter);
  if (auto moved = move_to_first_row(table); !moved) return tl::unexpected(std::move(moved.error()));
  return source_in(format, std::move(table), options);
}

/// Lets the first row decide.
Expected<Source> likest_source(const Candidates& candidates, LineReader lines, const ReadOptions& options) {
  lines.keep();
  TextTable table(std::move(lines));
  if (auto moved = move_to_first_row(table); !moved) return tl::unexpected(std::move(moved.error()));
  const FormatInfo* const like = likest(candidates, table, options, Likeness::likely);
  const FormatInfo& format = like ? *like : *candidates.front();
  if (!format.reading.layout) return TracksSource{&format, std::move(table).from_its_beginning()};
  table.forget();
  return source_in(format, std::move(table), options);
}

}  // namespace

Expected<void> check_frames(const ReadOptions& options) {
  if (options.conjugate && options.inverse_poses)
    return bad_option("inverse_poses",
                      "found `conjugate` as well, which turns the orientations back, wanted one of them");
  return check(options.frames);
}

const FormatInfo* likest(std::span<const FormatInfo* const> formats, const TextTable& table, const ReadOptions& options,
                         Likeness least) {
  const auto likeness_of = [&](const FormatInfo* format) {
    return format->reading.likeness ? format->reading.likeness(table, options) : Likeness::none;
  };
  const auto best = std::ranges::max_element(formats, {}, likeness_of);
  return best == formats.end() || likeness_of(*best) < least ? nullptr : *best;
}

Expected<Source> open_keys(KeyInput input, const ReadOptions& options) {
  if (auto checked = check_time_scale(options); !checked) return tl::unexpected(std::move(checked.error()));
  if (auto checked = check_frames(options); !checked) return tl::unexpected(std::move(checked.error()));
  const Candidates candidates = candidates_for(input.path(), options);
  if (!candidates.front()->is_read()) return not_read(*candidates.front(), input.path());
  if (auto checked = check_scene(*candidates.front(), options); !checked)
    return tl::unexpected(std::move(checked.error()));
  LineReader lines = std::move(input).lines();
  if (candidates.size() == 1) return source_of(*candidates.front(), std::move(lines), options);
  return likest_source(candidates, std::move(lines), options);
}

}}}  // namespace orispline::io
