// SPDX-License-Identifier: Apache-2.0
#include "papers/recipe.hpp"

#include <algorithm>

#include <orispline/analysis/continuity.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>

namespace orispline::cli {

namespace {

Expected<Method> method_of(const Recipe& recipe) {
  Method method(recipe.method);
  if (!recipe.tension.empty()) method.options.parameters["tension"] = recipe.tension;
  if (recipe.ends.empty()) return method;
  return with_ends(std::move(method), recipe.ends);
}

}  // namespace

Expected<AnyCurve> curve_of(const Recipe& recipe, const Keyframes& keys) {
  return method_of(recipe).and_then([&](const Method& method) { return make_curve(method, keys); });
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

Expected<Recipe> tuned(Recipe recipe, const Keyframes& keys, const TuneOptions& options) {
  return method_of(recipe)
      .and_then([&](const Method& method) { return tune(keys, method, options); })
      .map([&](const Tuning& tuning) {
        recipe.tension = tuning.method.options.parameters.at("tension");
        return std::move(recipe);
      });
}

std::string text_of(const std::vector<double>& tension) {
  if (tension.empty()) return "–";
  const bool same = std::ranges::all_of(tension, [&](double value) { return value == tension.front(); });
  if (same) return formatted("{:.4g}", tension.front());
  const auto [least, most] = std::ranges::minmax(tension);
  if (tension.size() > 8) return formatted("{:.4g} to {:.4g}", least, most);
  return formatted("({})", joined(tension, ", ", "{:.4g}"));
}

std::string measured_continuity(const AnyCurve& curve) { return formatted("C{}", continuity_at_keys(curve).order()); }

std::string measured_shape(const AnyCurve& curve) {
  const auto order = shape_continuity_at_keys(curve).order();
  return order ? formatted("G{}", *order) : "–";
}

std::vector<pages::NamedCurve> motions_of(const std::vector<Served>& curves, const Keyframes& keys) {
  std::vector<pages::NamedCurve> motions;
  motions.reserve(curves.size());
  for (const auto& [recipe, curve] : curves) motions.push_back({recipe.label, keys, {curve}});
  return motions;
}

}  // namespace orispline::cli
