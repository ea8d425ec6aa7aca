// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/families/registry.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/report/svg.hpp>
#include <orispline/tune/tune.hpp>

namespace orispline::cli {

/// A curve of a comparison before there are keys.
struct Recipe {
  std::string label;
  std::string method;
  std::vector<double> tension{};  ///< of the method's own kind; empty: its defaults
  report::Stroke stroke{};
  std::string ends{};  ///< rule for both; empty: the method's own
};

/// The curve through keys.
struct Served {
  Recipe recipe;
  AnyCurve curve;
};

[[nodiscard]] Expected<AnyCurve> curve_of(const Recipe& recipe, const Keyframes& keys);

/// A curve per recipe. Errors: those of make_curve.
[[nodiscard]] Expected<std::vector<Served>> curves_through(const Keyframes& keys, std::vector<Recipe> recipes);

/// The recipe with the tensions that make an objective least on these keys. Errors: those of tune().
[[nodiscard]] Expected<Recipe> tuned(Recipe recipe, const Keyframes& keys, const TuneOptions& options);

/// `(0.1, 0.6, 0, 0.6, 0.1)`, or `0.35` where all are the same, or `0.1 to 0.6` of more than eight; a dash for none.
[[nodiscard]] std::string text_of(const std::vector<double>& tension);

/// `C2`: the order of continuity in time, measured at the keys.
[[nodiscard]] std::string measured_continuity(const AnyCurve& curve);

/// `G2`: that of the path in shape, whatever its speed; a dash where the curve rests at a key.
[[nodiscard]] std::string measured_shape(const AnyCurve& curve);

/// The curves for a page to look at.
[[nodiscard]] std::vector<pages::NamedCurve> motions_of(const std::vector<Served>& curves, const Keyframes& keys);

}  // namespace orispline::cli
