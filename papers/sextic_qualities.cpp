// SPDX-License-Identifier: Apache-2.0
#include "papers/sextic_qualities.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/example_data.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;

const std::vector<double> uneven_knots{0.0, 0.5, 1.5, 2.25, 4.0};  // of figure 7
constexpr auto keys_note = "The paper's keys are not published; these are the five of examples/data/five_keys.csv, at";

/// Of |ω| over the time: its standard deviation by its mean, and its largest jump at a key [rad/s].
struct Evenness {
  double mean = 0.0, deviation = 0.0, jump = 0.0;
};

Evenness evenness_of(const AnyCurve& curve) {
  constexpr std::size_t steps = 1000;  // a segment
  double time = 0.0, sum = 0.0, squares = 0.0;
  Evenness even;
  const auto knots = curve.knots().times();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double step = (knots[i + 1] - knots[i]) / steps;
    for (std::size_t k = 0; k < steps; ++k) {
      const double rate = speed(curve.motion(knots[i] + (static_cast<double>(k) + 0.5) * step));
      time += step, sum += step * rate, squares += step * rate * rate;
    }
    if (i > 0)
      even.jump =
          std::max(even.jump, std::abs(speed(curve.motion(knots[i], Side::left)) - speed(curve.motion(knots[i]))));
  }
  even.mean = sum / time;
  even.deviation = std::sqrt(squares / time - even.mean * even.mean) / even.mean;
  return even;
}

/// "The teacup rotational motion has relatively uniform speed and angular speed"; "the method also performs very well
/// under highly discontinuous orientations (e.g., sudden rotations)".
Expected<report::Table> evenness_table() {
  report::Table table{.title =
                          "Claims: relatively uniform speed on the knots 0, 0.5, 1.5, 2.25, 4 s, and very well "
                          "under sudden rotations",
                      .columns = {{"curve"},
                                  {"method"},
                                  {"mean |ω| [rad/s]", Notation::fixed, 3},
                                  {"deviation/mean", Notation::fixed, 3},
                                  {"largest jump of |ω| [rad/s]", Notation::fixed, 3}}};
  return five_keys_at(uneven_knots)
      .and_then([](const Keyframes& keys) {
        return curves_through(keys, {{"the chords alone", "slerp"},
                                     {"6th degree, β = 0.025", "sextic", {0.025}},
                                     {"6th degree, β = 1/12", "sextic", {1.0 / 12.0}},
                                     {"timed-c3", "timed-c3"}});
      })
      .map([&](const std::vector<Served>& curves) {
        for (const auto& [recipe, curve] : curves) {
          const Evenness even = evenness_of(curve);
          table.rows.push_back({recipe.label, recipe.method, even.mean, even.deviation, even.jump});
        }
        table.notes = {
            "The deviation is the standard deviation of |ω| over the time. The chords alone have a steadier "
            "speed than the paper's curves.",
            formatted("{} the paper's times.", keys_note)};
        return std::move(table);
      });
}

/// "The peaks and troughs of velocity, angle, and angular velocity curves align most closely with real curve where β =
/// 0.025."
Expected<report::Table> peaks_table(const Flight& flight) {
  report::Table table{.title = formatted("Claim: peaks and troughs fit best at β = 0.025, {}", flight.name),
                      .columns = {{"curve"},
                                  {"method"},
                                  {"RMS of |ω| [rad/s]", Notation::fixed, 3},
                                  {"RMS of ω [rad/s]", Notation::fixed, 3},
                                  {"RMS of the angle from the start [degrees]", Notation::fixed, 2}}};
  return curves_through(flight.keys, {{"Xing, quartic", "xing-quartic"},
                                      {"Tan, α = 0.6", "quintic", {0.6}},
                                      {"Tan, α = 0.45", "quintic", {0.45}},
                                      {"6th degree, β = 1/12", "sextic", {1.0 / 12.0}},
                                      {"6th degree, β = 0.05", "sextic", {0.05}},
                                      {"6th degree, β = 0.025", "sextic", {0.025}}})
      .map([&](const std::vector<Served>& curves) {
        const auto count = static_cast<double>(flight.times.size());
        const Eigen::Quaterniond& start = flight.orientations.front();
        for (const auto& [recipe, curve] : curves) {
          double of_speed = 0.0, of_rate = 0.0, of_angle = 0.0;
          for (std::size_t k = 0; k < flight.times.size(); ++k) {
            const Motion here = curve.motion(flight.times[k]);
            const Motion& truth = flight.truth[k];
            const double angle = angular_distance(start, here.orientation) - angular_distance(start, truth.orientation);
            of_speed += std::pow(speed(here) - speed(truth), 2);
            of_rate += (here.angular_velocity - truth.angular_velocity).squaredNorm();
            of_angle += angle * angle;
          }
          table.rows.push_back({recipe.label, recipe.method, std::sqrt(of_speed / count), std::sqrt(of_rate / count),
                                degrees * std::sqrt(of_angle / count)});
        }
        table.notes = {
            "RMS of the difference to the true flight. Troughs that the flight does not have are at every key "
            "where β is small."};
        return std::move(table);
      });
}

/// "Changing one parameter will affect the spline curves of the two adjacent sections."
Expected<report::Table> reach_table() {
  report::Table table{.title = "Claim: one β changes the two segments beside its key; largest angle [degrees]",
                      .columns = {{"β of key 3"}}};
  for (int segment = 1; segment <= 4; ++segment)
    table.columns.push_back({formatted("segment {}", segment), Notation::fixed, 4});
  const std::vector<double> even{0.0, 1.0, 2.0, 3.0, 4.0};
  const auto with = [](double third) {
    const double other = 1.0 / 12.0;
    return Recipe{formatted("{:g}", third), "sextic", {other, other, third, other, other}};
  };
  return five_keys_at(even)
      .and_then([&](const Keyframes& keys) {
        return curves_through(keys, {with(1.0 / 12.0), with(0.025), with(0.0), with(0.2), with(-0.1)});
      })
      .map([&](const std::vector<Served>& curves) {
        for (const auto& [recipe, curve] : curves) {
          auto& row = table.rows.emplace_back(std::vector<report::Cell>{recipe.label});
          for (std::size_t i = 0; i < 4; ++i)
            row.emplace_back(degrees *
                             largest_distance(curve, curves.front().curve, even_times({even[i], even[i + 1]}, 101)));
        }
        table.notes = {"All others are 1/12.", formatted("{} t = 0, 1, 2, 3, 4 s.", keys_note)};
        return std::move(table);
      });
}

}  // namespace

Expected<std::vector<report::Table>> sextic_qualities(const Flight& flight) {
  std::vector<report::Table> tables;
  for (auto made : {evenness_table(), peaks_table(flight), reach_table()}) {
    if (!made) return tl::unexpected(std::move(made.error()));
    tables.push_back(std::move(*made));
  }
  return tables;
}

}  // namespace orispline::cli
