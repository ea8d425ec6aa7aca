// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_columns.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/orientation_form.hpp>
#include <orispline/io/time_column.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::array plain_numbers{Unit{""}};
constexpr auto angles = [] {
  std::array<Unit, 1 + angle_units.size()> units{Unit{""}};
  std::ranges::transform(angle_units, units.begin() + 1, [](const AngleUnitInfo& unit) {
    return Unit{unit.suffix, unit.numerator, unit.denominator};
  });
  return units;
}();

std::span<const Unit> units_of(Representation representation) {
  const bool is_angular = representation == Representation::euler || representation == Representation::rotation_vector;
  return is_angular ? std::span<const Unit>(angles) : plain_numbers;
}

Expected<ColumnGroup> group_of(const ColumnSearch& search, std::span<const std::string_view> names,
                               Representation representation) {
  return search.group(names, units_of(representation), units_of(representation));
}

/// Columns of Euler angles, by number or by axis; where the caller states the order those by number come first.
Expected<ColumnGroup> euler_group(const ColumnSearch& search, const std::optional<EulerOrder>& order) {
  auto by_number = group_of(search, names_by_component(Representation::euler), Representation::euler);
  if (!by_number || (order && order->is_proper())) return by_number;
  auto by_axis = group_of(search, names_by_axis(order.value_or(EulerOrder{})), Representation::euler);
  if (!by_axis) return by_axis;
  const auto& first = order ? by_number : by_axis;
  const auto& second = order ? by_axis : by_number;
  return first->is_absent() && !second->is_absent() ? second : first;
}

Expected<ColumnGroup> any_group_of(const ColumnSearch& search, Representation representation) {
  if (representation == Representation::euler) return euler_group(search, std::nullopt);
  return group_of(search, names_by_component(representation), representation);
}

/// What the caller asks for, else quaternions if there are any, else the only one that is there.
Expected<Representation> representation_in(const ColumnSearch& search, const OrientationReading& reading) {
  if (reading.euler && reading.representation.value_or(Representation::euler) != Representation::euler)
    return tl::unexpected(
        Error{.code = ErrorCode::bad_argument,
              .message = "found a second option that says where the orientation is, wanted one of them",
              .option = "euler",
              .remedy = "representation"});
  if (reading.representation) return *reading.representation;
  if (reading.euler) return Representation::euler;
  std::vector<Representation> found;
  std::vector<std::string_view> examples;
  for (const Representation candidate :
       {Representation::quaternion, Representation::euler, Representation::matrix, Representation::rotation_vector}) {
    const auto group = any_group_of(search, candidate);
    if (!group) return tl::unexpected(group.error());
    if (group->is_absent()) continue;
    if (candidate == Representation::quaternion) return candidate;
    found.push_back(candidate);
    examples.push_back(group->present.front());
  }
  if (found.size() > 1)
    return mended_by("representation",
                     formatted("{} could each be the orientation, wanted one form of it", joined(examples, ", ")));
  return found.empty() ? Representation::quaternion : found.front();
}

/// Gives angles whose columns do not name a unit the one that the caller states.
Expected<void> settle_units(ColumnGroup& group, const ColumnSearch& search, std::optional<AngleUnit> unit) {
  for (std::size_t i = 0; i < group.columns.size(); ++i) {
    NumberColumn& column = group.columns[i];
    const std::string_view name = group.present[i];
    if (search.stated_unit(name, angles) || !unit_of<Unit>(search.plain_name(column.index), angles).suffix.empty())
      continue;
    if (!unit)
      return mended_by("angle_unit", formatted("{} has no unit, wanted a name such as {}_deg or {}_rad, or the unit",
                                               in_quotes(search.name(column.index)), name, name));
    column = {column.index, info_of(*unit).numerator, info_of(*unit).denominator};
  }
  return {};
}

Expected<OrientationColumns> euler_columns(const ColumnSearch& search, const OrientationReading& reading) {
  auto group = euler_group(search, reading.euler);
  if (!group) return tl::unexpected(std::move(group.error()));
  const auto by_number = names_by_component(Representation::euler);
  if (!reading.euler && !group->is_absent() && std::ranges::count(by_number, group->present.front()) > 0)
    return mended_by("euler", formatted("found {}, wanted the order of these turns as well, such as ZYX, or zyx about "
                                        "the axes of the world",
                                        joined(group->present, ", ")));
  if (auto settled = settle_units(*group, search, reading.angle_unit); !settled)
    return tl::unexpected(std::move(settled.error()));
  return OrientationColumns{{.representation = Representation::euler, .order = reading.euler.value_or(EulerOrder{})},
                            std::move(*group)};
}

using Names = std::array<std::string_view, 3>;

constexpr std::size_t units_of_a_rate = 5;

/// The rates of one order as headers name them.
struct RateOrder {
  std::string_view plural;
  Names in_body, in_world;
  std::array<Unit, 2 * units_of_a_rate> body_units;
  std::array<Unit, units_of_a_rate> world_units;
};

constexpr Unit in(AngleUnit unit, std::string_view suffix) {
  return {suffix, info_of(unit).numerator, info_of(unit).denominator};
}
constexpr Unit degree(std::string_view suffix) { return in(AngleUnit::degrees, suffix); }
constexpr Unit milliradians(std::string_view suffix) { return in(AngleUnit::milliradians, suffix); }
constexpr Unit arcseconds(std::string_view suffix) { return in(AngleUnit::arcseconds, suffix); }

constexpr std::array<RateOrder, 3> orders{
    RateOrder{"angular velocities",
              {"wx", "wy", "wz"},
              {"wx_world", "wy_world", "wz_world"},
              {Unit{"_body"}, Unit{"_body_rad_s"}, degree("_body_deg_s"), milliradians("_body_mrad_s"),
               arcseconds("_body_arcsec_s"), Unit{""}, Unit{"_rad_s"}, degree("_deg_s"), milliradians("_mrad_s"),
               arcseconds("_arcsec_s")},
              {Unit{""}, Unit{"_rad_s"}, degree("_deg_s"), milliradians("_mrad_s"), arcseconds("_arcsec_s")}},
    RateOrder{"angular accelerations",
              {"ax", "ay", "az"},
              {"ax_world", "ay_world", "az_world"},
              {Unit{"_body"}, Unit{"_body_rad_s2"}, degree("_body_deg_s2"), milliradians("_body_mrad_s2"),
               arcseconds("_body_arcsec_s2"), Unit{""}, Unit{"_rad_s2"}, degree("_deg_s2"), milliradians("_mrad_s2"),
               arcseconds("_arcsec_s2")},
              {Unit{""}, Unit{"_rad_s2"}, degree("_deg_s2"), milliradians("_mrad_s2"), arcseconds("_arcsec_s2")}},
    RateOrder{"angular jerks",
              {"jx", "jy", "jz"},
              {"jx_world", "jy_world", "jz_world"},
              {Unit{"_body"}, Unit{"_body_rad_s3"}, degree("_body_deg_s3"), milliradians("_body_mrad_s3"),
               arcseconds("_body_arcsec_s3"), Unit{""}, Unit{"_rad_s3"}, degree("_deg_s3"), milliradians("_mrad_s3"),
               arcseconds("_arcsec_s3")},
              {Unit{""}, Unit{"_rad_s3"}, degree("_deg_s3"), milliradians("_mrad_s3"), arcseconds("_arcsec_s3")}}};

Expected<std::optional<RateVector>> rate_vector(const ColumnSearch& search, const RateReading& reading,
                                                const RateOrder& order) {
  const auto in_frame = [](Frame frame) {
    return [frame](const std::optional<VectorColumns>& columns) -> std::optional<RateVector> {
      if (!columns) return std::nullopt;
      return RateVector{*columns, frame};
    };
  };
  const auto body = search.all_or_none(order.in_body, order.body_units, order.body_units);
  if (!body || *body || !reading.world) return body.map(in_frame(Frame::body));
  return search.all_or_none(order.in_world, order.world_units, order.world_units).map(in_frame(Frame::world));
}

std::string name_of(const ColumnSearch& search, const RateVector& rates) {
  return formatted("{}, {}, {}", search.name(rates.columns[0].index), search.name(rates.columns[1].index),
                   search.name(rates.columns[2].index));
}

constexpr std::array<std::string_view, 3> position_names{"px", "py", "pz"};
/// What others call them, if all three are there.
constexpr std::array<std::array<std::string_view, 3>, 2> other_position_names{{{"tx", "ty", "tz"}, {"x", "y", "z"}}};

constexpr std::array lengths{Unit{""}, Unit{"_m"}, Unit{"_mm", 1.0, 1000.0}, Unit{"_cm", 1.0, 100.0},
                             Unit{"_km", 1000.0, 1.0}};

/// Every name that a mapping may be for.
std::vector<std::string_view> canonical_names(std::span<const std::string> parameters) {
  std::vector<std::string_view> names{time_name};
  const auto append = [&names](const auto& more) { names.insert(names.end(), more.begin(), more.end()); };
  append(orientation_names());
  append(position_names);
  append(rate_names());
  for (const auto& names_of_side : inner_names) append(names_of_side);
  append(parameters);
  return names;
}

/// Whether a name is one of a quantity with one of its units behind it.
bool states_unit(std::string_view name) {
  const auto is_of = [name](const auto& names, std::span<const Unit> units) {
    return std::ranges::any_of(names, [&](std::string_view base) { return is_with_unit(name, base, units); });
  };
  for (const RateOrder& order : orders)
    if (is_of(order.in_body, order.body_units) || is_of(order.in_world, order.world_units)) return true;
  return is_of(position_names, lengths) || is_of(names_by_component(Representation::rotation_vector), angles) ||
         is_of(names_by_component(Representation::euler), angles) || is_of(names_by_axis(EulerOrder{}), angles);
}

/// An error when a mapping is for a name that no column can have.
Expected<void> check_mappings(const HeaderReading& reading) {
  const auto wanted = canonical_names(reading.parameters);
  for (const auto& [canonical, name] : reading.names)
    if (std::ranges::find(wanted, canonical) == wanted.end() && !states_unit(canonical))
      return bad_option("columns", formatted("found {}={}, wanted a name that is read before the sign: {}", canonical,
                                             name, joined(wanted, ", ")));
  return {};
}

/// What every table must have, but for the time where rows are counted.
struct RequiredColumns {
  std::optional<std::size_t> time;
  OrientationColumns orientation;
  std::optional<TimeColumns> two_of_time{};
};

Expected<RequiredColumns> required_columns(const ColumnSearch& search, const HeaderReading& reading) {
  const auto two = two_time_columns(search, reading.names);
  if (!two) return tl::unexpected(two.error());
  auto time = *two ? Expected<std::optional<std::size_t>>((*two)->index)
                   : search.column(time_name, [](std::string_view name) { return time_unit_of(name).has_value(); });
  if (time && !*time) time = search.column(time_name, counts_frames);
  if (!time) return tl::unexpected(time.error());
  auto orientation = orientation_columns(search, reading.orientation);
  if (!orientation) return tl::unexpected(std::move(orientation.error()));
  auto missing = orientation->group.missing;
  if (!*time && !reading.count_rows) missing.insert(missing.begin(), time_name);
  if (missing.empty()) return RequiredColumns{*time, std::move(*orientation), *two};
  return mended_by("columns", formatted("no column {}, found {}", joined(missing, ", "), search.found_names()));
}

Expected<std::vector<ParameterColumn>> parameter_columns(const ColumnSearch& search,
                                                         std::span<const std::string> names) {
  std::vector<ParameterColumn> columns;
  for (const std::string& name : names) {
    const auto index = search.column(name, [&name](std::string_view column) { return column == name; });
    if (!index) return tl::unexpected(index.error());
    if (*index) columns.push_back({name, **index});
  }
  return columns;
}

Expected<std::optional<VectorColumns>> position_columns(const ColumnSearch& search) {
  auto columns = search.all_or_none(position_names, lengths, lengths);
  for (const auto& names : other_position_names) {
    if (!columns || *columns) return columns;
    if (std::ranges::any_of(names, [&](std::string_view name) { return search.is_mapped(name); })) continue;
    const auto others = search.group(names, lengths, lengths);
    if (!others || others->is_complete()) columns = search.all_or_none(names, lengths, lengths);
  }
  return columns;
}

Expected<InnerColumns> inner_columns(const ColumnSearch& search) {
  InnerColumns columns;
  for (std::size_t side = 0; side < columns.size(); ++side) {
    auto found = search.all_or_none(inner_names[side], plain_numbers, plain_numbers);
    if (!found) return tl::unexpected(std::move(found.error()));
    columns[side] = *found;
  }
  return columns;
}

/// Which column has the times, and what its name says about them.
void state_time(KeyColumns& columns, std::size_t index, std::string_view name) {
  const TimeUnit unit = time_unit_of(name).value_or(time_unit_at_end_of(name));
  columns.time = index;
  columns.time_unit = unit.seconds;
  columns.states_time_unit = unit.is_stated;
  columns.counts_frames = counts_frames(name);
}

/// The names of the columns that nothing is read from.
std::vector<std::string> ignored_names(std::span<const std::string_view> header, const KeyColumns& columns) {
  std::vector<bool> is_read(header.size(), false);
  const auto mark = [&is_read](const auto& numbers) {
    for (const auto& column : numbers) is_read[column.index] = true;
  };
  if (!columns.counts_rows) is_read[columns.time] = true;
  if (columns.rest_of_time) is_read[columns.rest_of_time->index] = true;
  mark(columns.orientation);
  if (columns.position) mark(*columns.position);
  for (const auto& rate : columns.rates)
    if (rate) mark(rate->columns);
  for (const auto& inner : columns.inner)
    if (inner) mark(*inner);
  mark(columns.parameters);
  std::vector<std::string> ignored;
  for (std::size_t i = 0; i < header.size(); ++i)
    if (!is_read[i] && !header[i].empty()) ignored.emplace_back(header[i]);
  return ignored;
}

}  // namespace

std::vector<std::string_view> orientation_names() {
  std::vector<std::string_view> names;
  const auto append = [&names](const auto& more) { names.insert(names.end(), more.begin(), more.end()); };
  append(names_by_component(Representation::quaternion));
  append(names_by_axis({.turns = {0, 1, 2}}));
  for (const Representation other : {Representation::euler, Representation::matrix, Representation::rotation_vector})
    append(names_by_component(other));
  return names;
}

Expected<OrientationColumns> orientation_columns(const ColumnSearch& search, const OrientationReading& reading) {
  const auto representation = representation_in(search, reading);
  if (!representation) return tl::unexpected(representation.error());
  if (*representation == Representation::euler) return euler_columns(search, reading);
  if (reading.angle_unit)
    return bad_option("angle_unit", formatted("found an orientation in {}, wanted Euler angles",
                                              joined(names_by_component(*representation), ", ")));
  return group_of(search, names_by_component(*representation), *representation).map([&](ColumnGroup group) {
    return OrientationColumns{{.representation = *representation}, std::move(group)};
  });
}

std::vector<std::string_view> rate_names() {
  std::vector<std::string_view> names;
  for (const auto frame : {&RateOrder::in_body, &RateOrder::in_world})
    for (const RateOrder& order : orders) names.insert(names.end(), (order.*frame).begin(), (order.*frame).end());
  return names;
}

Expected<RateColumns> rate_columns(const ColumnSearch& search, const RateReading& reading) {
  RateColumns columns;
  for (std::size_t k = 0; k < static_cast<std::size_t>(reading.orders); ++k) {
    const auto found = rate_vector(search, reading, orders[k]);
    if (!found) return tl::unexpected(found.error());
    columns[k] = *found;
    if (k > 0 && columns[k] && !columns[k - 1])
      return failure(ErrorCode::bad_data,
                     formatted("found {} without {}: {} want {} beside them", name_of(search, *columns[k]),
                               joined(orders[k - 1].in_body, ", "), orders[k].plural, orders[k - 1].plural));
  }
  return columns;
}

Expected<std::optional<TimeColumns>> two_time_columns(const ColumnSearch& search, const ColumnNames& names) {
  const auto stated = names.find(time_name);
  if (stated == names.end() || search.index_of(stated->second)) return std::nullopt;
  const std::string_view text = stated->second;
  const std::size_t plus = text.find('+');
  if (plus == std::string_view::npos) return std::nullopt;
  std::array<std::size_t, 2> found{};
  std::array<TimeUnit, 2> units{};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string_view name = i == 0 ? text.substr(0, plus) : text.substr(plus + 1);
    const auto index = search.index_of(name);
    if (!index) return search.not_there(time_name, name);
    found[i] = *index;
    units[i] = time_unit_at_end_of(search.plain_name(*index));
  }
  if (!units[1].is_stated)
    return bad_option("columns", formatted("found t={}, wanted a second column whose name ends in a unit, such as "
                                           "t=sec+nanosec",
                                           stated->second));
  const bool is_exact = units[1].seconds.divided_by(units[0].seconds).is_exact;  // no decimal of a week is a second
  const std::size_t main = is_exact ? 0 : 1, rest = 1 - main;
  return TimeColumns{
      found[main], units[main].seconds, {found[rest], Fraction(units[rest].seconds, units[main].seconds)}};
}

Expected<KeyColumns> columns_of_header(std::span<const std::string_view> header, const HeaderReading& reading) {
  while (!header.empty() && header.back().empty()) header = header.first(header.size() - 1);
  if (auto checked = check_mappings(reading); !checked) return tl::unexpected(std::move(checked.error()));
  const ColumnSearch search(header, reading.names);
  auto required = required_columns(search, reading);
  if (!required) return tl::unexpected(std::move(required.error()));
  const auto position =
      reading.positions ? position_columns(search) : Expected<std::optional<VectorColumns>>(std::nullopt);
  if (!position) return tl::unexpected(position.error());
  auto rates = rate_columns(search, reading.rates);
  if (!rates) return tl::unexpected(std::move(rates.error()));
  auto inner = reading.inner_quaternions ? inner_columns(search) : InnerColumns();
  if (!inner) return tl::unexpected(std::move(inner.error()));
  auto parameters = parameter_columns(search, reading.parameters);
  if (!parameters) return tl::unexpected(std::move(parameters.error()));

  KeyColumns columns{.width = header.size(),
                     .counts_rows = reading.count_rows,
                     .form = required->orientation.form,
                     .orientation = std::move(required->orientation.group.columns),
                     .position = *position,
                     .rates = *rates,
                     .inner = *inner,
                     .parameters = std::move(*parameters)};
  if (const auto& two = required->two_of_time) {
    columns.time = two->index;
    columns.rest_of_time = two->rest;
    columns.time_unit = two->unit;
    columns.states_time_unit = true;
  } else if (!reading.count_rows) state_time(columns, *required->time, search.plain_name(*required->time));
  columns.ignored = ignored_names(header, columns);
  return columns;
}

Expected<KeyColumns> columns_of_order(std::size_t columns, const ReadOptions& options) {
  const bool has_time = !options.count_rows || (columns != 4 && columns != 7);
  const std::size_t first = has_time ? 1 : 0;
  if (columns != first + 4 && columns != first + 7)
    return failure(ErrorCode::bad_data,
                   formatted("found {} columns without a header, wanted 5 (t and the quaternion) or 8 (px, py, pz "
                             "after them)",
                             columns));
  KeyColumns result{.width = columns, .counts_rows = options.count_rows};
  const bool is_w_last = options.order == QuaternionOrder::xyzw;
  for (std::size_t k = 0; k < 4; ++k) result.orientation.push_back({first + (is_w_last ? (k + 3) % 4 : k)});
  if (columns == first + 7) result.position = three_columns_from(first + 4);
  return result;
}

std::vector<std::string_view> header_of(const TextTable& table) {
  const auto row = table.cells().first(width_of(table.cells()));
  return is_header(row) ? std::vector(row.begin(), row.end()) : table.header_in_comment();
}

Warning commented_header(std::string_view comment, const std::string& path) {
  return {.code = "commented_header",
          .message = formatted("the columns are named by a comment, {}, since no row names them", in_quotes(comment)),
          .where = {.file = path}};
}

std::optional<std::string_view> header_option(const ReadOptions& options) {
  if (!options.columns.empty()) return "columns";
  if (options.orientation.representation) return "representation";
  if (options.orientation.euler) return "euler";
  if (options.orientation.angle_unit) return "angle_unit";
  return std::nullopt;
}

tl::unexpected<Error> misplaced(const TextTable& table, std::string_view option, std::string message) {
  auto refused = bad_option(option, std::move(message));
  refused.value().where = table.here();
  return refused;
}

Expected<KeyColumns> located(const TextTable& table, Expected<KeyColumns> columns) {
  if (!columns) columns.error().where = table.here();
  return columns;
}

}}}  // namespace orispline::io
