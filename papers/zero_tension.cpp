// SPDX-License-Identifier: Apache-2.0
// Theorem 1 of Tan et al. 2018 and of the 6th degree, "for all real tensions": at 0 it is false.
#include "papers/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <orispline/analysis/direction_beside.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/example_data.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;
namespace color = report::color;

constexpr std::size_t corner_key = 2;  // the one whose tension is 0 in the picture

/// A theorem and the curve that it is about.
struct Theorem {
  const char *picture, *method, *letter, *claim, *reason;
  double tension;  ///< of the keys at which it is not 0
};

constexpr Theorem of_quintic{
    .picture = "000-theorem1",
    .method = "quintic",
    .letter = "α",
    .claim = "G2",
    .reason =
        "With α = 0 at a key q' and q'' vanish there, on both sides. The path goes on in the direction of q''', "
        "which has other increments before the key than behind it.",
    .tension = 0.35};
constexpr Theorem of_sextic{
    .picture = "003-theorem1",
    .method = "sextic",
    .letter = "β",
    .claim = "G3",
    .reason =
        "With β = 0 at a key q' vanishes there, and q'' = 5/2 (b − a) does not. So the path arrives in the "
        "direction of a − b and leaves in that of b − a: it turns back.",
    .tension = 0.08};

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return degrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Where a path arrives at an inner key and leaves it; absent where the body stands still beside it.
struct Corner {
  std::optional<DirectionBeside> before, after;
  [[nodiscard]] std::optional<double> angle() const {
    return before && after ? std::optional(angle_between(before->direction, after->direction)) : std::nullopt;
  }
};

Corner corner_at(const AnyCurve& curve, const Continuity& in_time, std::span<const double> knots, std::size_t key) {
  const double t = knots[key], spacing = std::min(t - knots[key - 1], knots[key + 1] - t);
  const auto on = [&](Side side) { return direction_beside(curve.motion(t, side), side, spacing, in_time); };
  return {on(Side::left), on(Side::right)};
}

report::Cell cell_of(const std::optional<double>& value) {
  return value ? report::Cell(*value) : report::Cell(std::string("none"));
}

report::Cell order_cell(const std::optional<DirectionBeside>& beside) {
  return cell_of(beside ? std::optional(static_cast<double>(beside->order)) : std::nullopt);
}

/// The angle between ω right before and right behind the key; absent where one of them is 0.
std::optional<double> angle_nearby(const AnyCurve& curve, double t) {
  constexpr double beside = 1e-5;  // [s]
  const Eigen::Vector3d before = curve.motion(t - beside).angular_velocity,
                        behind = curve.motion(t + beside).angular_velocity;
  if (before.isZero(0.0) || behind.isZero(0.0)) return std::nullopt;
  return angle_between(before, behind);
}

std::vector<Recipe> recipes_of(const Theorem& theorem, std::size_t keys) {
  std::vector<double> one(keys, theorem.tension);
  one[corner_key] = 0.0;
  return {{formatted("{} = {:g}", theorem.letter, theorem.tension),
           theorem.method,
           std::vector(keys, theorem.tension),
           {color::grey, 2.0}},
          {formatted("{} = {:g}, at key {} 0", theorem.letter, theorem.tension, corner_key + 1),
           theorem.method,
           one,
           {color::red, 2.0}},
          {formatted("{} = 0", theorem.letter), theorem.method, std::vector(keys, 0.0), {color::blue, 2.0}}};
}

report::Table corners_table(const Theorem& theorem, const std::vector<Served>& curves, const KeysInstead& keys) {
  report::Table table{
      .title = formatted("Theorem 1 says {} for all tensions; the corner at a key where it is 0", theorem.claim),
      .columns = {{"tensions"},
                  {"key"},
                  {"|ω| [rad/s]", Notation::fixed, 4},
                  {"order before"},
                  {"behind"},
                  {"corner [degrees]", Notation::fixed, 1},
                  {"of ω at ±1e-5 s", Notation::fixed, 1}}};
  const auto knots = keys.keys.times();
  for (const auto& [recipe, curve] : curves) {
    const Continuity in_time = continuity_at_keys(curve);
    for (std::size_t key = 1; key + 1 < knots.size(); ++key) {
      if (recipe.tension[key] != 0.0 && key != corner_key) continue;
      const Corner corner = corner_at(curve, in_time, knots, key);
      table.rows.push_back({recipe.label, static_cast<double>(key + 1), speed(curve.motion(knots[key])),
                            order_cell(corner.before), order_cell(corner.after), cell_of(corner.angle()),
                            cell_of(angle_nearby(curve, knots[key]))});
    }
  }
  table.notes = {
      "The order is that of the lowest derivative of q that is not 0: in its direction the path arrives and "
      "leaves.",
      theorem.reason, keys.note};
  return table;
}

/// How far ω points away from where the path leaves the third key, over the two segments beside it; nothing where it
/// leaves in no direction.
report::Series direction(const Served& served, std::span<const double> knots) {
  constexpr int steps = 200;
  report::Series series{served.recipe.label, {}, {}, served.recipe.stroke};
  const Corner corner = corner_at(served.curve, continuity_at_keys(served.curve), knots, corner_key);
  if (!corner.after) return series;
  const auto add = [&](double t, const Eigen::Vector3d& to) {
    series.x.push_back(t);
    series.y.push_back(angle_between(corner.after->direction, to));
  };
  const auto add_inside = [&](std::size_t segment) {
    for (int k = 1; k < steps; ++k) {
      const double t = std::lerp(knots[segment], knots[segment + 1], static_cast<double>(k) / steps);
      add(t, served.curve.motion(t).angular_velocity);
    }
  };
  add_inside(corner_key - 1);
  if (corner.before) add(knots[corner_key], corner.before->direction);
  series.x.push_back(knots[corner_key]);
  series.y.push_back(std::nan(""));
  add(knots[corner_key], corner.after->direction);
  add_inside(corner_key);
  return series;
}

Picture corner_picture(const Theorem& theorem, const std::vector<Served>& curves, const Keyframes& keys) {
  const auto knots = keys.times();
  Picture picture(theorem.picture, 860, 430);
  report::SpherePicture sphere = sphere_of(curves, keys, Eigen::Vector3d::UnitX());
  report::Chart chart{.title = formatted("angle of ω to where the path leaves key {} [degrees]", corner_key + 1),
                      .series = {},
                      .marks = marks_at(knots.subspan(corner_key - 1, 3)),
                      .y = report::Range{-5.0, 185.0}};
  for (const Served& served : std::span(curves).first(2)) chart.series.push_back(direction(served, knots));
  report::draw_legend(picture.drawing, {20.0, 18.0}, names_of(curves));
  picture.drawing.text({20.0, 44.0}, "path of the body's x axis", {report::Anchor::start});
  picture.add(report::facing(axis_path(keys.orientations(), Eigen::Vector3d::UnitX())), {215.0, 240.0}, 175.0,
              std::move(sphere));
  picture.add({475.0, 90.0, 355.0, 270.0}, std::move(chart));
  return picture;
}

Expected<Findings> at_zero(const Theorem& theorem, const KeysInstead& keys) {
  return curves_through(keys.keys, recipes_of(theorem, keys.keys.size())).map([&](const std::vector<Served>& curves) {
    return Findings{{corners_table(theorem, curves, keys)}, {corner_picture(theorem, curves, keys.keys)}};
  });
}

Expected<Findings> at_zero(const Theorem& theorem) {
  return five_keys_at({0.0, 1.0, 2.0, 3.0, 4.0}).and_then([&](const Keyframes& keys) {
    return at_zero(theorem, {keys, five_keys_note});
  });
}

}  // namespace

Expected<Findings> experiment::quintic_at_zero() { return at_zero(of_quintic); }
Expected<Findings> experiment::quintic_at_zero_on(const KeysInstead& keys) { return at_zero(of_quintic, keys); }
Expected<Findings> experiment::sextic_at_zero() { return at_zero(of_sextic); }
Expected<Findings> experiment::sextic_at_zero_on(const KeysInstead& keys) { return at_zero(of_sextic, keys); }

}  // namespace orispline::cli
