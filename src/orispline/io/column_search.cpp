// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/column_search.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::size_t longest_list = 200;  // [bytes] of column names in a message

/// A unit in brackets at the end of a name, as a suffix: `px [mm]`, `wx (rad/s^2)`, `time(µs)`.
std::string plain(std::string_view name) {
  const std::size_t open = name.find_last_of("([");
  const bool ends_in_brackets = name.ends_with(')') || name.ends_with(']');
  if (open == 0 || open == std::string_view::npos || !ends_in_brackets) return std::string(name);
  std::string base(name.substr(0, open));
  while (base.ends_with(' ')) base.pop_back();
  std::string unit(name.substr(open + 1, name.size() - open - 2));
  for (const auto& [sign, word] : {std::pair("µ", "u"), std::pair("μ", "u"), std::pair("°", "deg"), std::pair("²", "2"),
                                   std::pair("³", "3"), std::pair("/", "_"), std::pair("^", ""), std::pair(" ", "")})
    for (std::size_t at = unit.find(sign); at != std::string::npos; at = unit.find(sign))
      unit.replace(at, std::string_view(sign).size(), word);
  return unit.empty() ? base : formatted("{}_{}", base, unit);
}

}  // namespace

ColumnSearch::ColumnSearch(std::span<const std::string_view> header, const ColumnNames& mapped)
    : header_(header), mapped_(mapped) {
  for (const std::string_view name : header) plain_names_.push_back(plain(name));
}

bool ColumnSearch::is_mapped(std::string_view plain_name) const {
  return std::ranges::any_of(mapped_, [&](const auto& mapping) { return plain(mapping.second) == plain_name; });
}

Expected<ColumnGroup> ColumnSearch::group(std::span<const std::string_view> names, std::span<const Unit> accepted,
                                          std::span<const Unit> known) const {
  ColumnGroup group;
  for (const std::string_view canonical : names) {
    const auto index =
        column(canonical, [&](std::string_view name) { return is_with_unit(name, canonical, accepted); });
    if (!index) return tl::unexpected(index.error());
    (*index ? group.present : group.missing).push_back(canonical);
    if (!*index) continue;
    const Unit unit = unit_of(plain_name(**index), known);
    group.columns.push_back({**index, unit.numerator, unit.denominator});
  }
  return group;
}

Expected<ColumnGroup> ColumnSearch::whole_group(std::span<const std::string_view> names, std::span<const Unit> accepted,
                                                std::span<const Unit> known) const {
  auto found = group(names, accepted, known);
  if (!found || found->is_absent() || found->is_complete()) return found;
  return failure(ErrorCode::bad_data,
                 formatted("found {} without {}, wanted all {} columns or none", joined(found->present, ", "),
                           joined(found->missing, ", "), names.size() == 3 ? "three" : "four"));
}

std::string ColumnSearch::found_names() const { return in_quotes(joined(header_, ","), longest_list); }

tl::unexpected<Error> ColumnSearch::not_there(std::string_view canonical, std::string_view name) const {
  return failure(ErrorCode::bad_data,
                 formatted("no column {} for {}, found {}", in_quotes(name), canonical, found_names()));
}

tl::unexpected<Error> ColumnSearch::two_columns(std::string_view canonical, std::size_t one, std::size_t other) const {
  const auto name = [this](std::size_t i) { return in_quotes(header_[i]); };
  if (header_[one] == header_[other])
    return failure(ErrorCode::bad_data, formatted("the column {} is there twice, wanted it once", name(other)));
  return mended_by("columns",
                   formatted("{} and {} could both be {}, wanted one of them", name(one), name(other), canonical));
}

}}}  // namespace orispline::io
