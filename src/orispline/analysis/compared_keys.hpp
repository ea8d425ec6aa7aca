// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/analysis/decimation.hpp>
#include <orispline/analysis/measure_info.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A method by the name that its user gives it, on one of several sets of keys.
struct ComparedMethod {
  std::string label;
  std::size_t key_set = 0;
  Candidate candidate;
  Expected<Measures> measures{};  ///< or why there are none
};

/// Puts the best method first in each set of keys, what failed last; those of which nothing can be said before them.
ORISPLINE_EXPORT void sort_by(const MeasureInfo& measure, std::vector<ComparedMethod>& methods,
                              const MeasureTimes& times);

/// One set of keys that every method is given.
struct ComparedKeys {
  std::optional<Decimation> decimation{};  ///< absent: nothing was left out
  Track track{};
  std::size_t compared = 0;          ///< samples of the recording between the first and the last key
  std::vector<Stretch> stretches{};  ///< of these keys, where gaps are stated
};

/// What is compared with what.
struct ORISPLINE_EXPORT ComparedData {
  std::string reference{};      ///< name of the recording
  Decimal epoch{};              ///< of all times [s]
  Keyframes samples{};          ///< of the recording
  std::vector<double> times{};  ///< of the recording, from the epoch [s]
  std::vector<ComparedKeys> key_sets{};
  std::vector<Warning> warnings{};  ///< `no_reference_between_keys`

  [[nodiscard]] RecordedMotion recording() const {
    return {times, samples.orientations(), samples.angular_velocities()};
  }
  [[nodiscard]] MeasureTimes measure_times() const { return {epoch, times}; }
  /// The measures that there are: of rates where they are logged, of torques where the inertia is known.
  [[nodiscard]] std::vector<MeasureInfo> measures(LeaveOut leave_out,
                                                  const std::optional<Eigen::Matrix3d>& inertia) const;
};

/// A recording beside some of its own samples. Errors: bad_data where fewer than two of them would be keys.
[[nodiscard]] ORISPLINE_EXPORT Expected<ComparedData> beside_own_samples(const Track& recording,
                                                                         std::span<const Decimation> decimations);

/// Keys beside a denser recording. Errors: bad_data for fewer than two keys or samples, and where no time of the
/// recording lies between the keys.
[[nodiscard]] ORISPLINE_EXPORT Expected<ComparedData> beside_recording(const Track& keys, const Track& recording);

}}  // namespace orispline
