// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_option.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <orispline/base/pieces.hpp>
#include <orispline/io/clock.hpp>
#include <orispline/io/file_option_words.hpp>
#include <orispline/io/rotation_value.hpp>
#include <orispline/io/round_clock.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

Expected<Fraction> positive_in(std::string_view option, std::string_view text) {
  const auto fraction = Fraction::parse(text);
  if (fraction && fraction->is_positive()) return *fraction;
  return not_wanted(option, text, "a number greater than 0, or a fraction such as 30000/1001");
}

Expected<void> take_columns(Reading& reading, std::string_view text) {
  for (const std::string_view piece : pieces_of(text, ',')) {
    const std::size_t equals = piece.find('=');
    if (equals == 0 || equals == std::string_view::npos || equals + 1 == piece.size())
      return not_wanted("columns", piece, "NAME=VALUE");
    const std::string name(piece.substr(0, equals));
    if (!reading.options.columns.emplace(name, piece.substr(equals + 1)).second)
      return bad_option("columns", formatted("'{}' is given twice, wanted it once", name));
  }
  return {};
}

Expected<void> take_epoch(Reading& reading, std::string_view text) {
  const auto instant = parse_iso_time(text);
  if (!instant) return not_wanted("epoch", text, "a time of ISO 8601 such as 2024-02-29T12:30:00Z");
  reading.options.clock.zero = *instant;
  return {};
}

Expected<void> take_unwrap(Reading& reading, std::string_view text) {
  reading.options.clock.round = clock_round_of(text);
  if (reading.options.clock.round) return {};
  return not_wanted("unwrap", text, "week, day, or a counter such as 24bit*1us, int16 or uint32");
}

template <AxesOf Whose>
Expected<void> take_axes(Reading& reading, std::string_view text) {
  FrameChange& frames = reading.options.frames;
  return axis_change_of(text, Whose).map(into(Whose == AxesOf::world ? frames.world.axes : frames.body.axes));
}

template <CoordinateChange FrameChange::*Side>
Expected<void> take_rotation(std::string_view option, Reading& reading, std::string_view text) {
  return rotation_value(option, text).map(into((reading.options.frames.*Side).rotation));
}

std::string axes_argument() { return "FROM:TO"; }
std::string rotation_argument() { return "ROTATION"; }

constexpr std::string_view as_typed = "as-typed";

std::string signs_argument() { return formatted("{}|{}", list_of<sign_words>(), as_typed); }

/// Signs that are those of the turns which Euler angles state, or as any.
Expected<void> take_signs(Reading& reading, std::string_view text) {
  reading.options.count_turns = text == as_typed;
  const auto found = std::ranges::find(sign_words, text, &OptionWord<Signs>::first);
  if (found == sign_words.end() && !reading.options.count_turns) return not_wanted("signs", text, signs_argument());
  reading.signs = reading.options.count_turns ? Signs::as_given : found->second;
  reading.options.scene.signs = reading.signs;
  return {};
}

Expected<void> take_session(Reading& reading, std::string_view text) {
  if (text == "all") {
    reading.options.session = all_sessions;
    return {};
  }
  const auto number = Decimal::parse(text);
  if (!number || !number->is_whole() || *number < Decimal::power_of_ten(0) || *number > Decimal::power_of_ten(9))
    return not_wanted("session", text, "the number of a recording, from 1, or all");
  reading.options.session = static_cast<std::size_t>(number->to_double());
  return {};
}

Expected<void> take_salvage(Reading& reading, std::string_view) {
  reading.options.scene.salvage = true;
  return {};
}

Expected<void> take_rest_frame(Reading& reading, std::string_view text) {
  const auto number = Decimal::parse(text);
  if (!number || !number->is_whole() || *number < Decimal() || *number > Decimal::power_of_ten(9))
    return not_wanted("rest_frame", text, "the number of a frame, from 0");
  reading.options.scene.rest_frame = static_cast<std::size_t>(number->to_double());
  return {};
}

template <bool ReadOptions::*Member>
Expected<void> set(Reading& reading, std::string_view) {
  reading.options.*Member = true;
  return {};
}

using ReadingOption = FileOption<Reading>;

const std::array reading_list{
    ReadingOption{.name = "input_format",
                  .sentence = "Format of the file [told by its extension and content]",
                  .argument = [] { return list_of(formats_read()); },
                  .take =
                      [](Reading& r, std::string_view text) {
                        return format_in("input_format", text, formats_read()).map(into(r.options.format));
                      },
                  .member = "format"},
    ReadingOption{.name = "columns",
                  .sentence = "Names of columns in your file, such as t=sclk_ticks,qw=q0_w",
                  .argument = [] { return std::string("NAME=COLUMN,..."); },
                  .take = take_columns,
                  .member = "columns",
                  .use = "says which is which",
                  .is_repeated = true},
    ReadingOption{
        .name = "order",
        .sentence = "Order of the quaternion in a file without a header",
        .argument = list_of<order_words>,
        .take = [](Reading& r,
                   std::string_view text) { return word_in<order_words>("order", text).map(into(r.options.order)); },
        .member = "order"},
    ReadingOption{.name = "input_orientation",
                  .sentence = "Columns to read the orientation from [the quaternion, else the form that is there]",
                  .argument = list_of<representation_words>,
                  .take =
                      [](Reading& r, std::string_view text) {
                        return word_in<representation_words>("input_orientation", text)
                            .map(into(r.options.orientation.representation));
                      },
                  .member = "representation"},
    ReadingOption{
        .name = "euler",
        .sentence = "Order of Euler angles: capitals for turns about body axes (ZYX, ZXZ), small letters for "
                    "world axes (zyx) [ZYX]",
        .argument = [] { return std::string("ORDER"); },
        .take = [](Reading& r,
                   std::string_view text) { return euler_in("euler", text).map(into(r.options.orientation.euler)); },
        .member = "euler"},
    ReadingOption{
        .name = "angle_unit",
        .sentence = "Unit of Euler angles, if the names of their columns do not end in one such as _deg",
        .argument = list_of<angle_unit_words>,
        .take =
            [](Reading& r, std::string_view text) {
              return word_in<angle_unit_words>("angle_unit", text).map(into(r.options.orientation.angle_unit));
            },
        .member = "angle_unit"},
    ReadingOption{
        .name = "time_scale",
        .sentence = "Seconds in one unit of the time column, such as 1e-3 or 1/24 [told by the column's name "
                    "or the size of its numbers, else 1]",
        .argument = [] { return std::string("X"); },
        .take = [](Reading& r,
                   std::string_view text) { return positive_in("time_scale", text).map(into(r.options.time_scale)); },
        .member = "time_scale"},
    ReadingOption{.name = "fps",
                  .sentence = "Frames per second, such as 24 or 30000/1001, if the times are a column 'frame'",
                  .argument = [] { return std::string("N"); },
                  .take =
                      [](Reading& r, std::string_view text) {
                        return positive_in("fps", text).map(into(r.options.clock.frames_per_second));
                      },
                  .member = "fps"},
    ReadingOption{.name = "epoch",
                  .sentence = "Date that counts as 0 s, if the times are dates of ISO 8601 [1970-01-01T00:00:00Z]",
                  .argument = [] { return std::string("TIME"); },
                  .take = take_epoch},
    ReadingOption{.name = "unwrap",
                  .sentence = "Count on where the clock comes round: after a week, a day, or all numbers of a counter "
                              "such as 24bit*1us, or int16 in units of the column",
                  .argument = [] { return std::string("ROUND"); },
                  .take = take_unwrap,
                  .member = "unwrap",
                  .use = "counts on where the clock comes round"},
    ReadingOption{.name = "clip",
                  .sentence = "Clip of a file of skeletons, by its name [all of them]",
                  .argument = [] { return std::string("NAME"); },
                  .take =
                      [](Reading& r, std::string_view text) {
                        r.options.scene.clips.emplace_back(text);
                        return Expected<void>();
                      },
                  .member = "clip",
                  .use = "chooses one",
                  .is_repeated = true},
    ReadingOption{.name = "joint",
                  .sentence = "Joint of a file of skeletons, by its name, for what is done with one track",
                  .argument = [] { return std::string("NAME"); },
                  .take =
                      [](Reading& r, std::string_view text) {
                        r.options.scene.joint = text;
                        return Expected<void>();
                      },
                  .member = "joint",
                  .use = "chooses one"},
    ReadingOption{
        .name = "space",
        .sentence = "Whether a joint's orientation is that in the frame of its parent or in the world [local]",
        .argument = list_of<space_words>,
        .take =
            [](Reading& r, std::string_view text) {
              return word_in<space_words>("space", text).map(into(r.options.scene.space));
            },
        .member = "space"},
    ReadingOption{.name = "conjugate",
                  .sentence = "Read orientations that turn world into body, as C-kernels of SPICE hold them; positions "
                              "are kept as they are",
                  .take = set<&ReadOptions::conjugate>},
    ReadingOption{.name = "inverse_poses",
                  .sentence = "Read poses that take the world into the body, as COLMAP's take it into the camera: "
                              "orientations are turned back, and positions become those of the body",
                  .take = set<&ReadOptions::inverse_poses>,
                  .member = "inverse_poses"},
    ReadingOption{.name = "world_axes",
                  .sentence =
                      "Axes of the world in the file and those wanted, such as NED:ENU or RUB:RFU: where +x, +y "
                      "and +z point (North, South, East, West, or Right, Left, Front, Back; Up, Down)",
                  .argument = axes_argument,
                  .take = take_axes<AxesOf::world>,
                  .member = "world_axes",
                  .use = "changes it there too"},
    ReadingOption{.name = "body_axes",
                  .sentence = "Axes of the body in the file and those wanted, such as FRD:FLU or RDF:RUB",
                  .argument = axes_argument,
                  .take = take_axes<AxesOf::body>,
                  .member = "body_axes",
                  .use = "changes it there too"},
    ReadingOption{
        .name = "world_rotation",
        .sentence = "Rotation that takes coordinates in the world into those wanted, after its axes: "
                    "qw=0.8,qx=0,qy=0,qz=0.6 or roll_deg=0,pitch_deg=0,yaw_deg=90 or a file of one row",
        .argument = rotation_argument,
        .take = [](Reading& r,
                   std::string_view text) { return take_rotation<&FrameChange::world>("world_rotation", r, text); },
        .member = "world_rotation"},
    ReadingOption{
        .name = "body_rotation",
        .sentence =
            "Rotation that takes coordinates in the body into those wanted, after its axes, stated in the same way",
        .argument = rotation_argument,
        .take = [](Reading& r,
                   std::string_view text) { return take_rotation<&FrameChange::body>("body_rotation", r, text); },
        .member = "body_rotation"},
    ReadingOption{.name = "signs",
                  .sentence =
                      "Turn the shortest way between keys, the way that the signs of the quaternions say, or as far as "
                      "Euler angles say, also by more than a turn",
                  .argument = signs_argument,
                  .take = take_signs},
    ReadingOption{.name = "ignore_recipe",
                  .sentence = "Ignore the comment in which the file names the method of its keys",
                  .take =
                      [](Reading& r, std::string_view) {
                        r.options.recipe = RecipeUse::ignored;
                        return Expected<void>();
                      },
                  .member = "recipe",
                  .use = "reads the keys without it"},
    ReadingOption{
        .name = "normalise",
        .sentence = "Accept quaternions of any norm but 0 [only norms within 2 % of 1], and matrices near a rotation",
        .take =
            [](Reading& r, std::string_view) {
              r.options.norms = Norms::any;
              return Expected<void>();
            },
        .member = "norms",
        .use = "takes any norm but 0"},
    ReadingOption{.name = "drop_duplicates",
                  .sentence = "Keep only the first of several rows with the same time",
                  .take = set<&ReadOptions::drop_duplicates>,
                  .member = "drop_duplicates",
                  .use = "keeps the first"},
    ReadingOption{
        .name = "drop_invalid",
        .sentence = "Drop rows with NaN, infinite or empty cells, with a quaternion of zeros or a stray time of 0",
        .take = set<&ReadOptions::drop_invalid>,
        .member = "drop_invalid",
        .use = "drops such rows"},
    ReadingOption{.name = "salvage",
                  .sentence = "Read the whole frames of a BVH file that was cut off",
                  .take = take_salvage,
                  .member = "salvage",
                  .use = "reads those that are whole"},
    ReadingOption{.name = "rest_frame",
                  .sentence = "Frame of a BVH file, from 0, whose pose is the rest pose [that of its offsets, with no "
                              "turns]",
                  .argument = [] { return std::string("N"); },
                  .take = take_rest_frame},
    ReadingOption{.name = "sort",
                  .sentence = "Sort the rows by time",
                  .take = set<&ReadOptions::sort>,
                  .member = "sort",
                  .use = "orders the rows"},
    ReadingOption{
        .name = "session",
        .sentence = "Recording of a file that holds several, one behind the other: its number, or all of them",
        .argument = [] { return std::string("N|all"); },
        .take = take_session,
        .member = "session",
        .use = "reads one of them"},
    ReadingOption{.name = "gap",
                  .sentence = "Intervals between keys longer than S seconds are gaps, which no curve bridges [none, or "
                              "as the file says]",
                  .argument = [] { return std::string("S"); },
                  .take =
                      [](Reading& r, std::string_view text) {
                        return positive_in("gap", text).map([&r](const Fraction& s) { r.options.gap = s.to_double(); });
                      },
                  .member = "gap"},
    ReadingOption{.name = "jumps",
                  .sentence =
                      "Two different rows of one time are a jump of the motion, which no curve bridges [only if "
                      "the file says so]",
                  .take = set<&ReadOptions::jumps>,
                  .member = "jumps",
                  .use = "cuts the motion there"},
    ReadingOption{.name = "no_positions",
                  .sentence = "Read no positions, whatever columns there are",
                  .take = set<&ReadOptions::no_positions>},
};

}  // namespace

std::span<const FileOption<Reading>> reading_options() noexcept { return reading_list; }

const FileOption<Reading>* reading_option_of(std::string_view member) noexcept {
  const auto found = std::ranges::find(reading_list, member, &ReadingOption::member);
  return member.empty() || found == reading_list.end() ? nullptr : &*found;
}

Expected<void> take_options(Reading& reading, const StatedOptions& stated) {
  return take_all<Reading>(reading, reading_list, stated);
}

}}}  // namespace orispline::io
