// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <string>
#include <workload/keys.hpp>
#include <workload/verify.hpp>

namespace orispline::bench {

double accept(std::string_view contender, double error, double limit) {
  if (error <= limit) return error;
  char numbers[96];
  std::snprintf(numbers, sizeof numbers, " is off its definition by %.3g, wanted at most %.3g: not timed", error,
                limit);
  give_up(std::string(contender) + numbers);
}

}  // namespace orispline::bench
