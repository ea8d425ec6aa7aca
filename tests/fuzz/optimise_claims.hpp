// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>
#include <memory>

#include <fuzz/claim.hpp>
#include <fuzz/fuzzed_method.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/track.hpp>

namespace orispline::fuzz {

/// What a task is tried on.
struct TaskInput {
  FuzzInput options, more;  ///< bytes before the keys and behind them
  const FuzzedKeys& fuzzed;
  std::shared_ptr<const Track> keys;       ///< those
  std::shared_ptr<const Track> recording;  ///< many samples of the motion through them, or the keys again
  /// A method of the list.
  template <std::size_t N>
  [[nodiscard]] Method chosen(const std::array<const char*, N>& names) {
    const FamilyInfo& family = *find_family(names[options.below(N)]).value();
    return fuzzed_method(options, family, fuzzed);
  }
};

/// What a task takes, on all its threads. Only a fuzzer looks for inputs that are slow; a replay claims no time.
class Stopwatch {
 public:
  ~Stopwatch() {
#if defined(ORISPLINE_FUZZ_SLOWED)
    constexpr double longest_task = 35.0;  // [s] of processor time, slowed down up to 35 times: a second of a user
    const double taken = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
    claim(taken <= longest_task, "it takes {} s", taken);
#endif
  }

 private:
  [[maybe_unused]] std::clock_t start_ = std::clock();
};

[[nodiscard]] inline AnyCurve curve_of(const Method& method, const Keyframes& keys) {
  auto curve = make_curve(method, keys);
  claim(curve.has_value(), "the result has no curve: {}", curve ? "" : describe(curve.error()));
  return *std::move(curve);
}

/// What each job promises of its result, or a refusal in plain words.
void try_reduce(TaskInput& input);
void try_retime(TaskInput& input);
void try_smooth(TaskInput& input);
void try_tune(TaskInput& input);
void try_compare(TaskInput& input);
void try_inspect(TaskInput& input);
void try_align(TaskInput& input);

}  // namespace orispline::fuzz
