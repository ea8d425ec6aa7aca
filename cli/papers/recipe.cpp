// SPDX-License-Identifier: Apache-2.0
#include "papers/recipe.hpp"

#include <algorithm>

#include <orispline/analysis/continuity.hpp>
#include <orispline/base/formatted.hpp>

namespace orispline::cli {

Expected<AnyCurve> curve_of(const Recipe& recipe, const Keyframes& keys) {
  CurveOptions options;
  if (!recipe.tension.empty()) options.parameters["tension"] = recipe.tension;
  return make_curve({recipe.method, options}, keys);
}

Expected<std::vector<Served>> curves_through(const Keyframes& keys, std::vector<Recipe> recipes) {
  std::vector<Served> served;
  for (Recipe& recipe : recipes) {
    auto curve = curve_of(recipe, keys);
    if (!curve) return tl::unexpected(std::move(curve.error()));
    served.push_back({std::move(recipe), std::move(*curve)});
  }
  return served;
}

std::string text_of(const std::vector<double>& tension) {
  if (tension.empty()) return "–";
  const bool same = std::ranges::all_of(tension, [&](double value) { return value == tension.front(); });
  if (same) return formatted("{:.4g}", tension.front());
  return formatted("({})", joined(tension, ", ", "{:.4g}"));
}

std::string measured_continuity(const AnyCurve& curve) { return formatted("C{}", continuity_at_keys(curve).order()); }

}  // namespace orispline::cli
