// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/nearest_double.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <limits>
#include <vector>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// A whole number of any size that is not negative.
class Natural {
 public:
  explicit Natural(std::uint32_t value) { append(value); }

  void multiply_and_add(std::uint32_t factor, std::uint32_t added) {
    std::uint64_t carry = added;
    for (std::uint32_t& word : words_) {
      carry += std::uint64_t{word} * factor;
      word = static_cast<std::uint32_t>(carry);
      carry >>= word_bits;
    }
    append(static_cast<std::uint32_t>(carry));
  }
  void multiply_by_power_of_ten(std::int64_t power) {
    for (; power > 0; --power) multiply_and_add(10, 0);
  }
  void multiply_by_power_of_two(int power) {
    multiply_and_add(std::uint32_t{1} << power % word_bits, 0);
    words_.insert(words_.begin(), static_cast<std::size_t>(power / word_bits), 0);
  }
  /// Of a number that is not greater.
  void subtract(const Natural& other) {
    std::int64_t carry = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      carry += std::int64_t{words_[i]} - (i < other.words_.size() ? other.words_[i] : 0);
      words_[i] = static_cast<std::uint32_t>(carry);
      carry >>= word_bits;
    }
    while (!words_.empty() && words_.back() == 0) words_.pop_back();
  }

  [[nodiscard]] int bits() const {
    if (words_.empty()) return 0;
    return static_cast<int>(words_.size() - 1) * word_bits + static_cast<int>(std::bit_width(words_.back()));
  }
  std::strong_ordering operator<=>(const Natural& other) const {
    if (const auto by_size = words_.size() <=> other.words_.size(); by_size != 0) return by_size;
    return std::lexicographical_compare_three_way(words_.rbegin(), words_.rend(), other.words_.rbegin(),
                                                  other.words_.rend());
  }

 private:
  static constexpr int word_bits = 32;

  void append(std::uint32_t word) {
    if (word != 0) words_.push_back(word);
  }

  std::vector<std::uint32_t> words_;  // the least significant first, and the last not 0
};

struct Quotient {
  Natural numerator, denominator;
};

/// Of the digits, the first of which is not 0, and the exponent.
Quotient quotient_of(std::string_view digits, std::int64_t exponent) {
  constexpr std::size_t most_digits = 768;  // that half-way between two doubles has; beyond only 0 or not 0 counts
  const std::string_view counting = digits.substr(0, most_digits);
  Quotient quotient{Natural(0), Natural(1)};
  for (const char digit : counting) quotient.numerator.multiply_and_add(10, static_cast<std::uint32_t>(digit - '0'));
  exponent += static_cast<std::int64_t>(digits.size() - counting.size());
  if (digits.find_first_not_of('0', counting.size()) != std::string_view::npos) {
    quotient.numerator.multiply_and_add(10, 1);
    --exponent;
  }
  quotient.numerator.multiply_by_power_of_ten(exponent);
  quotient.denominator.multiply_by_power_of_ten(-exponent);
  return quotient;
}

double rounded(Quotient&& quotient) {
  using Limits = std::numeric_limits<double>;
  auto& [numerator, denominator] = quotient;
  int power = numerator.bits() - denominator.bits();
  if (power > 0) denominator.multiply_by_power_of_two(power);
  else numerator.multiply_by_power_of_two(-power);
  if (numerator < denominator) {
    numerator.multiply_by_power_of_two(1);
    --power;
  }
  // The quotient of what is left is in [1, 2), and that of all 2^power times as much.
  constexpr int lowest_power = Limits::min_exponent - Limits::digits;  // of all doubles
  const int bits = std::min(Limits::digits, power - lowest_power + 1);
  if (bits < 0) return 0.0;
  std::uint64_t mantissa = 0;
  for (int i = 0; i < bits; ++i) {
    const bool bit = numerator >= denominator;
    if (bit) numerator.subtract(denominator);
    mantissa = 2 * mantissa + (bit ? 1 : 0);
    numerator.multiply_by_power_of_two(1);
  }
  const auto rest = numerator <=> denominator;  // against a half
  if (rest > 0 || (rest == 0 && mantissa % 2 == 1)) ++mantissa;
  return std::ldexp(static_cast<double>(mantissa), power - bits + 1);
}

}  // namespace

double nearest_double(std::string_view digits, std::int64_t exponent) {
  using Limits = std::numeric_limits<double>;
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  const std::int64_t decade = exponent + static_cast<std::int64_t>(digits.size()) - 1;
  constexpr int lowest_decade = Limits::min_exponent10 - Limits::digits10 - 2;  // half of the least double is above it
  if (digits.empty() || decade < lowest_decade) return 0.0;
  if (decade > Limits::max_exponent10) return Limits::infinity();
  return rounded(quotient_of(digits, exponent));
}

}}  // namespace orispline
