// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <orispline/files.hpp>
#include <orispline/pages.hpp>
#include <orispline/tune.hpp>

// Something of each component that the library may be without.
int main() {
  const auto missing = orispline::io::read_keys("no/such/file.csv");
  const bool reads = !missing && missing.error().code == orispline::ErrorCode::bad_access;
  const bool tunes = orispline::tunable_methods().find("timed-c2") != std::string::npos;
  const bool draws = orispline::report::document({.title = "of a user"}).find("of a user") != std::string::npos;
  std::printf("io %d, optimise %d, pages %d\n", reads, tunes, draws);
  return reads && tunes && draws ? 0 : 1;
}
