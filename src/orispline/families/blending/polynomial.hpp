// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include <orispline/families/blending/expression.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// A polynomial in the parameters at keys. What has more terms than people read, or is divided by another than a
/// number, is unknown.
class Polynomial {
 public:
  using Variable = std::pair<int, int>;           ///< a parameter and a key
  using Monomial = std::map<Variable, unsigned>;  ///< with exponents

  Polynomial() = default;
  explicit Polynomial(const Literal& literal) : Polynomial(literal.exact) {}
  explicit Polynomial(const Modular& constant) { add({}, constant); }
  explicit Polynomial(const Variable& variable) { add({{variable, 1}}, Modular(1)); }

  [[nodiscard]] bool is_known() const noexcept { return is_known_; }
  [[nodiscard]] bool is_zero() const noexcept { return is_known_ && terms_.empty(); }
  /// A number other than 0.
  [[nodiscard]] bool is_number() const noexcept {
    return is_known_ && terms_.size() == 1 && terms_.begin()->first.empty();
  }
  /// The multiple whose first coefficient is 1.
  [[nodiscard]] Polynomial normal() const;
  /// As it would be typed in an entry of a segment that begins at the key of that number, such as `1 − a`. Nothing
  /// where a coefficient is no small fraction.
  [[nodiscard]] std::optional<std::string> text(int key) const;

  [[nodiscard]] Polynomial operator-() const;
  [[nodiscard]] Polynomial operator+(const Polynomial& other) const;
  [[nodiscard]] Polynomial operator-(const Polynomial& other) const { return *this + -other; }
  [[nodiscard]] Polynomial operator*(const Polynomial& other) const;
  [[nodiscard]] Polynomial operator/(const Polynomial& other) const;
  bool operator==(const Polynomial&) const = default;

 private:
  [[nodiscard]] static Polynomial unknown();
  void add(const Monomial& monomial, const Modular& coefficient);

  std::map<Monomial, Modular> terms_;
  bool is_known_ = true;
};

}}}  // namespace orispline::blending
