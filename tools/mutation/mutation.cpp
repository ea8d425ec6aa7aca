// SPDX-License-Identifier: Apache-2.0
// The mutant that a program runs with, and the record of those that it came by.
#include <cstdio>
#include <cstdlib>
#include <string>

#include <unistd.h>

namespace orispline_mutation {

extern const int chosen;
extern const bool is_recording;
extern unsigned char reached[1U << 16];

// Before all other variables, some of which are mutated themselves.
[[gnu::init_priority(101)]] const int chosen = std::getenv("ORISPLINE_MUTANT") ? std::atoi(std::getenv("ORISPLINE_MUTANT")) : -1;
[[gnu::init_priority(101)]] const bool is_recording = std::getenv("ORISPLINE_MUTANTS_REACHED") != nullptr;
unsigned char reached[1U << 16];

struct Record {
  ~Record() {
    if (!is_recording) return;
    const std::string path = std::string(std::getenv("ORISPLINE_MUTANTS_REACHED")) + "/" + std::to_string(getpid());
    if (std::FILE* file = std::fopen(path.c_str(), "wb")) {
      std::fwrite(reached, 1, sizeof reached, file);
      std::fclose(file);
    }
  }
};
[[gnu::init_priority(101)]] const Record record;

}  // namespace orispline_mutation
