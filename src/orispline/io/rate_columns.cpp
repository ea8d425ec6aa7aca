// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/rate_columns.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/io/orientation_form.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

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
constexpr Unit degrees(std::string_view suffix) { return in(AngleUnit::degrees, suffix); }
constexpr Unit milliradians(std::string_view suffix) { return in(AngleUnit::milliradians, suffix); }
constexpr Unit arcseconds(std::string_view suffix) { return in(AngleUnit::arcseconds, suffix); }

constexpr std::array<RateOrder, 3> orders{
    RateOrder{"angular velocities",
              {"wx", "wy", "wz"},
              {"wx_world", "wy_world", "wz_world"},
              {Unit{"_body"}, Unit{"_body_rad_s"}, degrees("_body_deg_s"), milliradians("_body_mrad_s"),
               arcseconds("_body_arcsec_s"), Unit{""}, Unit{"_rad_s"}, degrees("_deg_s"), milliradians("_mrad_s"),
               arcseconds("_arcsec_s")},
              {Unit{""}, Unit{"_rad_s"}, degrees("_deg_s"), milliradians("_mrad_s"), arcseconds("_arcsec_s")}},
    RateOrder{"angular accelerations",
              {"ax", "ay", "az"},
              {"ax_world", "ay_world", "az_world"},
              {Unit{"_body"}, Unit{"_body_rad_s2"}, degrees("_body_deg_s2"), milliradians("_body_mrad_s2"),
               arcseconds("_body_arcsec_s2"), Unit{""}, Unit{"_rad_s2"}, degrees("_deg_s2"), milliradians("_mrad_s2"),
               arcseconds("_arcsec_s2")},
              {Unit{""}, Unit{"_rad_s2"}, degrees("_deg_s2"), milliradians("_mrad_s2"), arcseconds("_arcsec_s2")}},
    RateOrder{"angular jerks",
              {"jx", "jy", "jz"},
              {"jx_world", "jy_world", "jz_world"},
              {Unit{"_body"}, Unit{"_body_rad_s3"}, degrees("_body_deg_s3"), milliradians("_body_mrad_s3"),
               arcseconds("_body_arcsec_s3"), Unit{""}, Unit{"_rad_s3"}, degrees("_deg_s3"), milliradians("_mrad_s3"),
               arcseconds("_arcsec_s3")},
              {Unit{""}, Unit{"_rad_s3"}, degrees("_deg_s3"), milliradians("_mrad_s3"), arcseconds("_arcsec_s3")}}};

Expected<std::optional<RateVector>> rate_vector(const ColumnSearch& search, const RateReading& reading,
                                                const RateOrder& order) {
  const auto in_frame = [](Frame frame) {
    return [frame](const std::optional<VectorColumns>& columns) -> std::optional<RateVector> {
      if (!columns) return std::nullopt;
      return RateVector{*columns, frame};
    };
  };
  const auto body = search.vector(order.in_body, order.body_units, order.body_units);
  if (!body || *body || !reading.world) return body.map(in_frame(Frame::body));
  return search.vector(order.in_world, order.world_units, order.world_units).map(in_frame(Frame::world));
}

std::string name_of(const ColumnSearch& search, const RateVector& rates) {
  return formatted("{}, {}, {}", search.name(rates.columns[0].index), search.name(rates.columns[1].index),
                   search.name(rates.columns[2].index));
}

}  // namespace

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

}}}  // namespace orispline::io
