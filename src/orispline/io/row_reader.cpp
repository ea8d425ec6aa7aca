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
  set_orientation(key, columns);
  const std::size_t of_orientation = missing_;
  if (columns.position) key.position = vector(*columns.position);
  const std::size_t of_position = missing_ - of_orientation;
  for (std::size_t k = 0; k < columns.rates.size(); ++k)
    if (columns.rates[k]) key.rates[k] = rate(columns.rates[k]->columns);
  for (const ParameterColumn& column : columns.parameters) key.parameters.push_back(number({column.index}));
  if (columns.position && missing_ == columns.orientation.size() && of_orientation == missing_)
    key.lacks = KeyRow::Lacks::orientation;
  if (columns.position && missing_ == columns.position->size() && of_position == missing_)
    key.lacks = KeyRow::Lacks::position;
  return key;
}

std::optional<Error> RowReader::not_finite() const {
  if (!not_finite_) return std::nullopt;
  const std::string_view cell = table_.cells()[*not_finite_];
  return mended_by("drop_invalid",
                   formatted("found {}, wanted a finite number{}", cell.empty() ? "an empty cell" : in_quotes(cell),
                             not_finite_in_rate_ ? ", or none in all three cells of the rate to leave it free" : ""),
                   table_.here(not_finite_))
      .value();
}

Decimal RowReader::time(const KeyColumns& columns) {
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

Eigen::Vector3d RowReader::vector(const VectorColumns& columns) {
  const double x = number(columns[0]), y = number(columns[1]), z = number(columns[2]);
  return {x, y, z};
}

Eigen::Vector3d RowReader::rate(const VectorColumns& columns) {
  if (options_.free_rates == FreeRates::refused) return vector(columns);
  const auto before = not_finite_;
  const std::size_t missing = missing_;
  const Eigen::Vector3d rate = vector(columns);
  if (is_free(rate)) not_finite_ = before, missing_ = missing;
  else if (!before && rate.hasNaN()) not_finite_in_rate_ = true;
  return rate;
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
  ++missing_;
  if (!not_finite_) not_finite_ = index;
}

}}}  // namespace orispline::io
