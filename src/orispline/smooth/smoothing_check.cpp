// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_check.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/free_rate.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smooth_fields.hpp>
#include <orispline/smooth/smoothing_stretches.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Below them the samples are joined as they are; above, a steady rotation is left or rounding decides.
Interval smoothing_times(const Keyframes& recording, Penalty penalty) {
  const double interval = median_interval(recording.times()),
               span = recording.times().back() - recording.times().front();
  const double longest = penalty == Penalty::jerk ? 5e3 : 1e6;  // in intervals: condition numbers of 1e12
  return {1e-3 * interval, std::min(10.0 * span, longest * interval)};
}

}  // namespace

Expected<void> check(const SmoothOptions& options) {
  if (auto checked = check_ranges(options); !checked) return checked;
  if (options.noise && options.smoothing_time)
    return bad_option("noise", "wanted no `smoothing_time` as well: each determines how smooth");
  if (options.gyro_noise && !options.gyro) return bad_option("gyro_noise", "wanted `gyro` as well");
  if (options.gyro && options.gap) return bad_option("gap", "wanted no `gyro`, which bridges gaps");
  return {};
}

Expected<void> check_recording(const Keyframes& recording, const SmoothOptions& options) {
  if (auto checked = check(options); !checked) return checked;
  if (options.smoothing_time && recording.size() > 1) {
    const Interval range = smoothing_times(recording, options.penalty);
    if (!range.contains(*options.smoothing_time))
      return bad_option("smoothing_time", formatted("found {:.6g} s, wanted {}", *options.smoothing_time,
                                                    text_of(range, &quantities::time)));
  }
  if (options.gyro && recording.angular_velocities().empty())
    return failure(ErrorCode::bad_data, "found no angular velocities of the body, wanted wx,wy,wz of the gyro");
  if (options.gyro)
    if (const auto free = std::ranges::find_if(recording.angular_velocities(), is_free);
        free != recording.angular_velocities().end())
      return failure(ErrorCode::bad_data, "the angular velocity is left free, wanted that of the gyro at every sample",
                     {.key = static_cast<std::size_t>(free - recording.angular_velocities().begin())});
  if (options.position_noise && recording.positions().empty())
    return failure(ErrorCode::bad_data, "found no positions, wanted px,py,pz for `position_noise`");
  return {};
}

}}  // namespace orispline
