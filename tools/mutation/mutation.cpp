// SPDX-License-Identifier: Apache-2.0
// The mutant that a program runs with, and the record of those that it came by.
#include <cstdio>
#include <cstdlib>
#include <string>

#include <unistd.h>

namespace orispline_mutation {

int chosen = -1;
bool is_recording = false;
unsigned char reached[1U << 16];

namespace {

struct Trial {
  Trial() {
    if (const char* id = std::getenv("ORISPLINE_MUTANT")) chosen = std::atoi(id);
    is_recording = std::getenv("ORISPLINE_MUTANTS_REACHED") != nullptr;
  }
  ~Trial() {
    if (!is_recording) return;
    const std::string path = std::string(std::getenv("ORISPLINE_MUTANTS_REACHED")) + "/" + std::to_string(getpid());
    if (std::FILE* file = std::fopen(path.c_str(), "wb")) {
      std::fwrite(reached, 1, sizeof reached, file);
      std::fclose(file);
    }
  }
};

// Before all other variables, some of which are mutated themselves.
[[gnu::init_priority(101)]] const Trial trial;

}  // namespace

bool is_at_start(int id) { return is(id); }

}  // namespace orispline_mutation
