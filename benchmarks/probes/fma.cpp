// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, ORISPLINE_PROBE names it. Contraction is allowed here: one product and sum is one
// instruction where the processor has it, and two where it has not.
#include <probes/probes.hpp>

namespace orispline::bench {

namespace {

#if defined(__AVX512F__)
constexpr int width = 8, registers = 24;
#elif defined(__AVX__)
constexpr int width = 4, registers = 12;
#else
constexpr int width = 2, registers = 12;
#endif

typedef double Lanes __attribute__((vector_size(width * sizeof(double))));  // NOLINT: an attribute wants typedef

// Floating-point sums may not be reordered, so that the compiler can neither shorten the chains nor drop one: all of
// them go into the result, and factor, summand and start are known only at run time.
double run(const FmaWork& work, double start) {
  Lanes chains[registers];
  double first = start;
  for (Lanes& chain : chains)
    for (int i = 0; i < width; ++i) chain[i] = first++;
  const Lanes factor = Lanes{} + work.factor, summand = Lanes{} + work.summand;
  for (std::uint64_t round = 0; round < work.rounds; ++round)
#pragma GCC unroll 32
    for (int r = 0; r < registers; ++r) chains[r] = chains[r] * factor + summand;
  double sum = 0.0;
  for (const Lanes& chain : chains)
    for (int i = 0; i < width; ++i) sum += chain[i];
  return sum;
}

}  // namespace

#define ORISPLINE_TEXT_OF(name) #name
#define ORISPLINE_TEXT(name) ORISPLINE_TEXT_OF(name)
#define ORISPLINE_JOINED_OF(a, b) a##b
#define ORISPLINE_JOINED(a, b) ORISPLINE_JOINED_OF(a, b)

extern const FmaProbe ORISPLINE_JOINED(fma_, ORISPLINE_PROBE);
const FmaProbe ORISPLINE_JOINED(fma_, ORISPLINE_PROBE){ORISPLINE_TEXT(ORISPLINE_PROBE), width* registers, &run};

}  // namespace orispline::bench
