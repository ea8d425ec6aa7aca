// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/io/key_file.hpp>
#include <orispline/optimise/reduce.hpp>

namespace orispline::cli {

/// What `orispline reduce` did.
struct ReduceReport {
  std::string input{}, output{};
  std::size_t samples = 0;
  io::RepairReport repairs{};
  optimise::ReduceOptions options;
  std::vector<optimise::Reduction> reductions{};  ///< by each of the methods
  std::size_t chosen = 0;                         ///< of them, the one that was written
  std::vector<io::Decimal> times{};               ///< of the samples, in the file's own time [s]
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const ReduceReport& report);

}  // namespace orispline::cli
