// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/blending/polynomial.hpp>

#include <vector>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

namespace {

constexpr std::size_t most_terms = 12;
constexpr unsigned highest_power = 40;

/// `a`, `b2`, `a_1`: a parameter at a key, seen from a segment that begins at key `first`.
std::string name_of_variable(const Polynomial::Variable& variable, int first) {
  const auto& [parameter, key] = variable;
  const int behind = key - first, farther = behind <= 0 ? -behind : behind - 1;
  std::string name = behind <= 0 ? "a" : "b";
  if (parameter > 0) name += formatted("{}", parameter + 1);
  return farther > 0 ? name + formatted("_{}", farther) : name;
}

}  // namespace

Polynomial Polynomial::unknown() {
  Polynomial polynomial;
  polynomial.is_known_ = false;
  return polynomial;
}

void Polynomial::add(const Monomial& monomial, const Modular& coefficient) {
  const auto [place, is_new] = terms_.try_emplace(monomial, coefficient);
  if (!is_new) place->second = place->second + coefficient;
  if (place->second == Modular()) terms_.erase(place);
}

Polynomial Polynomial::operator-() const {
  Polynomial made = *this;
  for (auto& [monomial, coefficient] : made.terms_) coefficient = -coefficient;
  return made;
}

Polynomial Polynomial::operator+(const Polynomial& other) const {
  if (!is_known_ || !other.is_known_) return unknown();
  Polynomial made = *this;
  for (const auto& [monomial, coefficient] : other.terms_) made.add(monomial, coefficient);
  return made.terms_.size() > most_terms ? unknown() : made;
}

Polynomial Polynomial::operator*(const Polynomial& other) const {
  if (!is_known_ || !other.is_known_) return unknown();
  Polynomial made;
  for (const auto& [left, left_coefficient] : terms_)
    for (const auto& [right, right_coefficient] : other.terms_) {
      Monomial both = left;
      for (const auto& [variable, power] : right)
        if ((both[variable] += power) > highest_power) return unknown();
      made.add(both, left_coefficient * right_coefficient);
    }
  return made.terms_.size() > most_terms ? unknown() : made;
}

Polynomial Polynomial::operator/(const Polynomial& other) const {
  if (!other.is_number()) return unknown();
  return *this * Polynomial(Modular(1) / other.terms_.begin()->second);
}

Polynomial Polynomial::normal() const {
  return terms_.empty() ? *this : *this * Polynomial(Modular(1) / terms_.begin()->second);
}

std::optional<std::string> Polynomial::text(int key) const {
  if (!is_known_) return std::nullopt;
  std::string sum;
  for (const auto& [monomial, coefficient] : terms_) {
    auto factor = fraction_text(coefficient);
    if (!factor) return std::nullopt;
    const bool is_negative = factor->starts_with('-');
    if (is_negative) factor->erase(0, 1);
    std::vector<std::string> factors;
    if (*factor != "1" || monomial.empty()) factors.push_back(*factor);
    for (const auto& [variable, power] : monomial)
      factors.push_back(name_of_variable(variable, key) + (power > 1 ? formatted("^{}", power) : ""));
    if (!sum.empty()) sum += is_negative ? " − " : " + ";
    else if (is_negative) sum += "−";
    sum += joined(factors, "*");
  }
  return sum;
}

}}}  // namespace orispline::blending
