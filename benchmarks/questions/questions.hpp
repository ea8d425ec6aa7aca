// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace orispline::bench {

/// How much is measured.
struct Sizes {
  std::size_t written;                   ///< by the probe of writing, in samples: more than any cache holds
  std::size_t keys;                      ///< of the one curve
  std::vector<std::size_t> samples;      ///< of the one curve; the last one is the largest
  std::vector<std::size_t> per_segment;  ///< samples
  std::vector<std::size_t> many_curves;
  std::size_t random_accesses;
  std::size_t setup_keys;
  int setup_repetitions;
};

/// Largest errors of ours against the definition, over everything that was verified.
struct Errors {
  double in_double = 0.0, in_float = 0.0;
  void add_double(double error) { in_double = std::max(in_double, error); }
  void add_float(double error) { in_float = std::max(in_float, error); }
};

/// Registers a measurement of work on that many items.
void measure(const std::string& name, std::size_t items, std::function<void()> work);

// One file per question. Each verifies its contenders, then registers them; `isa` names the library's kernels.
void ask_limits(const Sizes& sizes, const char* isa);              ///< what can this machine do at best?
void ask_one_curve(const Sizes& sizes, Errors& errors);            ///< what does a sample of one curve cost?
void ask_rates(const Sizes& sizes, Errors& errors);                ///< … with its rates?
void ask_samples_per_segment(const Sizes& sizes, Errors& errors);  ///< … when segments are short?
void ask_many_curves(const Sizes& sizes, Errors& errors);          ///< what do many curves at one time cost?
void ask_random_access(const Sizes& sizes, Errors& errors);        ///< what does one sample anywhere cost?
void ask_setup(const Sizes& sizes);                                ///< what does a curve cost before its first sample?
void ask_auto(const Sizes& sizes);                                 ///< what do samples of `auto` cost?
void ask_baked(const Sizes& sizes);                                ///< what do samples of baked curves cost?
void ask_motion(const Sizes& sizes);                               ///< what does a single motion cost?
void ask_online(const Sizes& sizes);                               ///< what does a key cost in a stream?

}  // namespace orispline::bench
