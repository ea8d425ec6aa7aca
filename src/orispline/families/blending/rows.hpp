// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <orispline/curve/own_family.hpp>
#include <orispline/families/blending/expression.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// The coefficients of cumulative blending functions, row by row; row k belongs to increment `first` + k.
template <class Value>
using Coefficients = std::vector<std::vector<Value>>;

/// Rows of expressions, and what they are over a field.
class Rows {
 public:
  /// Errors: those of BlendingFamily::make() that concern rows.
  [[nodiscard]] static Expected<Rows> parse(const BlendingData& data);

  [[nodiscard]] std::size_t increments() const noexcept { return rows_.size() - (is_bezier() ? 1 : 0); }
  [[nodiscard]] std::size_t degree() const noexcept { return rows_.front().size() - 1; }
  /// The first increment, 0 being the segment's own.
  [[nodiscard]] int first() const noexcept { return first_; }
  [[nodiscard]] int last() const noexcept { return first_ + static_cast<int>(increments()) - 1; }
  /// Keys on either side of the segment's own that its increments reach.
  [[nodiscard]] int reach() const noexcept { return std::max(-first(), last()); }
  /// The farthest offsets of keys and intervals that its coefficients depend on, as keys on either side of its own.
  [[nodiscard]] int coefficient_reach() const noexcept;
  /// Whether a parameter acts beyond the two segments beside its key.
  [[nodiscard]] bool parameters_reach_out() const noexcept;
  /// The divisors, as they were typed, that are 0 for some lengths or may be; each once.
  [[nodiscard]] std::vector<std::string> doubtful_divisors() const;
  [[nodiscard]] bool is_bezier() const noexcept { return basis_ == BlendingBasis::bezier; }

  /// The rows as they are stated.
  template <class Field>
  [[nodiscard]] auto stated(const Field& field) const {
    Coefficients<decltype(field.constant(Literal{}))> values;
    for (const auto& row : rows_) {
      auto& made = values.emplace_back();
      for (const Expression& entry : row) made.push_back(entry.over(field));
    }
    return values;
  }

  /// The cumulative blending functions in the Bernstein basis.
  template <class Field>
  [[nodiscard]] auto cumulative(const Field& field) const {
    auto rows = stated(field);
    if (basis_ == BlendingBasis::power)
      for (auto& row : rows) row = in_bernstein_basis(field, row);
    if (!is_bezier()) return rows;
    for (std::size_t k = rows.size() - 1; k-- > 0;)
      for (std::size_t i = 0; i < rows[k].size(); ++i) rows[k][i] = rows[k][i] + rows[k + 1][i];
    rows.erase(rows.begin());
    return rows;
  }

 private:
  /// b_j = Σ_{i ≤ j} C(j, i)/C(n, i) a_i.
  template <class Field, class Value>
  static std::vector<Value> in_bernstein_basis(const Field& field, const std::vector<Value>& powers) {
    const std::size_t n = powers.size() - 1;
    const auto number = [&](std::size_t value) { return field.constant(whole(value)); };
    std::vector<Value> made;
    for (std::size_t j = 0; j <= n; ++j) {
      Value sum = powers[0], share = number(1);
      for (std::size_t i = 1; i <= j; ++i) {
        share = share * number(j + 1 - i) / number(n + 1 - i);
        sum = sum + share * powers[i];
      }
      made.push_back(sum);
    }
    return made;
  }

  std::vector<std::vector<Expression>> rows_;
  BlendingBasis basis_ = BlendingBasis::bernstein;
  int first_ = 0;
};

}}}  // namespace orispline::blending
