// SPDX-License-Identifier: Apache-2.0
#include "output/gathered_output.hpp"

namespace orispline::cli {

namespace {

thread_local Gathered* here = nullptr;
thread_local std::vector<Warning> warned;

}  // namespace

GatheringHere::GatheringHere(Gathered& gathered) noexcept {
  here = &gathered;
  warned.clear();
}

GatheringHere::~GatheringHere() { here = nullptr; }

Gathered* gathered_here() noexcept { return here; }

std::vector<Warning>& warned_here() noexcept { return warned; }

}  // namespace orispline::cli
