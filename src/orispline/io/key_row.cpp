// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_row.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline::inline ORISPLINE_ABI::io {
namespace {

/// Reads the cells of one row; remembers the first that is no number and the first that is not finite.
class RowReader {
 public:
  explicit RowReader(const TextTable& table) : table_(table) {}

  [[nodiscard]] KeyRow key(const KeyColumns& columns) {
    KeyRow key{.time = time(columns), .orientation = Eigen::Quaterniond::Identity()};
    set_orientation(key, columns);
    if (columns.position) key.position = vector(*columns.position);
    for (std::size_t k = 0; k < columns.rates.size(); ++k)
      if (columns.rates[k]) key.rates[k] = vector(columns.rates[k]->columns);
    for (const ParameterColumn& column : columns.parameters) key.parameters.push_back(number({column.index}));
    return key;
  }

  /// A cell that is no number, or numbers that are no orientation: an error in any case.
  [[nodiscard]] const std::optional<Error>& refused() const { return refused_; }

  /// A cell that is empty or not finite: an error unless such rows are dropped.
  [[nodiscard]] std::optional<Error> not_finite() const {
    if (!not_finite_) return std::nullopt;
    const std::string_view cell = table_.cells()[*not_finite_];
    return mended_by("drop_invalid",
                     formatted("found {}, wanted a finite number", cell.empty() ? "an empty cell" : in_quotes(cell)),
                     table_.here(not_finite_))
        .value();
  }

 private:
  [[nodiscard]] Decimal time(const KeyColumns& columns) {
    const std::string_view cell = table_.cells()[columns.time];
    const auto time = decimal_of(cell);
    if (!time) refuse(columns.time, time.error());
    else if (!*time) note_not_finite(columns.time);
    else if (columns.whole_times && !(*time)->is_whole())
      refuse(columns.time, {ErrorCode::bad_data, formatted("found {}, wanted whole nanoseconds", in_quotes(cell)), {}});
    return time.value_or(std::nullopt).value_or(Decimal());
  }
  [[nodiscard]] double number(const NumberColumn& column) {
    const auto number = number_of(table_.cells()[column.index]);
    const double value = number.value_or(0.0) * column.numerator / column.denominator;
    if (!number) refuse(column.index, number.error());
    else if (!std::isfinite(value)) note_not_finite(column.index);
    return value;
  }
  [[nodiscard]] Eigen::Vector3d vector(const VectorColumns& columns) {
    const double x = number(columns[0]), y = number(columns[1]), z = number(columns[2]);
    return {x, y, z};
  }
  void set_orientation(KeyRow& key, const KeyColumns& columns) {
    OrientationNumbers numbers(static_cast<Eigen::Index>(columns.orientation.size()));
    std::ranges::transform(columns.orientation, numbers.begin(), [this](const auto& column) { return number(column); });
    if (!numbers.allFinite()) return;
    const auto orientation = orientation_from(numbers, columns.form);
    if (!orientation) return refuse(std::nullopt, orientation.error());
    key.orientation = *orientation;
    if (columns.form.representation == Representation::euler) key.angles = Eigen::Vector3d(numbers);
  }
  void refuse(std::optional<std::size_t> index, Error error) {
    error.where = table_.here(index);
    if (!refused_) refused_ = std::move(error);
  }
  void note_not_finite(std::size_t index) {
    if (!not_finite_) not_finite_ = index;
  }

  const TextTable& table_;
  std::optional<Error> refused_;
  std::optional<std::size_t> not_finite_;
};

Expected<void> check_width(const TextTable& table, std::size_t width) {
  const auto cells = table.cells();
  const auto is_empty = [](std::string_view cell) { return cell.empty(); };
  if (cells.size() >= width && std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(width), cells.end(), is_empty))
    return {};
  return failure(ErrorCode::bad_data,
                 formatted("found {} cell{}, wanted {}", cells.size(), cells.size() == 1 ? "" : "s", width),
                 table.here());
}

}  // namespace

Expected<KeyRow> key_row(const TextTable& table, const KeyColumns& columns) {
  if (auto checked = check_width(table, columns.width); !checked) return tl::unexpected(std::move(checked.error()));
  RowReader row(table);
  KeyRow key = row.key(columns);
  if (row.refused()) return tl::unexpected(*row.refused());
  if (auto error = row.not_finite()) return tl::unexpected(std::move(*error));
  return key;
}

}  // namespace orispline::inline ORISPLINE_ABI::io
