// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/math/eigen.hpp>

#include "support/places.hpp"

namespace orispline::testing_support {

/// Fields of one line, or of one list, at a separator.
[[nodiscard]] inline std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  while (true) {
    const std::size_t end = line.find(separator);
    fields.emplace_back(line.substr(0, end));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

[[nodiscard]] inline double number_of(const std::string& field) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size()) throw std::runtime_error("no number: " + field);
  return value;
}

/// A committed table of the tests: `#` comments, a header, comma-separated fields. Throws on anything else.
class DataTable {
 public:
  class Row {
   public:
    Row(const DataTable& table, std::size_t index) : table_(&table), index_(index) {}
    [[nodiscard]] const std::string& text(std::string_view column) const {
      return table_->rows_[index_][table_->column(column)];
    }
    [[nodiscard]] double number(std::string_view column) const { return number_of(text(column)); }
    /// Numbers separated by blanks; none where the field is empty.
    [[nodiscard]] std::vector<double> numbers(std::string_view column) const {
      std::vector<double> values;
      if (!text(column).empty())
        for (const std::string& field : fields_of(text(column), ' ')) values.push_back(number_of(field));
      return values;
    }
    [[nodiscard]] Eigen::Vector3d vector(std::string_view x, std::string_view y, std::string_view z) const {
      return {number(x), number(y), number(z)};
    }
    [[nodiscard]] Eigen::Quaterniond quaternion(std::string_view w, std::string_view x, std::string_view y,
                                                std::string_view z) const {
      return quaternion_wxyz(number(w), number(x), number(y), number(z));
    }

   private:
    const DataTable* table_;
    std::size_t index_;
  };

  /// A file of tests/data.
  explicit DataTable(const std::string& name) {
    std::ifstream file(in_project("tests/data/") + name);
    if (!file) throw std::runtime_error("cannot open tests/data/" + name);
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with('#')) continue;
      auto fields = fields_of(line, ',');
      if (columns_.empty()) columns_ = std::move(fields);
      else if (fields.size() == columns_.size()) rows_.push_back(std::move(fields));
      else throw std::runtime_error(name + ": a line with " + std::to_string(fields.size()) + " fields: " + line);
    }
  }

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] Row row(std::size_t index) const { return {*this, index}; }
  [[nodiscard]] std::vector<Row> rows() const {
    std::vector<Row> all;
    for (std::size_t i = 0; i < size(); ++i) all.push_back(row(i));
    return all;
  }
  /// The rows whose field in `column` reads `text`.
  [[nodiscard]] std::vector<Row> rows_where(std::string_view column, std::string_view text) const {
    std::vector<Row> matching;
    for (std::size_t i = 0; i < size(); ++i)
      if (row(i).text(column) == text) matching.push_back(row(i));
    return matching;
  }

 private:
  [[nodiscard]] std::size_t column(std::string_view name) const {
    const auto found = std::ranges::find(columns_, name);
    if (found == columns_.end()) throw std::runtime_error("no column " + std::string(name));
    return static_cast<std::size_t>(found - columns_.begin());
  }

  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace orispline::testing_support
