// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/construction.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/families/beta.hpp>
#include <orispline/families/beta_g2.hpp>
#include <orispline/families/beta_through.hpp>
#include <orispline/families/global_c2.hpp>
#include <orispline/families/nu.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// A family that is constructed.
struct Constructed {
  std::string_view name;
  MakeConstruction* make;
  std::size_t ends;  ///< so many keys at either end have no influence
  /// ν = 0 is the cubic spline, and no curve through the keys has a smaller ∫|x''|² (Holladay 1957).
  std::optional<double> closed_form{};
};

constexpr std::array constructed{Constructed{families::Nu::info.name, nu_construction, 1, 0.0},
                                 Constructed{families::NuExact::info.name, nu_exact_construction, 1, 0.0},
                                 Constructed{families::Beta::info.name, beta_construction, 0},
                                 Constructed{families::BetaThrough::info.name, beta_through_construction, 0},
                                 Constructed{families::BetaG2::info.name, beta_g2_construction, 0}};

Expected<void> check_count(const FamilyInfo& family, const FamilySettings& settings, std::size_t keys) {
  for (const Parameter& parameter : family.parameters)
    if (settings.per_key(parameter.name).values().size() > keys)
      return failure(ErrorCode::bad_argument,
                     formatted("{}: found values of {} for ghost keys, wanted one or one per key to tune", family.name,
                               parameter.name));
  return {};
}

}  // namespace

bool is_constructed(std::string_view method) {
  return std::ranges::find(constructed, method, &Constructed::name) != constructed.end();
}

std::vector<std::vector<std::size_t>> variables_in_reach(const std::vector<Variable>& variables, std::size_t segments) {
  std::vector<std::vector<std::size_t>> near(segments);
  for (std::size_t v = 0; v < variables.size(); ++v) {
    const std::size_t key = variables[v].key;
    const std::size_t first = key > construction_reach ? key - construction_reach : 0;
    for (std::size_t i = first; i < std::min(segments, key + construction_reach); ++i) near[i].push_back(v);
  }
  return near;
}

Expected<ConstructionModel> construction_model(const FamilyInfo& family, const Keyframes& keys,
                                               const CurveOptions& options,
                                               const std::vector<std::string>& parameters) {
  const auto settings = make_curve({family, options}, keys).and_then([&](const AnyCurve&) {
    return settle(family, options, keys.size());
  });
  if (!settings) return tl::unexpected(settings.error());
  if (auto checked = check_count(family, *settings, keys.size()); !checked)
    return tl::unexpected(std::move(checked.error()));
  const Constructed& kind = *std::ranges::find(constructed, family.name, &Constructed::name);
  ConstructionModel found{.model = {.variables = {}, .segments = {}, .options = options},
                          .construction = nullptr,
                          .closed_form = kind.closed_form};
  auto& values = found.model.options.parameters;
  for (const std::string& name : parameters) values[name] = settings->per_key(name).all(keys.size());
  for (std::size_t key = kind.ends; key + kind.ends < keys.size(); ++key)
    for (const Parameter& parameter : family.parameters)
      if (std::ranges::find(parameters, parameter.name) != parameters.end())
        found.model.variables.push_back({std::string(parameter.name), key, values.find(parameter.name)->second[key],
                                         parameter.lowest, parameter.highest});
  found.construction = kind.make(keys, *settings, found.model.variables);
  return found;
}

}}  // namespace orispline
