// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/row_reader.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/io/clock.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

KeyRow RowReader::key(const KeyColumns& columns) {
  KeyRow key{.time = time(columns)};
  key.is_posed = !is_unposed(columns);
  if (key.is_posed) set_orientation(key, columns);
  const std::size_t of_orientation = not_finite_.count;
  if (columns.position && key.is_posed) key.position = vector(*columns.position);
  const std::size_t of_position = not_finite_.count - of_orientation;
  for (std::size_t k = 0; k < columns.rates.size(); ++k)
    if (columns.rates[k]) key.rates[k] = rate(columns.rates[k]->columns);
  for (std::size_t side = 0; side < columns.inner.size(); ++side)
    if (columns.inner[side]) {
      const Eigen::Vector4d wxyz = free_vector(*columns.inner[side], "four cells of the inner quaternion");
      key.inner[side] = quaternion_wxyz(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    }
  for (const ParameterColumn& column : columns.parameters) key.parameters.push_back(number({column.index}));
  const std::size_t missing = not_finite_.count;
  if (columns.position && missing == columns.orientation.size() && of_orientation == missing)
    key.lacks = KeyRow::Lacks::orientation;
  if (columns.position && missing == columns.position->size() && of_position == missing)
    key.lacks = KeyRow::Lacks::position;
  return key;
}

std::optional<Error> RowReader::not_finite() const {
  if (!not_finite_.first) return std::nullopt;
  const std::string_view cell = table_.cells()[*not_finite_.first];
  return mended_by("drop_invalid",
                   formatted("found {}, wanted a finite number{}", cell.empty() ? "an empty cell" : in_quotes(cell),
                             free_instead_),
                   table_.here(not_finite_.first))
      .value();
}

Decimal RowReader::time(const KeyColumns& columns) {
  if (columns.counts_rows) return {};
  const std::string_view cell = table_.cells()[columns.time];
  if (looks_like_iso_time(cell) && !columns.whole_times) return iso_time(columns);
  auto time = decimal_of(cell);
  if (!time) refuse(columns.time, time.error());
  else if (!*time) note_not_finite(columns.time);
  else if (columns.rest_of_time) **time = **time + rest_of_time(*columns.rest_of_time);
  else if (columns.whole_times && !(*time)->is_whole())
    refuse(columns.time, {ErrorCode::bad_data, formatted("found {}, wanted whole nanoseconds", in_quotes(cell)), {}});
  return time.value_or(std::nullopt).value_or(Decimal());
}

Decimal RowReader::rest_of_time(const RestOfTime& column) {
  const auto rest = decimal_of(table_.cells()[column.index]);
  if (!rest) refuse(column.index, rest.error());
  else if (!*rest) note_not_finite(column.index);
  return column.unit.of(rest.value_or(std::nullopt).value_or(Decimal()));
}

Decimal RowReader::iso_time(const KeyColumns& columns) {
  const auto time = parse_iso_time(table_.cells()[columns.time]);
  if (!time) refuse(columns.time, time.error());
  return time.value_or(Decimal()) - options_.clock.zero;
}

double RowReader::number(const NumberColumn& column) {
  const auto number = number_of(table_.cells()[column.index]);
  const double value = number.value_or(0.0) * column.numerator / column.denominator;
  if (!number) refuse(column.index, number.error());
  else if (!std::isfinite(value)) note_not_finite(column.index);
  return value;
}

template <std::size_t Size>
Eigen::Vector<double, static_cast<int>(Size)> RowReader::vector(const std::array<NumberColumn, Size>& columns) {
  Eigen::Vector<double, static_cast<int>(Size)> numbers;
  std::ranges::transform(columns, numbers.begin(), [this](const NumberColumn& column) { return number(column); });
  return numbers;
}

Eigen::Vector3d RowReader::rate(const VectorColumns& columns) {
  if (options_.free_rates == FreeRates::refused) return vector(columns);
  if (options_.free_rates == FreeRates::allowed) return free_vector(columns, "three cells of the rate");
  const NotFinite before = not_finite_;
  Eigen::Vector3d numbers = vector(columns);
  if (numbers.allFinite()) return numbers;
  not_finite_ = before;
  return free_rate();
}

/// The numbers of what may be free, where there are none; `what` names its cells.
template <std::size_t Size>
Eigen::Vector<double, static_cast<int>(Size)> RowReader::free_vector(const std::array<NumberColumn, Size>& columns,
                                                                     const char* what) {
  const NotFinite before = not_finite_;
  const auto numbers = vector(columns);
  if (numbers.array().isNaN().all()) not_finite_ = before;
  else if (!before.first && numbers.hasNaN()) free_instead_ = formatted(", or none in all {} to leave it free", what);
  return numbers;
}

/// Whether the row is set aside: it has a rate, but no number in any cell of its orientation.
bool RowReader::is_unposed(const KeyColumns& columns) const {
  if (options_.unposed_rows != UnposedRows::set_aside || !columns.rates[0]) return false;
  const auto has_number = [this](const NumberColumn& column) {
    const auto number = number_of(table_.cells()[column.index]);
    return !number || std::isfinite(*number);
  };
  return std::ranges::none_of(columns.orientation, has_number) &&
         std::ranges::all_of(columns.rates[0]->columns, has_number);
}

void RowReader::set_orientation(KeyRow& key, const KeyColumns& columns) {
  OrientationNumbers numbers(static_cast<Eigen::Index>(columns.orientation.size()));
  std::ranges::transform(columns.orientation, numbers.begin(), [this](const auto& column) { return number(column); });
  if (!numbers.allFinite()) return;
  if (columns.form.representation == Representation::matrix && options_.norms == Norms::any) {
    const auto nearest = nearest_rotation(numbers);
    if (!nearest) return refuse(std::nullopt, nearest.error());
    key.orientation = nearest->orientation;
    key.matrix_distance = nearest->distance;
    return;
  }
  const auto orientation = orientation_from(numbers, columns.form);
  if (!orientation) return refuse(std::nullopt, orientation.error());
  key.orientation = *orientation;
  if (columns.form.representation == Representation::euler) key.angles = Eigen::Vector3d(numbers);
}

void RowReader::refuse(std::optional<std::size_t> index, Error error) {
  error.where = table_.here(index);
  if (!refused_) refused_ = std::move(error);
}

void RowReader::note_not_finite(std::size_t index) {
  ++not_finite_.count;
  if (!not_finite_.first) not_finite_.first = index;
}

}}}  // namespace orispline::io
