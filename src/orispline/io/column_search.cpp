// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/column_search.hpp>

#include <algorithm>
#include <array>
#include <utility>

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
  if (!unit.empty() && unit.find_first_not_of("0123456789") == std::string::npos)
    return std::string(name);  // an index, as of q[0]
  for (const auto& [sign, word] : {std::pair("µ", "u"), std::pair("μ", "u"), std::pair("°", "deg"), std::pair("²", "2"),
                                   std::pair("³", "3"), std::pair("/", "_"), std::pair("^", ""), std::pair(" ", "")})
    for (std::size_t at = unit.find(sign); at != std::string::npos; at = unit.find(sign))
      unit.replace(at, std::string_view(sign).size(), word);
  return unit.empty() ? base : formatted("{}_{}", base, unit);
}

/// What others call the parts of a pose: ROS with its messages, PX4 with the scalar of a quaternion first.
struct OtherName {
  std::string_view theirs, ours;
};
constexpr std::array other_names{
    OtherName{"orientation_x", "qx"}, OtherName{"orientation_y", "qy"}, OtherName{"orientation_z", "qz"},
    OtherName{"orientation_w", "qw"}, OtherName{"position_x", "px"},    OtherName{"position_y", "py"},
    OtherName{"position_z", "pz"},    OtherName{"q_x", "qx"},           OtherName{"q_y", "qy"},
    OtherName{"q_z", "qz"},           OtherName{"q_w", "qw"},           OtherName{"q[0]", "qw"},
    OtherName{"q[1]", "qx"},          OtherName{"q[2]", "qy"},          OtherName{"q[3]", "qz"}};
constexpr std::string_view pose_prefix = "pose_";

/// In small letters, without blanks, with `_` between the parts of a name, and by our names where others have theirs.
std::string as_compared(std::string_view written) {
  std::string name;
  for (const char c : written) {
    if (c == ' ' || c == '\t') continue;
    name += 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c == '.' || c == '/' ? '_' : c;
  }
  std::string_view part = name;
  while (part.starts_with('_') || part.starts_with(pose_prefix))
    part.remove_prefix(part.starts_with('_') ? 1 : pose_prefix.size());
  for (const auto& [other, ours] : other_names)
    if (part.starts_with(other) && (part.size() == other.size() || part[other.size()] == '_'))
      return std::string(ours).append(part.substr(other.size()));
  return name;
}

}  // namespace

ColumnSearch::ColumnSearch(std::span<const std::string_view> header, const ColumnNames& mapped)
    : header_(header), mapped_(mapped) {
  for (const std::string_view name : header) {
    written_names_.push_back(plain(name));
    plain_names_.push_back(as_compared(written_names_.back()));
  }
}

std::optional<std::size_t> ColumnSearch::index_of(std::string_view name) const {
  const auto written = std::ranges::find(header_, name);
  if (written != header_.end()) return static_cast<std::size_t>(written - header_.begin());
  const std::string alike = as_compared(plain(name));
  const auto found = std::ranges::find(plain_names_, alike);
  if (found == plain_names_.end() || std::ranges::count(plain_names_, alike) > 1) return std::nullopt;
  return static_cast<std::size_t>(found - plain_names_.begin());
}

bool ColumnSearch::is_mapped(std::string_view plain_name) const {
  return std::ranges::any_of(mapped_, [&](const auto& mapping) {
    const std::string written = plain(mapping.second);
    return written == plain_name || as_compared(written) == as_compared(plain_name);
  });
}

std::optional<Unit> ColumnSearch::stated_unit(std::string_view canonical, std::span<const Unit> known) const {
  for (const Unit& unit : known)
    if (!unit.suffix.empty() && mapped_.contains(std::string(canonical).append(unit.suffix))) return unit;
  return std::nullopt;
}

Expected<ColumnGroup> ColumnSearch::group(std::span<const std::string_view> names, std::span<const Unit> accepted,
                                          std::span<const Unit> known) const {
  ColumnGroup group;
  for (const std::string_view canonical : names) {
    const std::optional<Unit> stated = stated_unit(canonical, known);
    const auto index = column(stated ? std::string(canonical).append(stated->suffix) : std::string(canonical),
                              [&](std::string_view name) { return is_with_unit(name, canonical, accepted); });
    if (!index) return tl::unexpected(index.error());
    (*index ? group.present : group.missing).push_back(canonical);
    if (!*index) continue;
    const Unit unit = stated ? *stated : unit_of(plain_name(**index), known);
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
