// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/leave_out.hpp>

#include <orispline/analysis/decimation.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t phases = 4;

/// The keys but every 4th of the inner ones, and those.
struct Parted {
  KeyframeData kept;
  std::vector<std::size_t> left_out;
};

Parted parted(const Keyframes& keys, std::size_t phase) {
  const auto copy = [](const auto& span) { return std::vector(span.begin(), span.end()); };
  const KeyframeData all{.times = copy(keys.times()),
                         .orientations = copy(keys.orientations()),
                         .angular_velocities = copy(keys.angular_velocities()),
                         .angular_accelerations = copy(keys.angular_accelerations()),
                         .angular_jerks = copy(keys.angular_jerks())};
  std::vector<std::size_t> kept, left_out;
  for (std::size_t i = 0; i < keys.size(); ++i)
    (i > 0 && i + 1 < keys.size() && i % phases == phase ? left_out : kept).push_back(i);
  return {kept_keys(all, kept), std::move(left_out)};
}

}  // namespace

Expected<DistanceStatistics> leave_out_error(const Keyframes& keys, const Method& method) {
  if (keys.size() < 3)
    return failure(ErrorCode::bad_data, formatted("found {} keys, wanted 3 to leave one out", keys.size()));
  std::vector<double> distances(keys.size() - 2);
  for (std::size_t phase = 0; phase < phases; ++phase) {
    const Parted parts = parted(keys, phase);
    if (parts.left_out.empty()) continue;
    const auto curve = Keyframes::make(parts.kept, Signs::as_given).and_then([&](const Keyframes& kept) {
      return make_curve(method, kept);
    });
    if (!curve) return tl::unexpected(curve.error());
    for (const std::size_t i : parts.left_out)
      distances[i - 1] = angular_distance((*curve)(keys.times()[i]), keys.orientations()[i]);
  }
  return distance_statistics(std::move(distances), 1);
}

}}  // namespace orispline
