// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/analysis/measure_info.hpp>
#include <orispline/io/track_file.hpp>

#include "commands/compare/compare_request.hpp"

namespace orispline::cli {

/// One set of keys that every method is given.
struct ComparedKeys {
  std::optional<Decimation> decimation;  ///< absent: the keys are INPUT itself
  Track track;
  std::size_t compared = 0;  ///< samples of the recording between the first and the last key
};

/// What is compared with what.
struct ComparedData {
  std::string reference;      ///< path of the recording
  Decimal epoch;              ///< of all times [s]
  Keyframes samples;          ///< of the recording
  std::vector<double> times;  ///< of the recording, from the epoch [s]
  std::vector<ComparedKeys> key_sets;
  io::RepairReport repairs;

  [[nodiscard]] RecordedMotion recording() const {
    return {times, samples.orientations(), samples.angular_velocities()};
  }
  [[nodiscard]] MeasureTimes measure_times() const { return {epoch, times}; }
};

/// Reads the recording and the keys. Errors: those of reading; bad_data for fewer than two keys and for a reference
/// that does not overlap them.
[[nodiscard]] Expected<ComparedData> compared_data(const CompareRequest& request,
                                                   const std::optional<std::string>& reference);

}  // namespace orispline::cli
