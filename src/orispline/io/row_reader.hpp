// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <orispline/io/clock.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// One key as a row states it.
struct KeyRow {
  Decimal time;  ///< in the unit of the column; of ISO 8601 since the clock's zero [s]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  bool is_posed = true;                     ///< else no cell of the orientation has a number
  std::optional<Eigen::Vector3d> angles{};  ///< of Euler [rad], in the order of the turns
  Eigen::Vector3d position{};
  std::array<Eigen::Vector3d, 3> rates{};  ///< in the frames of the columns
  std::array<Eigen::Quaterniond, inner_names.size()> inner{};
  std::vector<double> parameters{};
};

/// Reads the cells of one row; remembers the first that is no number and the first that is not finite.
class RowReader {
 public:
  RowReader(const TextTable& table, const ReadOptions& options)
      : table_(table), clock_(options.clock), free_rates_(options.free_rates), unposed_rows_(options.unposed_rows) {}

  [[nodiscard]] KeyRow key(const KeyColumns& columns);

  /// A cell that is no number, or numbers that are no orientation: an error in any case.
  [[nodiscard]] const std::optional<Error>& refused() const { return refused_; }
  /// A cell that is empty or not finite: an error unless such rows are dropped.
  [[nodiscard]] std::optional<Error> not_finite() const;

 private:
  [[nodiscard]] Decimal time(const KeyColumns& columns);
  [[nodiscard]] Decimal iso_time(const KeyColumns& columns);
  [[nodiscard]] double number(const NumberColumn& column);
  template <std::size_t Size>
  [[nodiscard]] Eigen::Vector<double, static_cast<int>(Size)> vector(const std::array<NumberColumn, Size>& columns);
  template <std::size_t Size>
  [[nodiscard]] Eigen::Vector<double, static_cast<int>(Size)> free_vector(const std::array<NumberColumn, Size>& columns,
                                                                          const char* what);
  [[nodiscard]] Eigen::Vector3d rate(const VectorColumns& columns);
  void set_orientation(KeyRow& key, const KeyColumns& columns);
  void refuse(std::optional<std::size_t> index, Error error);
  void note_not_finite(std::size_t index);

  const TextTable& table_;
  const Clock& clock_;
  FreeRates free_rates_;
  UnposedRows unposed_rows_;
  std::optional<Error> refused_;
  std::optional<std::size_t> not_finite_;
  std::string free_instead_;  // how what is not finite could be left free
};

}}}  // namespace orispline::io
