// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/number.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include <orispline/math/elementary_tables.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace elementary {

namespace {

constexpr double round_to_even =
    0x1.8p52;  // added and taken away it rounds to an integer, which stands in the low bits

constexpr double cosine_is_1 = 0x1p-27, eighth_turn = 0.5 * half_pi[0];

/// A number in two parts, the second small beside the first.
struct Sum {
  double high, low;
};

/// a + b without error; |a| ≥ |b|, or the sum is exact.
Sum exact_sum(double a, double b) {
  const double sum = a + b;
  return {sum, (a - sum) + b};
}

/// a b without error (Dekker): each factor in halves of 26 bits.
Sum exact_product(double a, double b) {
  constexpr double halving = 0x1p27 + 1.0;
  const double a_shifted = a * halving, b_shifted = b * halving;
  const double a1 = a_shifted - (a_shifted - a), b1 = b_shifted - (b_shifted - b);
  const double a2 = a - a1, b2 = b - b1, product = a * b;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }
double with_sign_bit(double x, std::uint64_t sign) { return std::bit_cast<double>(bits_of(x) ^ sign); }

/// 2^exponent, a normal number.
double power_of_two(int exponent) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52); }

/// What is left of an angle after quarter turns; only the last two bits of their number count.
struct Reduced {
  Sum rest;  ///< [-π/4, π/4], or a rounding more
  std::uint64_t quarters;
};

/// Up to 1000 rad: the products with the first two parts of π/2 are exact, and so are the differences with `low`. What
/// the third part and its product lack is below quarters · 2^-121; no double of that size but 0 is nearer to a multiple
/// of π/2 than 2^-61.
Reduced reduced_by_parts(double angle) {
  const double rounded = angle * (1.0 / half_pi[0]) + round_to_even, quarters = rounded - round_to_even;
  const Sum rest = exact_sum(angle - quarters * half_pi_parts[0], -(quarters * half_pi_parts[1]));
  return {{rest.high, rest.low - quarters * half_pi_parts[2]}, bits_of(rounded)};
}

constexpr std::size_t product_words = 6;

/// Adds digit · words, shifted up by `shift` words, to the product; what overflows is whole turns. Least word first.
void add_product(std::array<std::uint32_t, product_words>& product,
                 const std::array<std::uint32_t, product_words>& words, std::uint64_t digit, std::size_t shift) {
  std::uint64_t carry = 0;
  for (std::size_t i = shift; i < product_words; ++i) {
    carry += digit * words[i - shift] + product[i];
    product[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
}

/// Any angle ≥ 512 [rad]: m 2^e, m an integer, times those 192 bits of 2/π that count modulo four quarter turns
/// (Payne and Hanek). The rest is as good as for small angles, since no double is nearer to a multiple of π/2 than
/// 2^-61.
Reduced reduced_exactly(double angle) {
  constexpr std::size_t leading_zeros = 64, to_unit_digit = 2;
  const std::uint64_t mantissa = (bits_of(angle) & 0x000fffffffffffff) | 0x0010000000000000;
  const std::size_t exponent_plus_1075 = bits_of(angle) >> 52;
  const std::size_t first_bit = exponent_plus_1075 + leading_zeros - to_unit_digit - 1075, skipped = first_bit % 32;
  std::array<std::uint32_t, product_words> words, product{};
  for (std::size_t i = 0; i < product_words; ++i) {
    const std::size_t word = first_bit / 32 + product_words - 1 - i;
    const std::uint64_t pair = std::uint64_t{two_over_pi[word]} << 32 | two_over_pi[word + 1];
    words[i] = static_cast<std::uint32_t>(pair << skipped >> 32);
  }
  add_product(product, words, mantissa & 0xffffffff, 0);
  add_product(product, words, mantissa >> 32, 1);

  const std::uint32_t top = product.back(), fraction_bits = 30;
  const std::uint64_t up = top >> (fraction_bits - 1) & 1;
  const double fraction = static_cast<double>(top & 0x3fffffff) - static_cast<double>(up << fraction_bits);
  Sum turn{fraction * 0x1p-30, 0.0};
  double unit = 0x1p-30;
  for (std::size_t i = product_words - 1; i-- > 0;) {
    unit *= 0x1p-32;
    const Sum next = exact_sum(turn.high, unit * product[i]);
    turn = {next.high, turn.low + next.low};
  }
  const Sum rest = exact_product(turn.high, half_pi[0]);
  return {{rest.high, rest.low + (turn.high * half_pi[1] + turn.low * half_pi[0])}, (top >> fraction_bits) + up};
}

/// Sine and cosine of a reduced angle. What is added last to the leading term is small: it brings less than half an
/// ulp.
inline SineCosine in_first_octants(Sum angle) {
  const double r = angle.high, z = r * r, z2 = z * z, half = 0.5 * z, complement = 1.0 - half;
  std::array<double, 2> terms;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto p = [&](std::size_t k) { return sine_cosine_terms[k][i]; };
    terms[i] = (p(0) + p(1) * z) + z2 * ((p(2) + p(3) * z) + z2 * (p(4) + p(5) * z));
  }
  return {r + (r * z * terms[0] + angle.low * complement),
          complement + (((1.0 - complement) - half) + (z2 * terms[1] - r * angle.low))};
}

SineCosine turned(const Reduced& angle) {
  const auto [sine, cosine] = in_first_octants(angle.rest);
  const std::uint64_t n = angle.quarters;
  const std::uint64_t exchange = (bits_of(sine) ^ bits_of(cosine)) & (0 - (n & 1));
  return {with_sign_bit(sine, exchange ^ (n & 2) << 62), with_sign_bit(cosine, exchange ^ ((n + 1) & 2) << 62)};
}

SineCosine of_large_or_no_angle(double angle) {
  if (!std::isfinite(angle)) return {angle - angle, angle - angle};
  const SineCosine found = turned(reduced_exactly(std::abs(angle)));
  return {std::signbit(angle) ? -found.sine : found.sine, found.cosine};
}

/// The leading 26 bits: products of such numbers are exact.
double leading_half(double x) { return std::bit_cast<double>(bits_of(x) & ~std::uint64_t{0x7ffffff}); }

/// atan(least/most) for 0 ≤ least ≤ most away from overflow and underflow, from the nearest of the tabulated c = i/32:
/// atan c + atan t, t = (least - c most)/(most + c least). Below 1/16, c is 0 and t needs what its rounding lost.
Sum arctangent_of_quotient(double least, double most) {
  constexpr double steps = 32.0;
  const double upper = leading_half(most), lower = most - upper;
  const auto remainder = [&](double c) { return (least - c * upper) - c * lower; };
  double t = least / most, rest = 0.0;
  std::size_t i = 0;
  if (t < 2.0 / steps) {
    const double part = leading_half(t);
    rest = remainder(part) * (1.0 / most) - (t - part);
  } else {
    i = static_cast<std::size_t>(t * steps + 0.5);  // NOLINT(bugprone-incorrect-roundings): not negative
    const double c = static_cast<double>(i) / steps;
    t = remainder(c) / (most + c * least);
    rest = arctangent_rests[i];
  }
  const double z = t * t, z2 = z * z;
  const auto& a = arctangent_terms;
  const double terms = (a[0] + a[1] * z) + z2 * ((a[2] + a[3] * z) + z2 * a[4]);
  return i == 0 ? Sum{t, rest + t * z * terms} : Sum{arctangents[i], rest + (t + t * z * terms)};
}

/// The angle of (x, y), y ≥ 0, from that of its octant. The parts that are added last are small, or exact.
double unfolded(Sum angle, bool steep, bool backward) {
  if (!steep && !backward) return angle.high + angle.low;
  const auto& from = steep ? half_pi : whole_pi;
  const double sign = steep && backward ? 1.0 : -1.0;
  const Sum sum = exact_sum(from[0], sign * angle.high);
  return sum.high + (sum.low + (from[1] + sign * angle.low));
}

double arctangent_at_the_limits(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  if (std::isinf(x) && std::isinf(y)) return arctangent(std::copysign(1.0, y), std::copysign(1.0, x));
  if (std::isinf(x) || (y == 0.0 && x == 0.0)) return arctangent(std::copysign(0.0, y), std::copysign(1.0, x));
  if (std::isinf(y)) return std::copysign(half_pi[0], y);
  const double scale = std::abs(x) + std::abs(y) < 1.0 ? 0x1p300 : 0x1p-300;
  return arctangent(y * scale, x * scale);
}

}  // namespace

SineCosine sine_cosine(double angle) noexcept {
  constexpr double by_parts = 1000.0;
  const double size = std::abs(angle);
  if (size < cosine_is_1) return {angle, 1.0};
  if (size <= eighth_turn) return in_first_octants({angle, 0.0});
  if (!(size <= by_parts)) return of_large_or_no_angle(angle);
  return turned(reduced_by_parts(angle));
}

std::array<SineCosine, 3> sines_cosines(const std::array<double, 3>& angles) noexcept {
  const auto needs_no_turn = [](double angle) { return cosine_is_1 <= angle && angle <= eighth_turn; };
  const auto [a, b, c] = angles;
  if (needs_no_turn(a) && needs_no_turn(b) && needs_no_turn(c))
    return {in_first_octants({a, 0.0}), in_first_octants({b, 0.0}), in_first_octants({c, 0.0})};
  return {sine_cosine(a), sine_cosine(b), sine_cosine(c)};
}

double arctangent(double y, double x) noexcept {
  constexpr double smallest = 0x1p-800, largest = 0x1p900, quotient_alone = 0x1p-30;
  const double height = std::abs(y), width = std::abs(x);
  if (!(height + width > smallest && height + width < largest)) return arctangent_at_the_limits(y, x);
  const bool steep = height > width;
  const double least = steep ? width : height, most = steep ? height : width;
  const Sum angle = least < most * quotient_alone ? Sum{least / most, 0.0} : arctangent_of_quotient(least, most);
  return std::copysign(unfolded(angle, steep, std::signbit(x)), y);
}

double natural_logarithm(double x) noexcept {
  if (!(x > 0.0)) return x == 0.0 ? -std::numeric_limits<double>::infinity() : (x - x) / (x - x);
  if (x == std::numeric_limits<double>::infinity()) return x;
  const bool subnormal = x < std::numeric_limits<double>::min();
  const std::uint64_t bits = bits_of(subnormal ? x * 0x1p54 : x), sqrt_half = bits_of(0x1.6a09e667f3bcdp-1);
  // x = 2^e (1 + f), 1 + f in [√½, √2); ln(1 + f) = 2 atanh s, s = f/(2 + f), and 2 s = f - f²/2 + s f²/2.
  const auto exponent = static_cast<std::int64_t>(bits - sqrt_half) >> 52;
  const double f = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << 52)) - 1.0;
  const double e = static_cast<double>(subnormal ? exponent - 54 : exponent);
  const double s = f / (2.0 + f), z = s * s, z2 = z * z, half = 0.5 * f * f;
  const auto& a = logarithm_terms;
  const double terms = (a[0] + a[1] * z) + z2 * ((a[2] + a[3] * z) + z2 * ((a[4] + a[5] * z) + z2 * a[6]));
  const double rest = s * (half + z * terms) + e * log_of_two[1];
  return e * log_of_two[0] - ((half - rest) - f);
}

double exponential(double x) noexcept {
  constexpr double beyond = 746.0;  // e^x is 0 or infinite
  if (!(std::abs(x) < beyond)) return x > 0.0 ? std::numeric_limits<double>::infinity() : x < 0.0 ? 0.0 : x;
  // x = n ln 2 + r, |r| ≤ ln(2)/2; with c = r - r² P(r²), e^r = 1 + r + r c/(2 - c).
  const double rounded = x * (1.0 / log_of_two[0]) + round_to_even, n = rounded - round_to_even;
  const double high = x - n * log_of_two[0], low = n * log_of_two[1];  // the first product is exact
  const double r = high - low, z = r * r, z2 = z * z;
  const auto& a = exponential_terms;
  const double c = r - z * ((a[0] + a[1] * z) + z2 * ((a[2] + a[3] * z) + z2 * a[4]));
  const double power = 1.0 + (high - (low - r * c / (2.0 - c)));
  const auto exponent = static_cast<int>(n), half = exponent / 2;
  return power * power_of_two(half) * power_of_two(exponent - half);  // the first one is exact
}

}}}  // namespace orispline::elementary
