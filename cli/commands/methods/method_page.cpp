// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/setting_quantity.hpp>

#include "commands/methods/page_lines.hpp"

namespace orispline::cli {

namespace {

std::string line(std::string_view label, std::string_view words) {
  constexpr std::size_t label_width = 14;
  return wrapped(formatted("  {:{}}", label, label_width), words);
}

/// Where the path is less smooth than stated, or nothing.
std::string corners_of(const FamilyInfo& family) {
  for (const Parameter& p : family.parameters)
    if (p.rests_at_zero)
      return formatted(" Where {} is 0 the body rests at the key, and its path may have a corner there.", p.name);
  return "";
}

std::string continuity_of(const FamilyInfo& family) {
  const int even = family.continuity_uniform, uneven = family.continuity_uneven;
  const std::string in_time = even == uneven
                                  ? formatted("C{} in time, on any key times.", even)
                                  : formatted("C{} in time on evenly spaced keys, C{} on uneven ones.", even, uneven);
  return formatted("{} Its path is G{} on any key times.", in_time, family.shape_order()) + corners_of(family);
}

std::string keys_of(const FamilyInfo& family) {
  std::string text = family.interpolates         ? "The curve passes through every key."
                     : family.key_use.stride > 1 ? "The curve passes through some keys only."
                                                 : "The keys are control points: the curve passes near them.";
  text += family.is_global() ? " Every segment depends on all keys."
                             : formatted(" A segment depends on {} keys.", family.support_keys);
  const auto least = static_cast<std::size_t>(family.min_keys);
  text += formatted(" It needs {} keys at least", least);
  if (const std::size_t stride = family.key_use.stride; stride > 1)
    text += formatted(", and takes {}, {}, {}, ... of them", least, least + stride, least + 2 * stride);
  return text + ".";
}

std::string steadiness_of(const FamilyInfo& family) {
  if (family.keeps_constant_rate_uneven) return "A constant rate stays constant, on any key times.";
  if (family.keeps_constant_rate_uniform) return "A constant rate stays constant on evenly spaced keys only.";
  return "A constant rate does not stay constant.";
}

std::string parameter_text(const Parameter& p) {
  std::string text = formatted("{}={:.6g}, from {:g} to {:g}, ", p.name, p.initial, p.lowest, p.highest);
  text += p.tensor     ? "one, or the diagonal of a symmetric matrix (3), or that and xy, xz, yz (6)"
          : !p.per_key ? "one for all keys"
          : p.ghosts > 0
              ? formatted("one for all keys, or one per key, or those of {} ghost keys at either end as well", p.ghosts)
              : "one for all keys or one per key";
  if (const Quantity* const quantity = quantity_of_setting(p.name))
    text += formatted("; in {} or with its unit, such as {}", quantity->unit, quantity->example);
  if (p.tunable) text += "; 'orispline tune' finds it";
  return text;
}

/// One line for each, the label on the first.
std::string settings_lines(const FamilyInfo& family) {
  std::vector<std::string> settings;
  for (const Parameter& p : family.parameters) settings.push_back(parameter_text(p));
  for (const auto& [name, words] : family.choices)
    settings.push_back(formatted("{}={}, the first by default", name, joined(words, "|")));
  if (settings.empty()) return line("settings", "It has none.");
  std::string text;
  for (const std::string& setting : settings) text += line(text.empty() ? "settings" : "", setting);
  return text;
}

std::string ends_of(const FamilyInfo& family) {
  if (family.ends.empty()) return "It has no end rules.";
  std::vector<std::string_view> names;
  for (const EndRule rule : family.ends) names.push_back(name_of(rule));
  return formatted("{}; the first by default.", joined(names, ", "));
}

std::string rates_of(const FamilyInfo& family) {
  if (family.rate_orders == 0) return "It reads no rates from the file.";
  return formatted("It reads {} where the file has them, and finds the others itself.", rate_columns_of(family));
}

/// What was found of blending functions of one's own, or nothing.
std::string findings_lines(const FamilyInfo& family) {
  std::string text;
  for (const BlendingFinding& found : findings_of(family))
    if (const std::string sentence = sentence_of(found); !sentence.empty())
      text += line(text.empty() ? "found" : "", sentence);
  return text;
}

}  // namespace

std::string page_of(const FamilyInfo& family) {
  std::string text = formatted("{}: {}\n\n", family.name, family.title);
  if (family.own) {
    text += findings_lines(family) + settings_lines(family) + line("ends", ends_of(family));
    return text + line("page", "docs/own-blending.md") +
           line("try", formatted("orispline sample keys.csv --blending FILE --method {} --rate 100 -o motion.csv",
                                 family.name));
  }
  text += line("source", family.source);
  text += line("continuity", continuity_of(family));
  text += line("keys", keys_of(family));
  text += line("constant rate", steadiness_of(family));
  text += settings_lines(family);
  text += line("ends", ends_of(family));
  text += line("loops", family.closes ? "It can be a loop: --closed, or --period T." : "It cannot be a loop.");
  text += line("rates", rates_of(family));
  if (const auto& order = family.order_with_inner_quaternions)
    text +=
        line("inner", formatted("It reads {} where the file has them, and chooses the others itself. They leave it C{} "
                                "and G{}, unless the rates on both sides of a key agree.",
                                inner_columns_of(family), *order, *order));
  if (!family.alias.empty()) text += line("former name", family.alias);
  text += line("page", formatted("docs/families/{}.md", family.name));
  text += line("try", formatted("orispline sample keys.csv --method {} --rate 100 -o motion.csv", family.name));
  return text;
}

}  // namespace orispline::cli
