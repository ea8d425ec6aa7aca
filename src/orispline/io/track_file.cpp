// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/track_file.hpp>

#include <cmath>
#include <utility>

namespace orispline::io {
namespace {

constexpr double rounding = 1e-15;  // of the components of a unit quaternion

}  // namespace

Eigen::Quaterniond TrackFile::written(const Eigen::Quaterniond& key, std::size_t index) const {
  const double sign = as_read[index].dot(key) < 0.0 ? -1.0 : 1.0;
  const Eigen::Quaterniond turned(sign * as_read[index].coeffs());
  const bool is_the_same = std::abs(turned.norm() - 1.0) <= unit_norm_tolerance &&
                           (turned.coeffs().normalized() - key.coeffs()).norm() <= rounding;
  return is_the_same ? turned : key;
}

TrackFile track_file(KeyFile file, Keyframes keys) {
  TrackFile found{.as_read = std::move(file.data.orientations),
                  .format = file.format,
                  .repairs = file.repairs,
                  .table = std::move(file.table),
                  .ignored_columns = std::move(file.ignored_columns),
                  .rates_of_unknown_frame = std::move(file.rates_of_unknown_frame)};
  Track& track = found.track;
  track.keys = std::move(keys);
  track.name = std::move(file.path);
  track.epoch = file.epoch;
  track.lines = std::move(file.lines);
  track.exact_times = std::move(file.exact_times);
  track.settings = std::move(file.parameters);
  return found;
}

Expected<TrackFile> read_track(const std::string& path, const ReadOptions& options, Signs signs) {
  return read_keys(path, options).and_then([&](KeyFile file) -> Expected<TrackFile> {
    KeyframeData data = std::exchange(file.data, {});
    if (options.keep_as_read) file.data.orientations = data.orientations;
    auto keys = Keyframes::make(std::move(data), signs);
    if (!keys) return tl::unexpected(located(file, std::move(keys.error())));
    return track_file(std::move(file), std::move(*keys));
  });
}

}  // namespace orispline::io
