// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/recipe.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Recipe recipe_for(const Method& method, const Track& track) {
  Method shared = method;
  for (const auto& [name, values] : track.settings) shared.options.parameters.erase(name);
  return {.method = text_of(shared), .signs = track.recipe.signs};
}

Expected<std::optional<Method>> method_of(const Recipe& recipe, std::string_view file) {
  if (recipe.method.empty()) return std::nullopt;
  auto method = method_from_text(recipe.method);
  if (method) return std::optional(std::move(*method));
  const std::string& option = method.error().option;
  return mended_by("recipe",
                   formatted("the file says that its keys are for '{}': {}{}", recipe.method,
                             option.empty() ? "" : formatted("{}: ", option), method.error().message),
                   {.file = std::string(file), .line = recipe.line});
}

std::optional<Warning> recipe_set_aside(const Recipe& recipe, const Method& used, std::string_view file) {
  const auto stated = recipe.method.empty() ? Expected<Method>(used) : method_from_text(recipe.method);
  if (stated && text_of(*stated) == text_of(used)) return std::nullopt;
  const bool is_from_file = recipe.line > 0;
  return Warning{.code = "recipe_set_aside",
                 .message = formatted("{} keys are for {}, and they are used for {}",
                                      is_from_file ? "the file says that its" : "these", recipe.method, text_of(used)),
                 .where = is_from_file ? Where{.file = std::string(file), .line = recipe.line} : Where{}};
}

}}  // namespace orispline
