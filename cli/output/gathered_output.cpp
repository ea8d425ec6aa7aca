// SPDX-License-Identifier: Apache-2.0
#include "output/gathered_output.hpp"

namespace orispline::cli {
namespace {

thread_local Gathered* here = nullptr;

}  // namespace

GatheringHere::GatheringHere(Gathered& gathered) noexcept { here = &gathered; }

GatheringHere::~GatheringHere() { here = nullptr; }

Gathered* gathered_here() noexcept { return here; }

}  // namespace orispline::cli
