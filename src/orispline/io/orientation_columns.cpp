// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/orientation_columns.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

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
    if (!unit_of<Unit>(search.plain_name(column.index), angles).suffix.empty()) continue;
    const std::string_view name = group.present[i];
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

}}}  // namespace orispline::io
