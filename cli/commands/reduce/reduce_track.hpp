// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/io/sample_columns.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/smooth/smooth.hpp>

#include "options/input_options.hpp"

namespace orispline::cli {

/// A recording as it was read, as it was checked, and as it is reduced.
struct ReducedTrack {
  io::TrackFile recording;
  Track reduced;  ///< smoothed where that was asked for
  std::optional<orispline::Smoothing> smoothing{};

  [[nodiscard]] const Keyframes& samples() const noexcept { return reduced.keys; }
};

/// Reads a recording, and smooths it where it is said how. Every error names the file.
[[nodiscard]] Expected<ReducedTrack> open_track(const InputRequest& input,
                                                const std::optional<orispline::SmoothOptions>& smoothing);

}  // namespace orispline::cli
