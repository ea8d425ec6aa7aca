// SPDX-License-Identifier: Apache-2.0
#include "commands/methods/methods.hpp"

#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/own_family.hpp>
#include <orispline/families/method_json.hpp>
#include <orispline/families/registry.hpp>

#include "commands/methods/page_lines.hpp"
#include "options/method_options.hpp"
#include "options/option_text.hpp"
#include "output/json_document.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

constexpr std::size_t name_width = 20, label_width = 10;  // of the two columns beside the text

constexpr std::string_view introduction =
    "C2 means that angular velocity and acceleration do not jump in time, C1 that the velocity does not.\n"
    "Set a setting with --set NAME=VALUE; a number may be one per key, unless the list says otherwise.\n"
    "Where there are several words or end rules, the first is the default. 'columns' are the rates that\n"
    "a method reads from your file. 'orispline methods NAME' describes one method, and\n"
    "docs/choosing.md says which one to take.\n";

/// A line of its own for what a method has; nothing for what it has not.
std::string labelled(std::string_view label, std::string_view words) {
  if (words.empty()) return "";
  return wrapped(formatted("{:{}}{:{}}", "", name_width, label, label_width), words);
}

std::string promises_of(const FamilyInfo& family) {
  const int even = family.continuity_uniform, uneven = family.continuity_uneven;
  std::string text =
      even == uneven ? formatted("C{} on any keys", even)
                     : formatted("C{} on even keys, C{} and G{} on uneven ones", even, uneven, family.shape_order());
  text += "; a segment depends on ";
  text += family.support_keys == all_keys ? "all keys" : formatted("{} keys", family.support_keys);
  if (family.min_keys > 2) text += formatted("; needs {} keys", family.min_keys);
  if (family.closes) text += "; can be closed";
  return text;
}

std::string settings_of(const FamilyInfo& family) {
  std::vector<std::string> settings;
  for (const Parameter& p : family.parameters)
    settings.push_back(formatted("{}={:.4g}{}", p.name, p.initial, p.per_key ? "" : " (one for all)"));
  for (const auto& [name, words] : family.choices) settings.push_back(formatted("{}={}", name, joined(words, "|")));
  return joined(settings, ", ");
}

std::string ends_text(const FamilyInfo& family) {
  std::vector<std::string_view> names;
  for (const EndRule rule : family.ends) names.push_back(name_of(rule));
  return joined(names, ", ");
}

std::string entry(const FamilyInfo& family) {
  return "\n" + wrapped(formatted("{:{}}", family.name, name_width), family.title) +
         wrapped(std::string(name_width, ' '), promises_of(family)) + labelled("settings", settings_of(family)) +
         labelled("ends", ends_text(family)) +
         labelled("columns", std::string(rate_columns_of(family)) + inner_columns_of(family)) +
         labelled("source", family.source);
}

template <class Belongs>
std::string chapter(std::string_view heading, Belongs belongs) {
  std::string text;
  for (const FamilyInfo& family : families_info())
    if (belongs(family)) text += entry(family);
  return text.empty() ? text : formatted("\n{}\n{}", heading, text);
}

std::string page() {
  const auto is_global = [](const FamilyInfo& family) { return family.support_keys == all_keys; };
  return std::string(introduction) +
         chapter("THROUGH THE KEYS, LOCAL: a segment depends on a few keys",
                 [&](const FamilyInfo& family) { return family.interpolates && !is_global(family); }) +
         chapter("THROUGH THE KEYS, GLOBAL: a segment depends on all keys",
                 [&](const FamilyInfo& family) { return family.interpolates && is_global(family); }) +
         chapter("NEAR THE KEYS: the keys are control points",
                 [](const FamilyInfo& family) { return !family.interpolates; });
}

/// The families of files, or the one among them that is named.
Expected<void> methods_of_files(const MethodsArguments& options) {
  return own_families(options.blending).and_then([&](const auto& own) -> Expected<void> {
    std::vector<FamilyInfo> families;
    for (const auto& family : own)
      if (!options.name || family->info().name == *options.name) families.push_back(family->info());
    if (families.empty())
      return usage_failure(
          formatted("found no method '{}' in the files of --blending, wanted one of theirs", printable(*options.name)));
    if (options.json) return print_document(document(methods_json(families)));
    std::vector<std::string> pages;
    for (const FamilyInfo& family : families) pages.push_back(page_of(family));
    return print_document(joined(pages, "\n"));
  });
}

}  // namespace

Expected<void> methods(const MethodsArguments& options) {
  if (!options.blending.empty()) return methods_of_files(options);
  if (!options.name) return print_document(options.json ? document(methods_json(families_info())) : page());
  return find_family(*options.name).and_then([&](const FamilyInfo* family) {
    return print_document(options.json ? document(methods_json({family, 1})) : page_of(*family));
  });
}

}  // namespace orispline::cli
