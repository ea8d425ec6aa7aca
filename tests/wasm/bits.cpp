// SPDX-License-Identifier: Apache-2.0
// Says whether the samples of all methods have the bits that are written, and which numbers they have come to.
#include <cinttypes>
#include <cstdio>

#include <batch/bits_of_samples.hpp>

namespace {

using orispline::testing_support::bits_of_samples;
using orispline::testing_support::BitsOfSamples;
using orispline::testing_support::written_bits;

bool is_as_written(const char* what, std::uint64_t found, std::uint64_t wanted) {
  std::printf("%s: found %016" PRIx64 ", wanted %016" PRIx64 "\n", what, found, wanted);
  return found == wanted;
}

}  // namespace

int main() {
  const BitsOfSamples found = bits_of_samples(
      [](const std::string& name, std::uint64_t hash) { std::printf("%s: %016" PRIx64 "\n", name.c_str(), hash); });
  const bool all[] = {is_as_written("local samples", found.local_samples, written_bits.local_samples),
                      is_as_written("local jerks", found.local_jerks, written_bits.local_jerks),
                      is_as_written("solved samples", found.solved_samples, written_bits.solved_samples),
                      is_as_written("solved jerks", found.solved_jerks, written_bits.solved_jerks),
                      is_as_written("samples of paths", found.path_samples, written_bits.path_samples),
                      is_as_written("rates of paths", found.path_rates, written_bits.path_rates)};
  for (const bool is_right : all)
    if (!is_right) return 1;
  return 0;
}
