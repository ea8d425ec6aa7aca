// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Suffix of column names: value · numerator / denominator is in the unit of this library.
struct Unit {
  std::string_view suffix;
  double numerator = 1.0, denominator = 1.0;
};

/// A column of numbers: value · numerator / denominator is in the unit of this library.
struct NumberColumn {
  std::size_t index = 0;  ///< 0-based
  double numerator = 1.0, denominator = 1.0;
};

using VectorColumns = std::array<NumberColumn, 3>;      ///< of x, y, z
using QuaternionColumns = std::array<NumberColumn, 4>;  ///< of w, x, y, z

/// The unit with the longest suffix that a name ends in.
template <class U>
[[nodiscard]] U unit_of(std::string_view name, std::span<const U> units) {
  U best{""};
  for (const U& unit : units)
    if (name.ends_with(unit.suffix) && unit.suffix.size() > best.suffix.size()) best = unit;
  return best;
}

/// Whether a name is the base followed by the suffix of one of the units.
template <class U>
[[nodiscard]] bool is_with_unit(std::string_view name, std::string_view base, std::span<const U> units) {
  return name.starts_with(base) && std::any_of(units.begin(), units.end(),
                                               [&](const U& unit) { return name.substr(base.size()) == unit.suffix; });
}

/// Columns that belong together, as far as a header has them.
struct ColumnGroup {
  std::vector<NumberColumn> columns{};  ///< in the order of the names; those that are missing are left out
  std::vector<std::string_view> present{}, missing{};

  [[nodiscard]] bool is_complete() const noexcept { return missing.empty(); }
  [[nodiscard]] bool is_absent() const noexcept { return present.empty(); }
};

/// Looks for columns by their canonical names in the header of a table.
class ColumnSearch {
 public:
  ColumnSearch(std::span<const std::string_view> header, const ColumnNames& mapped);

  [[nodiscard]] std::string_view name(std::size_t column) const noexcept { return header_[column]; }
  /// Whether a column of that plain name was mapped to another meaning.
  [[nodiscard]] bool is_mapped(std::string_view plain_name) const;
  /// The name as it is compared: with a unit in brackets as a suffix, in small letters and without blanks, `Time (us)`
  /// as `time_us`; what others call the parts of a pose by our names, `pose.orientation.x` as `qx`.
  [[nodiscard]] std::string_view plain_name(std::size_t column) const noexcept { return plain_names_[column]; }

  /// The column of a canonical name: the one that was mapped, else the only one whose name is accepted and that was
  /// mapped to nothing else. Errors (bad_data): a mapped name is not there; there are several.
  template <class Accepts>
  [[nodiscard]] Expected<std::optional<std::size_t>> column(std::string_view canonical, Accepts accepts) const {
    const auto mapping = mapped_.find(canonical);
    if (mapping == mapped_.end()) {
      const auto is_one = [&](std::string_view name) { return accepts(name) && !is_mapped(name); };
      const auto as_written = only_column(canonical, written_names_, is_one);
      return !as_written || *as_written ? as_written : only_column(canonical, plain_names_, is_one);
    }
    const std::string& name = mapping->second;
    auto found = only_column(canonical, header_, [&name](std::string_view column) { return column == name; });
    if (!found || *found) return found;
    if (const auto alike = index_of(name)) return alike;
    return not_there(canonical, name);
  }

  /// The column that a caller names, by its very name, else as names are compared.
  [[nodiscard]] std::optional<std::size_t> index_of(std::string_view name) const;
  /// Of a name that a caller states.
  [[nodiscard]] tl::unexpected<Error> not_there(std::string_view canonical, std::string_view name) const;

  /// The unit that a mapping states behind the canonical name: `wx_deg_s` for a column `wx`.
  [[nodiscard]] std::optional<Unit> stated_unit(std::string_view canonical, std::span<const Unit> known) const;

  /// The columns of the canonical names with one of the accepted units; a mapped name may end in any of the known ones,
  /// or be of a name that does.
  [[nodiscard]] Expected<ColumnGroup> group(std::span<const std::string_view> names, std::span<const Unit> accepted,
                                            std::span<const Unit> known) const;

  /// The columns of what has so many components; nothing if there is none of them.
  template <std::size_t Size>
  [[nodiscard]] Expected<std::optional<std::array<NumberColumn, Size>>> all_or_none(
      const std::array<std::string_view, Size>& names, std::span<const Unit> accepted,
      std::span<const Unit> known) const {
    using Columns = std::array<NumberColumn, Size>;
    return whole_group(names, accepted, known).map([](const ColumnGroup& found) {
      if (found.is_absent()) return std::optional<Columns>();
      Columns columns;
      std::ranges::copy(found.columns, columns.begin());
      return std::optional(columns);
    });
  }

  /// The header as a message shows it.
  [[nodiscard]] std::string found_names() const;

 private:
  /// A group that is complete or absent. Error (bad_data): it is neither.
  [[nodiscard]] Expected<ColumnGroup> whole_group(std::span<const std::string_view> names,
                                                  std::span<const Unit> accepted, std::span<const Unit> known) const;
  template <class Accepts>
  [[nodiscard]] Expected<std::optional<std::size_t>> only_column(std::string_view canonical, const auto& names,
                                                                 Accepts accepts) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!accepts(std::string_view(names[i]))) continue;
      if (found) return two_columns(canonical, *found, i);
      found = i;
    }
    return found;
  }
  [[nodiscard]] tl::unexpected<Error> two_columns(std::string_view canonical, std::size_t one, std::size_t other) const;

  std::span<const std::string_view> header_;
  std::vector<std::string> written_names_, plain_names_;  // with the letters of the header, and as they are compared
  const ColumnNames& mapped_;
};

}}}  // namespace orispline::io
