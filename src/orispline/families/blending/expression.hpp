// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/families/blending/modular.hpp>

// Coefficients of blending functions as users type them: + - * / ^ ( ), numbers, parameters at keys, lengths of
// intervals. They are kept as a short program for a stack and evaluated over doubles or, exactly, over a finite field.

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// A quantity that an expression names.
struct Quantity {
  enum class Kind { parameter, length };
  Kind kind;
  int parameter;  ///< which one, from 0; of a length 0
  int offset;     ///< of the key from that at which the segment begins, or of the interval from the segment's own

  bool operator==(const Quantity&) const = default;
};

/// A number as it was typed, in all fields.
struct Literal {
  double real;
  Modular exact;

  template <class Value>
  [[nodiscard]] Value in() const {
    if constexpr (std::same_as<Value, Modular>) return exact;
    else if constexpr (std::same_as<Value, double>) return real;
    else return Value(*this);
  }
};

/// That of a whole number.
[[nodiscard]] inline Literal whole(std::uint64_t number) { return {static_cast<double>(number), Modular(number)}; }

class Expression {
 public:
  static constexpr std::size_t deepest_stack = 64;
  static constexpr double smallest_number = 1e-30, largest_number = 1e9;  ///< that are typed, beside 0

  /// Reads an expression in that many parameters. Errors (bad_argument), with the position of the character from 1:
  /// what cannot be understood, a name that there is not, a division by an expression in a parameter or by 0, a number
  /// that is not finite or out of range, a power that is no whole number from 0 to 20, more than `deepest_stack`
  /// levels.
  [[nodiscard]] static Expected<Expression> parse(std::string_view text, std::size_t parameters);

  /// The value over a field: `constant(Literal)`, `quantity(Quantity)`.
  template <class Field>
  [[nodiscard]] auto over(const Field& field) const {
    return over(field, std::span(steps_));
  }

  /// What it depends on.
  [[nodiscard]] const std::vector<Quantity>& quantities() const noexcept { return quantities_; }
  /// The divisors, as they were typed, that are 0 for some lengths or may be.
  [[nodiscard]] const std::vector<std::string>& doubtful_divisors() const noexcept { return doubtful_divisors_; }

 private:
  friend class ExpressionParser;
  enum class Operation : std::uint8_t { literal, quantity, negate, power, add, subtract, multiply, divide };
  struct Step {
    Operation operation;
    std::size_t index = 0;  ///< of the literal or the quantity; the exponent of a power
  };

  template <class Field>
  [[nodiscard]] auto over(const Field& field, std::span<const Step> steps) const {
    using Value = decltype(field.constant(Literal{}));
    std::array<Value, deepest_stack> stack{};
    std::size_t top = 0;
    for (const Step& step : steps) switch (step.operation) {
        case Operation::literal:
          stack[top++] = field.constant(literals_[step.index]);
          break;
        case Operation::quantity:
          stack[top++] = field.quantity(quantities_[step.index]);
          break;
        case Operation::negate:
          stack[top - 1] = -stack[top - 1];
          break;
        case Operation::power: {
          const Value base = stack[top - 1];
          stack[top - 1] = field.constant(whole(1));
          for (std::size_t k = 0; k < step.index; ++k) stack[top - 1] = stack[top - 1] * base;
          break;
        }
        default: {
          const Value right = stack[--top], left = stack[top - 1];
          stack[top - 1] = step.operation == Operation::add        ? left + right
                           : step.operation == Operation::subtract ? left - right
                           : step.operation == Operation::multiply ? left * right
                                                                   : left / right;
        }
      }
    return stack[0];
  }

  std::vector<Step> steps_;
  std::vector<Literal> literals_;
  std::vector<Quantity> quantities_;
  std::vector<std::string> doubtful_divisors_;
};

}}}  // namespace orispline::blending
