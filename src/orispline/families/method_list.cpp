// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/method_text.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

std::string_view before_colon(std::string_view text) { return text.substr(0, text.find(':')); }

bool is_end_rule(std::string_view word) {
  return std::ranges::any_of(families_info(), [&](const FamilyInfo& family) {
    return std::ranges::find(family.ends, word, name_of) != family.ends.end();
  });
}

/// A number or an end rule, maybe with further settings behind it.
bool is_value(std::string_view piece) {
  constexpr std::string_view begin_numbers = "+-.0123456789";
  const std::string_view word = before_colon(piece);
  return (!word.empty() && begin_numbers.find(word.front()) != begin_numbers.npos) || is_end_rule(word);
}

}  // namespace

Expected<std::vector<std::string>> method_texts_in(std::string_view list,
                                                   std::span<const std::shared_ptr<const OwnFamily>> own) {
  const auto pieces = pieces_of(list, ',');
  auto one = method_from_text(list, own);
  if (one || pieces.size() == 1) return std::vector{std::string(list)};
  const auto value = std::ranges::find_if(pieces, is_value);
  if (value == pieces.end()) return std::vector<std::string>(pieces.begin(), pieces.end());
  const bool has_another = std::any_of(pieces.begin() + 1, pieces.end(), [&](std::string_view piece) {
    return method_from_text(piece, own).has_value();
  });
  if (!has_another && method_from_text(before_colon(list), own)) return tl::unexpected(std::move(one.error()));
  return bad_option("methods", formatted("found '{}' between commas, wanted a method; one whose settings have commas "
                                         "is given by an option of its own",
                                         *value));
}

std::vector<std::string> labels_of(std::span<const Method> methods) {
  std::vector<std::string> labels;
  for (const Method& method : methods)
    labels.push_back(std::ranges::count(methods, method.name, &Method::name) == 1 ? method.name : text_of(method));
  return labels;
}

}}  // namespace orispline
