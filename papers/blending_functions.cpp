// SPDX-License-Identifier: Apache-2.0
// Tan et al. 2018, figure 1.
#include "papers/experiment.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include <orispline/base/formatted.hpp>
#include <orispline/families/quintic.hpp>
#include <orispline/report/chart.hpp>

namespace orispline::cli {

namespace {

using report::Chart;
using report::Notation;
using report::Series;
namespace color = report::color;

constexpr std::array function_colors{color::blue, color::red, color::green, color::purple};
constexpr std::array letters{"C0", "C1", "C2", "C3"}, sum_letters{"S0", "S1", "S2", "S3"};

/// The tensions of the keys at the two ends of a segment.
struct Tensions {
  double start, end;
};
constexpr std::array tensions_of_figure1{Tensions{0.35, 0.35}, Tensions{0.1, 0.5}};

/// C_0 … C_3 and their sums from j on.
struct Blending {
  std::array<double, 4> functions, sums;
};

Blending blending(const Tensions& tensions, double u) {
  const Knots knots({0.0, 1.0});
  const auto cumulative = families::Quintic::Basis{PerKey({tensions.start, tensions.end})}(knots.span(0), u);
  Blending result{.functions = {}, .sums = {1.0, cumulative[0], cumulative[1], cumulative[2]}};
  for (std::size_t j = 0; j < 4; ++j) result.functions[j] = result.sums[j] - (j < 3 ? result.sums[j + 1] : 0.0);
  return result;
}

std::string title_of(const Tensions& tensions) {
  return formatted("alpha_i = {:g}, alpha_i+1 = {:g}", tensions.start, tensions.end);
}

report::Table table(const Tensions& tensions) {
  report::Table table{.title = "The functions C_j and their sums S_j = C_j + ... + C_3, " + title_of(tensions),
                      .columns = {{"u", Notation::fixed, 2}}};
  for (const char* c : letters) table.columns.push_back({c, Notation::fixed, 6});
  table.columns.push_back({"sum", Notation::fixed, 6});
  for (const int j : {1, 2, 3}) table.columns.push_back({formatted("S{}", j), Notation::fixed, 6});
  for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Blending b = blending(tensions, u);
    auto& row = table.rows.emplace_back(std::vector<report::Cell>{u});
    row.insert(row.end(), b.functions.begin(), b.functions.end());
    row.emplace_back(std::accumulate(b.functions.begin(), b.functions.end(), 0.0));
    row.insert(row.end(), b.sums.begin() + 1, b.sums.end());
  }
  return table;
}

Chart chart(const Tensions& tensions, std::array<double, 4> Blending::*which, std::span<const char* const> names,
            const std::string& title) {
  Chart chart{.title = title, .series = {}, .y = report::Range{-0.2, 1.1}};
  for (std::size_t j = 0; j < 4; ++j) {
    Series series{.label = names[j], .x = {}, .y = {}, .stroke = {function_colors[j], 2.0}};
    for (int k = 0; k <= 100; ++k) {
      series.x.push_back(k / 100.0);
      series.y.push_back((blending(tensions, k / 100.0).*which)[j]);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Picture figure1() {
  Picture picture("000-figure1", 860, 570);
  double top = 52.0;
  for (const Tensions& tensions : tensions_of_figure1) {
    const std::string values = formatted("α = {:g}, {:g}", tensions.start, tensions.end);
    double left = 50.0;
    for (const Chart& drawn :
         {chart(tensions, &Blending::functions, letters, "blending functions C_j, " + values),
          chart(tensions, &Blending::sums, sum_letters, "their sums S_j = C_j + … + C_3, " + values)}) {
      report::draw_legend(picture.drawing, {left, top - 36.0}, drawn.series);
      picture.add({left, top, 360.0, 200.0}, drawn);
      left += 425.0;
    }
    top += 280.0;
  }
  return picture;
}

}  // namespace

Expected<Findings> experiment::blending_functions() {
  Findings findings{.tables = {table(tensions_of_figure1[0]), table(tensions_of_figure1[1])}, .pictures = {figure1()}};
  findings.tables.back().notes = {
      "They are as in the paper, (3.2). The sums are the exponents of the quaternion curve, (3.6)."};
  return findings;
}

}  // namespace orispline::cli
