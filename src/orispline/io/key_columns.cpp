// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_columns.hpp>

#include <algorithm>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <orispline/io/quoted.hpp>

namespace orispline::io {
namespace {

/// Suffix of column names: value · numerator / denominator is in the unit of this library.
struct Unit {
  std::string_view suffix;
  double numerator = 1.0, denominator = 1.0;
};

/// Suffix of time columns: value · 10^exponent is in seconds.
struct TimeUnit {
  std::string_view suffix;
  int exponent = 0;
};

constexpr std::array<std::string_view, 3> time_names{"t", "time", "timestamp"};
constexpr std::array<std::string_view, 5> required_names{"t", "qw", "qx", "qy", "qz"};
constexpr std::array<std::string_view, 3> position_names{"px", "py", "pz"};
constexpr std::array<std::string_view, 3> rate_names{"wx", "wy", "wz"};

constexpr std::array time_units{TimeUnit{""}, TimeUnit{"_s"}, TimeUnit{"_ms", -3}, TimeUnit{"_us", -6},
                                TimeUnit{"_ns", -9}};
constexpr std::array lengths{Unit{""}, Unit{"_m"}, Unit{"_mm", 1.0, 1000.0}, Unit{"_cm", 1.0, 100.0},
                             Unit{"_km", 1000.0, 1.0}};
constexpr std::array rates{Unit{"_body"}, Unit{"_body_rad_s"}, Unit{"_body_deg_s", std::numbers::pi, 180.0},
                           Unit{""},      Unit{"_rad_s"},      Unit{"_deg_s", std::numbers::pi, 180.0}};
constexpr std::span<const Unit> body_rates = std::span(rates).first(3);

constexpr std::size_t longest_list = 200;  // [bytes] of column names in a message

/// The unit with the longest suffix that a name ends in.
template <class U>
U unit_of(std::string_view name, std::span<const U> units) {
  U best{""};
  for (const U& unit : units)
    if (name.ends_with(unit.suffix) && unit.suffix.size() > best.suffix.size()) best = unit;
  return best;
}

/// Whether a name is the base followed by the suffix of one of the units.
template <class U>
bool is_with_unit(std::string_view name, std::string_view base, std::span<const U> units) {
  return name.starts_with(base) && std::any_of(units.begin(), units.end(),
                                               [&](const U& unit) { return name.substr(base.size()) == unit.suffix; });
}

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Looks for columns in the header of a table.
class Search {
 public:
  Search(std::span<const std::string_view> header, const HeaderReading& reading) : header_(header), reading_(reading) {}

  /// An error when a mapping is for a name that no column can have.
  [[nodiscard]] Expected<void> check_mappings() const {
    for (const auto& [canonical, name] : reading_.names) {
      const bool known =
          contains(required_names, canonical) || contains(position_names, canonical) ||
          contains(rate_names, canonical) ||
          std::find(reading_.parameters.begin(), reading_.parameters.end(), canonical) != reading_.parameters.end();
      if (known) continue;
      std::vector<std::string_view> wanted(required_names.begin(), required_names.end());
      wanted.insert(wanted.end(), position_names.begin(), position_names.end());
      wanted.insert(wanted.end(), rate_names.begin(), rate_names.end());
      wanted.insert(wanted.end(), reading_.parameters.begin(), reading_.parameters.end());
      return failure(ErrorCode::bad_argument, fmt::format("--columns {}={}: no such column is read, wanted one of {}",
                                                          canonical, name, fmt::join(wanted, ", ")));
    }
    return {};
  }

  /// The column of a canonical name: the one that was mapped, else the only one whose name is accepted.
  template <class Accepts>
  [[nodiscard]] Expected<std::optional<std::size_t>> column(std::string_view canonical, Accepts accepts) const {
    const auto mapping = reading_.names.find(canonical);
    if (mapping == reading_.names.end()) return only_column(canonical, accepts);
    const std::string& name = mapping->second;
    auto found = only_column(canonical, [&name](std::string_view column) { return column == name; });
    if (found && !*found)
      return bad_header(fmt::format("no column {} for {}, found {}", quoted(name), canonical, found_names()));
    return found;
  }

  /// The three columns of a vector; nothing if there is none of them.
  [[nodiscard]] Expected<std::optional<std::array<NumberColumn, 3>>> vector(
      const std::array<std::string_view, 3>& names, std::span<const Unit> accepted, std::span<const Unit> known) const {
    std::array<NumberColumn, 3> columns;
    std::vector<std::string_view> present, absent;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto index =
          column(names[i], [&](std::string_view name) { return is_with_unit(name, names[i], accepted); });
      if (!index) return tl::unexpected(index.error());
      (*index ? present : absent).push_back(names[i]);
      if (!*index) continue;
      const Unit unit = unit_of(header_[**index], known);
      columns[i] = {**index, unit.numerator, unit.denominator};
    }
    if (present.empty()) return std::nullopt;
    if (absent.empty()) return columns;
    return bad_header(fmt::format("found {} without {}, wanted all three columns or none", fmt::join(present, ", "),
                                  fmt::join(absent, ", ")));
  }

  [[nodiscard]] std::string found_names() const {
    return quoted(fmt::format("{}", fmt::join(header_, ",")), longest_list);
  }
  [[nodiscard]] static tl::unexpected<Error> bad_header(std::string message) {
    return failure(ErrorCode::bad_data, std::move(message));
  }

 private:
  template <class Accepts>
  [[nodiscard]] Expected<std::optional<std::size_t>> only_column(std::string_view canonical, Accepts accepts) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (!accepts(header_[i])) continue;
      if (found && header_[*found] == header_[i])
        return bad_header(fmt::format("the column {} is there twice, wanted it once", quoted(header_[i])));
      if (found)
        return bad_header(fmt::format("{} and {} may both be {}, choose one with --columns {}=NAME",
                                      quoted(header_[*found]), quoted(header_[i]), canonical, canonical));
      found = i;
    }
    return found;
  }

  std::span<const std::string_view> header_;
  const HeaderReading& reading_;
};

/// Indices of t, qw, qx, qy, qz.
Expected<std::array<std::size_t, 5>> required_columns(const Search& search) {
  std::array<std::size_t, 5> indices{};
  std::vector<std::string_view> missing;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto index = search.column(required_names[i], [i](std::string_view name) {
      return i == 0 ? time_unit_of(name).has_value() : name == required_names[i];
    });
    if (!index) return tl::unexpected(index.error());
    if (*index) indices[i] = **index;
    else missing.push_back(required_names[i]);
  }
  if (missing.empty()) return indices;
  return Search::bad_header(fmt::format("no column {}, found {}; other names are given by --columns {}=NAME,...",
                                        fmt::join(missing, ", "), search.found_names(), missing[0]));
}

Expected<std::vector<ParameterColumn>> parameter_columns(const Search& search, std::span<const std::string> names) {
  std::vector<ParameterColumn> columns;
  for (const std::string& name : names) {
    const auto index = search.column(name, [&name](std::string_view column) { return column == name; });
    if (!index) return tl::unexpected(index.error());
    if (*index) columns.push_back({name, **index});
  }
  return columns;
}

bool begins_like_number(std::string_view cell) {
  return std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
}

}  // namespace

bool is_header(std::span<const std::string_view> row) {
  const auto first = std::find_if(row.begin(), row.end(), [](std::string_view cell) { return !cell.empty(); });
  return first != row.end() && !begins_like_number(*first) && !number_of(*first);
}

Expected<KeyColumns> columns_of_header(std::span<const std::string_view> header, const HeaderReading& reading) {
  while (!header.empty() && header.back().empty()) header = header.first(header.size() - 1);
  const Search search(header, reading);
  if (auto checked = search.check_mappings(); !checked) return tl::unexpected(std::move(checked.error()));
  const auto required = required_columns(search);
  if (!required) return tl::unexpected(required.error());
  const auto position = search.vector(position_names, lengths, lengths);
  if (!position) return tl::unexpected(position.error());
  const auto read_rates = reading.rate_frame == RateFrame::body ? std::span<const Unit>(rates) : body_rates;
  const auto rate = search.vector(rate_names, read_rates, rates);
  if (!rate) return tl::unexpected(rate.error());
  auto parameters = parameter_columns(search, reading.parameters);
  if (!parameters) return tl::unexpected(std::move(parameters.error()));

  const auto [t, qw, qx, qy, qz] = *required;
  return KeyColumns{.width = header.size(),
                    .time = t,
                    .time_unit = Decimal::power_of_ten(unit_of<TimeUnit>(header[t], time_units).exponent),
                    .quaternion = {qw, qx, qy, qz},
                    .position = *position,
                    .angular_velocity = *rate,
                    .parameters = std::move(*parameters)};
}

Expected<KeyColumns> columns_of_order(std::size_t columns, QuaternionOrder order) {
  if (columns != 5 && columns != 8)
    return Search::bad_header(fmt::format(
        "found {} columns without a header, wanted 5 (t and the quaternion) or 8 (px, py, pz after them)", columns));
  KeyColumns result;
  result.width = columns;
  result.quaternion = {1, 2, 3, 4};
  if (order == QuaternionOrder::xyzw) result.quaternion = {4, 1, 2, 3};
  if (columns == 8) result.position = {NumberColumn{5}, NumberColumn{6}, NumberColumn{7}};
  return result;
}

KeyColumns columns_of_tum() {
  KeyColumns result;
  result.width = 8;
  result.quaternion = {7, 4, 5, 6};
  result.position = {NumberColumn{1}, NumberColumn{2}, NumberColumn{3}};
  return result;
}

std::optional<Decimal> time_unit_of(std::string_view name) {
  for (const std::string_view base : time_names)
    if (is_with_unit<TimeUnit>(name, base, time_units))
      return Decimal::power_of_ten(unit_of<TimeUnit>(name, time_units).exponent);
  return std::nullopt;
}

}  // namespace orispline::io
