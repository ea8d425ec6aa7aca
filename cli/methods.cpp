// SPDX-License-Identifier: Apache-2.0
#include "methods.hpp"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <orispline/families/registry.hpp>

#include "json.hpp"
#include "standard_output.hpp"

namespace orispline::cli {
namespace {

std::string parameters_of(const FamilyInfo& family) {
  std::vector<std::string> texts;
  for (const Parameter& p : family.parameters) texts.push_back(fmt::format("{} {:.4g}", p.name, p.initial));
  return texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, ", "));
}

std::string ends_of(const FamilyInfo& family) {
  std::vector<std::string_view> names;
  for (const EndRule rule : family.ends) names.push_back(name_of(rule));
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::string table() {
  std::string text =
      "Continuity is in time: on evenly spaced keys, then on any keys. The first end rule is the default.\n";
  for (const FamilyInfo& family : families_info())
    text +=
        fmt::format("\n{:20}{}\n{:20}continuity C{}, C{}; parameters: {}; ends: {}{}\n{:20}source: {}\n", family.name,
                    family.title, "", family.continuity_uniform, family.continuity_uneven, parameters_of(family),
                    ends_of(family), family.closes ? "; can be closed" : "", "", family.source);
  return text;
}

}  // namespace

Expected<void> methods(const MethodsOptions& options) {
  return print_document(options.json ? json_of(families_info()) : table());
}

}  // namespace orispline::cli
