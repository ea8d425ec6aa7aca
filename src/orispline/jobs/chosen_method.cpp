// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/curve_of_keys.hpp>

#include <utility>

#include <orispline/curve/own_family.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// The one that the keys are for, where it fits, else the usual one.
Expected<ChosenMethod> unnamed(const Recipe& recipe, std::string_view file, const UsualMethod& usual) {
  return method_of(recipe, file).map([&](std::optional<Method> stated) -> ChosenMethod {
    if (stated && (!usual.fits || usual.fits(family_of(*stated)))) return {std::move(*stated), NamedBy::keys};
    return {usual.name, NamedBy::nobody};
  });
}

/// Whether both name a method with the same words and rows.
bool name_the_same(const Recipe& one, const Recipe& other) {
  const bool same_rows =
      one.blending && other.blending ? *one.blending == *other.blending : one.blending == other.blending;
  return one.method == other.method && same_rows;
}

}  // namespace

Expected<ChosenMethod> chosen_method(const std::optional<Method>& named, const Recipe& recipe, std::string_view file,
                                     const UsualMethod& usual, const Shaping& shaping) {
  Expected<ChosenMethod> chosen = named ? ChosenMethod{*named, NamedBy::user} : unnamed(recipe, file, usual);
  if (chosen && !named && shaping) {
    auto shaped = shaping(std::move(chosen->method), chosen->by);
    if (!shaped) return tl::unexpected(std::move(shaped.error()));
    chosen->method = std::move(*shaped);
  }
  if (!chosen || chosen->by == NamedBy::keys) return chosen;
  if (auto warning = recipe_set_aside(recipe, chosen->method, file)) chosen->warnings.push_back(std::move(*warning));
  return chosen;
}

Expected<ChosenMethod> chosen_method(const std::optional<Method>& named, const Track& keys, const UsualMethod& usual) {
  return chosen_method(named, keys.recipe, keys.name, usual).map([&](ChosenMethod chosen) {
    if (name_the_same(recipe_for(chosen.method, keys), keys.recipe)) chosen.warnings.clear();  // the keys have the rest
    return chosen;
  });
}

Expected<std::shared_ptr<const FamilyInfo>> family_named(const Recipe& recipe, std::string_view file) {
  using Family = std::shared_ptr<const FamilyInfo>;
  return method_of(recipe, file).and_then([](std::optional<Method> stated) -> Expected<Family> {
    if (!stated) return Family();
    const auto method = std::make_shared<const Method>(std::move(*stated));  // whose rows the family may be made of
    return family_of_method(*method).map([&](const FamilyInfo* family) { return Family(method, family); });
  });
}

const FamilyInfo& family_of(const Method& method) { return **family_of_method(method); }

Error placed(const Track& keys, Error error) {
  const bool concerns_file = error.code != ErrorCode::bad_argument || error.where.key;
  return concerns_file && !keys.name.empty() ? keys.located(std::move(error)) : error;
}

}}}  // namespace orispline::jobs
