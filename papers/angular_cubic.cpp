// SPDX-License-Identifier: Apache-2.0
// Eberly, section 6, the example: squad in the plane.
#include "papers/experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/curve/motion.hpp>
#include <orispline/math/geodesic.hpp>
#include <orispline/report/chart.hpp>

namespace orispline::cli {

namespace {

using report::Notation;
namespace color = report::color;
using Order3 = Jet<double, 3>;

/// q_n = cos θ_n + i sin θ_n; the note gives no numbers, these are ours.
constexpr std::array theta{-0.3, 0.2, 1.0, 0.7, -0.1, 0.4};

/// The angle with its first two derivatives.
struct Angle {
  double value, rate, acceleration;
};

Angle angle_of(const Order3& phi) { return {phi.derivative(0), phi.derivative(1), phi.derivative(2)}; }

/// φ(t) as printed, between θ_n and θ_{n+1}.
Angle angular_cubic(std::size_t n, double at) {
  const Order3 t = Order3::variable(at), v = Order3(1.0) - t;
  return angle_of(t * t * v * (-0.5 * theta[n + 2]) +
                  t * (Order3(2.0) + 2.0 * v - 3.0 * (v * v)) * (0.5 * theta[n + 1]) +
                  v * (Order3(2.0) + 2.0 * t - 3.0 * (t * t)) * (0.5 * theta[n]) + t * v * v * (-0.5 * theta[n - 1]));
}

/// The Catmull–Rom cubic through the same angles.
Angle catmull_rom(std::size_t n, double at) {
  const Order3 t = Order3::variable(at);
  const double a = theta[n - 1], b = theta[n], c = theta[n + 1], d = theta[n + 2];
  return angle_of(0.5 * (Order3(2.0 * b) + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t) +
                         (3.0 * b - a - 3.0 * c + d) * (t * t * t)));
}

Eigen::Quaterniond in_plane(double angle) { return {std::cos(angle), std::sin(angle), 0.0, 0.0}; }

/// squad through the quaternions themselves, inner ones by (22); half of ω and α about the axis.
Angle squad_angle(std::size_t n, double at) {
  const auto inner = [](std::size_t k) { return in_plane(-(theta[k + 1] - 6.0 * theta[k] + theta[k - 1]) / 4.0); };
  const auto q =
      squad<Order3>(constant<Order3>(in_plane(theta[n])), constant<Order3>(inner(n)), constant<Order3>(inner(n + 1)),
                    constant<Order3>(in_plane(theta[n + 1])), Order3::variable(at));
  const Motion m = motion_from_jet(q);
  return {std::atan2(m.orientation.x(), m.orientation.w()), 0.5 * m.angular_velocity.x(),
          0.5 * m.angular_acceleration.x()};
}

double largest_difference(Angle (*a)(std::size_t, double), Angle (*b)(std::size_t, double), double Angle::*part) {
  double largest = 0.0;
  for (std::size_t n = 1; n + 2 < theta.size(); ++n)
    for (int k = 0; k <= 100; ++k) largest = std::max(largest, std::abs(a(n, k / 100.0).*part - b(n, k / 100.0).*part));
  return largest;
}

report::Table ends_table() {
  const std::size_t n = 1;
  report::Table table{.title = "phi(t) between theta_n = 0.2 and theta_n+1 = 1.0, neighbours -0.3 and 0.7",
                      .columns = {{"quantity"},
                                  {"stated"},
                                  {"its value", Notation::fixed, 6},
                                  {"phi", Notation::fixed, 6},
                                  {"squad", Notation::fixed, 6}}};
  const Angle phi0 = angular_cubic(n, 0.0), phi1 = angular_cubic(n, 1.0), squad0 = squad_angle(n, 0.0),
              squad1 = squad_angle(n, 1.0);
  const double before = theta[n - 1], start = theta[n], end = theta[n + 1], after = theta[n + 2];
  table.rows = {{"phi(0)", "theta_n", start, phi0.value, squad0.value},
                {"phi(1)", "theta_n+1", end, phi1.value, squad1.value},
                {"phi'(0)", "(theta_n+1 - theta_n-1)/2", 0.5 * (end - before), phi0.rate, squad0.rate},
                {"phi'(1)", "(theta_n+2 - theta_n)/2", 0.5 * (after - start), phi1.rate, squad1.rate},
                {"phi''(0)", "not in the note", "", phi0.acceleration, squad0.acceleration},
                {"phi''(1)", "not in the note", "", phi1.acceleration, squad1.acceleration}};
  return table;
}

report::Table agreement_table() {
  report::Table table{.title = "Largest differences on three segments, 101 times each",
                      .columns = {{"between"},
                                  {"angle", Notation::scientific, 1},
                                  {"first derivative", Notation::scientific, 1},
                                  {"second derivative", Notation::scientific, 1}}};
  const auto row = [&](const char* name, Angle (*a)(std::size_t, double), Angle (*b)(std::size_t, double)) {
    table.rows.push_back({name, largest_difference(a, b, &Angle::value), largest_difference(a, b, &Angle::rate),
                          largest_difference(a, b, &Angle::acceleration)});
  };
  row("squad and phi", squad_angle, angular_cubic);
  row("phi and the Catmull-Rom cubic", angular_cubic, catmull_rom);
  const double jump = angular_cubic(2, 0.0).acceleration - angular_cubic(1, 1.0).acceleration;
  table.notes = {"phi is the Catmull-Rom cubic. It is C1 only: its second derivative jumps at theta = 1.0 by " +
                     std::to_string(jump) + ".",
                 "The note gives no angles; these are ours: -0.3, 0.2, 1.0, 0.7, -0.1, 0.4."};
  return table;
}

report::Series series(double Angle::*part, std::string_view stroke) {
  report::Series result{.label = {}, .x = {}, .y = {}, .stroke = {stroke, 2.0}};
  for (std::size_t n = 1; n + 2 < theta.size(); ++n) {
    for (int k = 0; k <= 100; ++k) {
      result.x.push_back(static_cast<double>(n) + k / 100.0);
      result.y.push_back(angular_cubic(n, k / 100.0).*part);
    }
    result.x.push_back(result.x.back());
    result.y.push_back(std::nan(""));
  }
  return result;
}

Picture picture_of_the_angle() {
  Picture picture("002-example", 860, 520);
  const std::vector<report::Mark> marks{{1, "θ = 0.2"}, {2, "1.0"}, {3, "0.7"}, {4, "-0.1"}};
  double top = 34.0;
  for (const auto& [part, title, stroke] :
       {std::tuple{&Angle::value, "the angle φ [rad]", color::blue},
        std::tuple{&Angle::rate, "φ': continuous, at a key half the way between its neighbours", color::green},
        std::tuple{&Angle::acceleration, "φ'': jumps at the keys", color::red}}) {
    picture.add({50.0, top, 780.0, 110.0},
                report::Chart{.title = title, .series = {series(part, stroke)}, .marks = marks});
    top += 168.0;
  }
  return picture;
}

}  // namespace

Expected<Findings> experiment::angular_cubic() {
  return Findings{{ends_table(), agreement_table()}, {picture_of_the_angle()}};
}

}  // namespace orispline::cli
