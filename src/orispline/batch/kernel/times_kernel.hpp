// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

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

}  // namespace

}}}  // namespace orispline::batch
