// SPDX-License-Identifier: Apache-2.0
// He et al. 2022, section 5: "the shape of the curve can be adjusted by local shape parameters". How local are they?
#include "papers/experiment.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/example_data.hpp"
#include "papers/recipe.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;

/// A parameter of one point that is changed.
struct Change {
  const char *parameter, *letter;
  double usual, other;
};
constexpr std::array changes{Change{"beta1", "β₁", 1.0, 2.0}, Change{"beta2", "β₂", 0.0, 4.0}};

Method with(Method method, const Change& change, std::size_t keys, std::size_t point) {
  std::vector<double> values(keys, change.usual);
  values[point] = change.other;
  method.options.parameters[change.parameter] = std::move(values);
  return method;
}

std::string form_of(const Method& method) {
  const auto form = method.options.choices.find("form");
  return form == method.options.choices.end() ? method.name : formatted("{}, {}", method.name, form->second);
}

/// The segments that have a column: those around the point.
struct Columns {
  std::size_t first, last;  ///< keys at which they begin, the last one not among them
};

Columns columns_around(std::size_t point, std::size_t keys) {
  constexpr std::size_t aside = 5;
  return {point > aside ? point - aside : 0, std::min(point + aside, keys - 1)};
}

/// From the key at which a segment begins: `1–2` between the second key and the third.
std::string name_of_segment(std::size_t key) { return formatted("{}–{}", key, key + 1); }

Expected<std::vector<report::Cell>> row_of(const Method& method, const Change& change, const Keyframes& keys,
                                           std::size_t point) {
  const auto base = make_curve(method, keys);
  if (!base) return tl::unexpected(base.error());
  return make_curve(with(method, change, keys.size(), point), keys).map([&](const AnyCurve& curve) {
    std::vector<report::Cell> row{form_of(method), formatted("{} = {:g}", change.letter, change.other)};
    const auto times = keys.times();
    const Columns shown = columns_around(point, keys.size());
    const Domain whole = base->domain();
    double most_of_others = 0.0;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const Domain segment{times[i], times[i + 1]};
      const bool is_there = segment.start >= whole.start && segment.end <= whole.end;
      const double moved = degrees * largest_distance(curve, *base, even_times(segment, 101));
      if (i < shown.first || i >= shown.last) most_of_others = std::max(most_of_others, is_there ? moved : 0.0);
      else if (is_there) row.emplace_back(moved);
      else row.emplace_back("–");
    }
    if (shown.last - shown.first + 1 < keys.size()) row.emplace_back(most_of_others);
    return row;
  });
}

Expected<report::Table> local_table(const Keyframes& keys) {
  const std::size_t point = keys.size() / 2;
  report::Table table{.title = formatted("How far a shape parameter of point {} moves the segment between two points: "
                                         "largest angle [degrees]",
                                         point),
                      .columns = {{"method"}, {"changed"}}};
  const Columns shown = columns_around(point, keys.size());
  for (std::size_t key = shown.first; key < shown.last; ++key)
    table.columns.push_back({name_of_segment(key), Notation::fixed, 4});
  if (shown.last - shown.first + 1 < keys.size()) table.columns.push_back({"all others", Notation::fixed, 4});
  const std::array<Method, 4> methods{"beta", "beta-through", Method{"beta-g2", {.choices = {{"form", "local"}}}},
                                      Method{"beta-g2", {.choices = {{"form", "global"}}}}};
  for (const Method& method : methods)
    for (const Change& change : changes) {
      auto row = row_of(method, change, keys, point);
      if (!row) return tl::unexpected(std::move(row.error()));
      table.rows.push_back(std::move(*row));
    }
  table.notes = {
      "Points count from 0, as in the paper; its curve, `beta`, has no segments at the ends. All other β₁ are "
      "1, all other β₂ 0.",
      "A parameter of `beta` moves the segments whose control points know it, four at most, β₁ and β₂ alike."};
  return table;
}

}  // namespace

Expected<Findings> experiment::beta_local() {
  constexpr std::size_t count = 10;
  return Keyframes::make(key_data(flight_key_rows().first(count))).and_then([](const Keyframes& keys) {
    return beta_local_on({keys, "The paper has no such table; these are the first ten keys of the bundled flight."});
  });
}

Expected<Findings> experiment::beta_local_on(const KeysInstead& keys) {
  return local_table(keys.keys).map([&](report::Table table) {
    table.notes.push_back(keys.note);
    return Findings{{std::move(table)}};
  });
}

}  // namespace orispline::cli
