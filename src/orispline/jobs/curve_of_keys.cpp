// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/curve_of_keys.hpp>

#include <utility>
#include <vector>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/measured.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// What is wrong with a method that nobody but the file of the keys names is the fault of that line.
Error blamed_on_recipe(const Method& method, const Track& keys, Error error) {
  const auto stated = method_of(keys.recipe, keys.name);
  if (error.code != ErrorCode::bad_argument || !stated || !*stated || text_of(**stated) != text_of(method))
    return error;
  error.code = ErrorCode::bad_data;
  error.where = {.file = keys.name, .line = keys.recipe.line};
  error.option.clear();
  error.remedy = "recipe";
  return error;
}

std::optional<KeyFindings> findings_by(const Method& method, const Track& keys) {
  if (method.name != families::Measured::info.name || keys.keys.size() < 2) return std::nullopt;
  return key_findings(completed(method, families::Measured::info, keys), keys.keys).value_or(std::nullopt);
}

/// The path of the same kind through positions at times of their own.
Expected<std::optional<AnyPath>> path_apart(const Method& method, const Track& track) {
  const PositionTrack& apart = track.positions_apart;
  if (apart.is_empty()) return std::nullopt;
  return Keyframes::make({.times = apart.times,
                          .orientations = std::vector(apart.times.size(), Eigen::Quaterniond::Identity()),
                          .positions = apart.positions})
      .and_then([&](const Keyframes& keys) { return curve_beside_gaps(method, keys, track.recipe.gap); })
      .map([](const PoseCurve& curve) { return curve.position; });
}

}  // namespace

Expected<PoseCurve> curve_through(const Method& method, const Track& keys) {
  return curve_beside_gaps(method, keys.keys, keys.recipe.gap).and_then([&](PoseCurve curve) {
    return path_apart(method, keys).map([&](std::optional<AnyPath> path) {
      if (path) curve.position = std::move(path);
      return curve;
    });
  });
}

Expected<PoseCurve> shaped_curve(const Method& method, const Track& keys) {
  // The user answers for his words first; what fails after that is the fault of the file's columns.
  const FamilyInfo& family = family_of(method);
  const auto settled = settle(family, method.options, keys.keys.size());
  if (!settled) return tl::unexpected(blamed_on_recipe(method, keys, placed(keys, settled.error())));
  const Method shaped = completed(method, family, keys);
  const bool has_columns = shaped.options.parameters.size() > method.options.parameters.size();
  return curve_through(shaped, keys).map_error([&](Error error) {
    if (has_columns && error.option != "gap" && error.option != "jumps") error.code = ErrorCode::bad_data;
    return blamed_on_recipe(method, keys, placed(keys, std::move(error)));
  });
}

Expected<void> check_without_gaps(const Track& keys) {
  const std::optional<double>& gap = keys.recipe.gap;
  if (!are_in_stretches(keys.keys, gap)) return {};
  const bool is_stated = keys.recipe.line > 0;
  const std::string found = gap ? formatted("gaps longer than {} s", *gap) : "two orientations at one time",
                    reason = is_stated ? formatted(", as line {} of the keys says", keys.recipe.line) : "";
  return tl::unexpected(Error{.code = ErrorCode::bad_argument,
                              .message = formatted("found {}{}, wanted one curve through all keys", found, reason),
                              .option = gap ? "gap" : "jumps",
                              .remedy = is_stated && gap ? "recipe" : ""});
}

Expected<CurveOfKeys> curve_of_keys(const Method& method, const Track& keys) {
  auto findings = findings_by(method, keys);
  Method found = findings ? with_findings(method, *findings) : method;
  // Positions say something of their own.
  return shaped_curve(keys.keys.positions().empty() ? found : method, keys).map([&](PoseCurve curve) {
    auto warnings = warnings_of(found, keys, &curve.orientation);
    return CurveOfKeys{std::move(curve), std::move(found), findings, std::move(warnings)};
  });
}

}}}  // namespace orispline::jobs
