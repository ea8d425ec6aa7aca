// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "smooth/known_truth.hpp"
#include "support/places.hpp"

// What smoothing is held to: the noises and seeds of the cases, and which of them are judged.

namespace orispline::known_truth {

inline constexpr double allowed = 1.02;   // of the distance of the samples to the truth
inline constexpr double own_share = 3.0;  // the noise is at least so many times that of the recording itself
inline const std::string data = testing_support::beside_project("data");

inline bool sweeps() {
  const char* const asked = std::getenv("ORISPLINE_SWEEP");
  return asked && std::string_view(asked) == "all";
}

/// Per axis, in degrees.
inline std::vector<double> noises() { return sweeps() ? std::vector{0.03, 0.1, 0.3, 1.0, 3.0} : std::vector{0.1, 1.0}; }

/// How many of every case.
inline std::uint64_t seeds() { return sweeps() ? 5 : 1; }

/// Captures that jump by up to 13° for one sample and back, which no noise explains and no smooth motion does: as a
/// truth they hold the very faults that smoothing is to reject.
inline bool is_faulty(const Truth& truth) { return truth.name == "bvh/LeftHand" || truth.name == "bvh/RightHand"; }

/// Whether the noise is well above that of the truth itself, and the truth is a motion.
inline bool is_judged(const Truth& truth, double noise_deg) {
  return own_share * own_noise(truth.data) <= noise_deg * degree && !is_faulty(truth);
}

}  // namespace orispline::known_truth
