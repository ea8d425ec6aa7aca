// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/blending/expression.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

namespace {

constexpr int largest_power = 20, largest_offset = 8, most_digits = 40;

bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// A decimal such as 0.35 or 1e-3 in the field, digit by digit.
Modular exact_value(std::string_view decimal) {
  Modular value;
  std::int64_t exponent = 0;
  bool behind_point = false;
  for (std::size_t i = 0; i < decimal.size(); ++i) {
    const char c = decimal[i];
    if (c == '.') behind_point = true;
    else if (is_digit(c)) {
      value = value * Modular(10) + Modular(static_cast<std::uint64_t>(c - '0'));
      exponent -= behind_point ? 1 : 0;
    } else {
      exponent += static_cast<std::int64_t>(*number_in(decimal.substr(i + 1)));
      break;
    }
  }
  const Modular scale = Modular(10).power(static_cast<std::uint64_t>(std::abs(exponent)));
  return exponent < 0 ? value / scale : value * scale;
}

/// Some place of the field: a divisor that is 0 there is 0 everywhere.
struct RandomField {
  [[nodiscard]] Modular constant(const Literal& literal) const { return literal.exact; }
  [[nodiscard]] Modular quantity(const Quantity& q) const {
    return Modular(0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(q.offset + 16)).power(3);
  }
};

/// What a pair of parentheses around all of a text holds, blanks left out.
std::string_view without_parentheses(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  text = text.substr(first, text.find_last_not_of(' ') + 1 - first);
  std::ptrdiff_t open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    open += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (open == 0) return i > 0 && i + 1 == text.size() ? without_parentheses(text.substr(1, i - 1)) : text;
  }
  return text;
}

/// What is known of a number from its signs alone.
enum class Sign { zero, positive, negative, any };

struct SignOf {
  Sign sign = Sign::zero;

  [[nodiscard]] SignOf operator-() const {
    return {sign == Sign::positive ? Sign::negative : sign == Sign::negative ? Sign::positive : sign};
  }
  [[nodiscard]] SignOf operator+(SignOf b) const {
    if (sign == Sign::zero || b.sign == Sign::zero) return sign == Sign::zero ? b : *this;
    return {sign == b.sign ? sign : Sign::any};
  }
  [[nodiscard]] SignOf operator-(SignOf b) const { return *this + -b; }
  [[nodiscard]] SignOf operator*(SignOf b) const {
    if (sign == Sign::zero || b.sign == Sign::zero) return {Sign::zero};
    if (sign == Sign::any || b.sign == Sign::any) return {Sign::any};
    return {sign == b.sign ? Sign::positive : Sign::negative};
  }
  [[nodiscard]] SignOf operator/(SignOf b) const { return *this * b; }
};

/// Lengths are positive.
struct SignField {
  [[nodiscard]] SignOf constant(const Literal& literal) const {
    return {literal.real > 0.0 ? Sign::positive : literal.real < 0.0 ? Sign::negative : Sign::zero};
  }
  [[nodiscard]] SignOf quantity(const Quantity& q) const {
    return {q.kind == Quantity::Kind::length ? Sign::positive : Sign::any};
  }
};

}  // namespace

/// By recursive descent: sums of products of powers of signs and parentheses.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, std::size_t parameters) : text_(text), parameters_(parameters) {}

  Expected<Expression> parsed() {
    sum(0);
    skip_blanks();
    if (!error_ && at_ < text_.size()) fail(formatted("found {}, wanted an operator", here()));
    if (error_) return tl::unexpected(std::move(*error_));
    return std::move(made_);
  }

 private:
  using Operation = Expression::Operation;

  void fail(std::string message) {
    if (!error_) error_ = Error{ErrorCode::bad_argument, formatted("position {}: {}", at_ + 1, message), {}};
  }
  [[nodiscard]] std::string here() const {
    return at_ < text_.size() ? in_quotes(text_.substr(at_, 1)) : "the end of the expression";
  }
  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(std::string_view word) {
    skip_blanks();
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }

  void sum(std::size_t depth) {
    product(depth);
    while (!error_) {
      const Operation operation = take("+") ? Operation::add : take("-") ? Operation::subtract : Operation::literal;
      if (operation == Operation::literal) return;
      product(depth + 1);
      made_.steps_.push_back({operation});
    }
  }

  void product(std::size_t depth) {
    signed_power(depth);
    while (!error_) {
      skip_blanks();
      if (text_.substr(at_).starts_with("**")) return;
      if (take("*")) {
        signed_power(depth + 1);
        made_.steps_.push_back({Operation::multiply});
      } else if (take("/")) {
        divide(depth + 1);
      } else {
        return;
      }
    }
  }

  /// A division by numbers and lengths, for then a polynomial in the parameters stays one.
  void divide(std::size_t depth) {
    const std::size_t place = at_, first_step = made_.steps_.size();
    signed_power(depth);
    if (error_) return;
    const auto divisor = std::span(std::as_const(made_).steps_).subspan(first_step);
    const bool has_parameter = std::ranges::any_of(divisor, [&](const Expression::Step& step) {
      return step.operation == Operation::quantity && made_.quantities_[step.index].kind == Quantity::Kind::parameter;
    });
    if (has_parameter || !made_.over(RandomField{}, divisor).is_divisor()) {
      at_ = place;
      return fail(has_parameter ? "found a division by a parameter, wanted one by numbers and lengths"
                                : "found a division by 0");
    }
    if (made_.over(SignField{}, divisor).sign == Sign::any)
      made_.doubtful_divisors_.emplace_back(without_parentheses(text_.substr(place, at_ - place)));
    made_.steps_.push_back({Operation::divide});
  }

  void signed_power(std::size_t depth) {
    if (depth + 4 > Expression::deepest_stack)
      return fail(formatted("found more than {} levels, wanted fewer", Expression::deepest_stack));
    if (take("-")) {
      signed_power(depth + 1);
      made_.steps_.push_back({Operation::negate});
      return;
    }
    if (take("+")) return signed_power(depth + 1);
    atom(depth);
    if (error_ || !(take("^") || take("**"))) return;
    skip_blanks();
    const std::string_view digits = run_of(is_digit);
    const auto exponent = number_in(digits);
    if (!exponent || *exponent > largest_power) {
      at_ -= digits.size();
      return fail(formatted("found {}, wanted a whole power from 0 to {}", here(), largest_power));
    }
    made_.steps_.push_back({Operation::power, static_cast<std::size_t>(*exponent)});
  }

  void atom(std::size_t depth) {
    if (take("(")) {
      sum(depth + 1);
      if (!error_ && !take(")")) fail(formatted("found {}, wanted ')'", here()));
      return;
    }
    skip_blanks();
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (is_digit(c) || c == '.') return number();
    if (('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_') return quantity();
    fail(formatted("found {}, wanted a number, a parameter or '('", here()));
  }

  template <class Belongs>
  std::string_view run_of(Belongs belongs) {
    const std::size_t start = at_;
    while (at_ < text_.size() && belongs(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

  void number() {
    const std::size_t start = at_;
    run_of([](char c) { return is_digit(c) || c == '.'; });
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
      run_of(is_digit);
    }
    const std::string_view text = text_.substr(start, at_ - start);
    const auto value = number_in(text);
    const double size = std::abs(value.value_or(Expression::largest_number * 2.0));
    const bool is_in_range = size <= Expression::largest_number && (size == 0.0 || size >= Expression::smallest_number);
    if (!is_in_range || text.size() > most_digits) {
      at_ = start;
      return fail(formatted("found {}, wanted a number up to {:g}", in_quotes(text), Expression::largest_number));
    }
    made_.literals_.push_back({*value, exact_value(text)});
    made_.steps_.push_back({Operation::literal, made_.literals_.size() - 1});
  }

  /// A whole number from 1 on, small enough; 0 where there is none.
  int index() {
    const std::string_view digits = run_of(is_digit);
    if (digits.empty() || digits.size() > 3 || digits.front() == '0') return 0;
    return static_cast<int>(number_in(digits).value_or(0.0));
  }

  void quantity() {
    const std::size_t start = at_;
    const std::optional<Quantity> found = named();
    const auto goes_on = [](char c) {
      return is_digit(c) || c == '_' || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
    };
    const bool ends = run_of(goes_on).empty();
    const std::string_view name = text_.substr(start, at_ - start);
    if (!found || !ends || std::abs(found->offset) > largest_offset) {
      at_ = start;
      return fail(formatted("unknown name {}, wanted {}", in_quotes(name), known_names()));
    }
    made_.quantities_.push_back(*found);
    made_.steps_.push_back({Operation::quantity, made_.quantities_.size() - 1});
  }

  /// `a`, `b`: the first parameter at the keys of the segment; `a2`, `b2`: the second; `a_1`, `b_1`: one key farther
  /// out. `h`: the segment's length; `h_1`: the interval before; `h1`: the one behind.
  std::optional<Quantity> named() {
    const char letter = text_[at_++];
    const bool is_numbered = at_ < text_.size() && is_digit(text_[at_]);
    const int number = is_numbered ? index() : 0;
    const bool is_farther = at_ < text_.size() && text_[at_] == '_';
    if (is_farther) ++at_;
    const int farther = is_farther ? index() : 0;
    if ((is_numbered && number == 0) || (is_farther && farther == 0)) return std::nullopt;
    if (letter == 'h') {
      if (number > 0 && farther > 0) return std::nullopt;
      return Quantity{Quantity::Kind::length, 0, number > 0 ? number : -farther};
    }
    const int which = std::max(number, 1) - 1;
    if ((letter != 'a' && letter != 'b') || which >= static_cast<int>(parameters_)) return std::nullopt;
    return Quantity{Quantity::Kind::parameter, which, letter == 'a' ? -farther : 1 + farther};
  }

  [[nodiscard]] std::string known_names() const {
    if (parameters_ == 0) return "h, h_1 or h1, for there are no parameters";
    if (parameters_ == 1) return "a or b for the parameter, a_1 or b_1 farther out, or h, h_1, h1";
    return formatted("a, b, a2 … b{} for the parameters, a_1 or b_1 farther out, or h, h_1, h1", parameters_);
  }

  std::string_view text_;
  std::size_t parameters_, at_ = 0;
  Expression made_;
  std::optional<Error> error_;
};

Expected<Expression> Expression::parse(std::string_view text, std::size_t parameters) {
  return ExpressionParser(text, parameters).parsed();
}

std::optional<std::string> fraction_text(Modular number) {
  // Wang's rational reconstruction: the extended Euclidean algorithm, stopped half way.
  constexpr std::int64_t bound = std::int64_t{1} << 30;
  std::int64_t r0 = static_cast<std::int64_t>(Modular::prime), r1 = static_cast<std::int64_t>(number.value());
  std::int64_t s0 = 0, s1 = 1;
  while (r1 >= bound) {
    const std::int64_t quotient = r0 / r1;
    std::tie(r0, r1) = std::pair(r1, r0 - quotient * r1);
    std::tie(s0, s1) = std::pair(s1, s0 - quotient * s1);
  }
  if (s1 < 0) r1 = -r1, s1 = -s1;
  if (s1 == 0 || s1 >= bound) return std::nullopt;
  const Modular size(static_cast<std::uint64_t>(std::abs(r1))), divisor(static_cast<std::uint64_t>(s1));
  if ((r1 < 0 ? -size : size) / divisor != number) return std::nullopt;  // modulo the other prime too
  return s1 == 1 ? formatted("{}", r1) : formatted("{}/{}", r1, s1);
}

}}}  // namespace orispline::blending
