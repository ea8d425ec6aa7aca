// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include <orispline/base/shortest_rest.hpp>
#include <orispline/batch/kernel/record.hpp>

// Loops over times alone. In an anonymous namespace, so that every instruction set has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch { namespace {

/// Looks at all times, though the first pair may tell: a loop that has no other end becomes vectors.
bool are_in_order(const double* times, std::size_t count) {
  std::int64_t wrong = count == 0 || times[0] == times[0] ? 0 : 1;
  for (std::size_t k = 1; k < count; ++k) wrong += times[k - 1] <= times[k] ? 0 : 1;
  return wrong == 0;
}

void write_even_times(const EvenTimes& even, double first, std::size_t count, double* times) {
  const double factor = even.factor, offset = even.offset, divisor = even.divisor;
  for (std::size_t k = 0; k < count; ++k)
    times[k] = ((first + static_cast<double>(static_cast<std::int64_t>(k))) * factor + offset) / divisor;
}

#if defined(__AVX512F__)
constexpr std::size_t times_at_once = 8;
#elif defined(__AVX__)
constexpr std::size_t times_at_once = 4;
#else
constexpr std::size_t times_at_once = 2;
#endif
typedef double Times __attribute__((vector_size(times_at_once * sizeof(double))));

std::size_t write_decimal_times(const DecimalTimes& wanted, int exponent, double first, std::size_t count,
                                double* times) {
  const Decade digits = decade(exponent);
  const DecimalTimes from = wanted;  // in registers, for the times may be anything
  const auto times_from = [&](Times index) __attribute__((always_inline)) {
    const Times offset = index * from.factor / from.divisor;
    return nearest_sum(from.high, from.low, offset, shortest_rest(offset, digits));
  };
  Times index;
  for (std::size_t i = 0; i < times_at_once; ++i) index[i] = first + static_cast<double>(i);
  WholeBits<Times>::type unsure{};  // one less for each
  std::size_t k = 0;
  for (; k + times_at_once <= count; k += times_at_once, index += static_cast<double>(times_at_once)) {
    const Times t = times_from(index);
    __builtin_memcpy(times + k, &t, sizeof t);
    unsure += t != t;
  }
  std::size_t sum = 0;
  for (std::size_t i = 0; i < times_at_once; ++i) sum += static_cast<std::size_t>(-unsure[i]);
  if (k == count) return sum;
  const Times last = times_from(index);
  for (std::size_t i = 0; i < count - k; ++i) {
    times[k + i] = last[i];
    sum += last[i] != last[i] ? 1 : 0;
  }
  return sum;
}

}  // namespace

}}}  // namespace orispline::batch
