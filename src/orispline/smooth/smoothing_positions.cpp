// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_positions.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_search.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double rounding_of_doubles = 1e-14;  // of a sum of a few positions, relative to the largest component
constexpr double rounding_of_fits = 1e-11;     // relative to the extent
constexpr double shortest_length = 1e-30;      // [m], whose square is far from the smallest double

/// The largest component of a position as seen from the origin [m].
double extent_of(std::span<const Eigen::Vector3d> positions, const Eigen::Vector3d& origin) {
  double largest = 0.0;
  for (const Eigen::Vector3d& p : positions) largest = std::max(largest, (p - origin).lpNorm<Eigen::Infinity>());
  return largest;
}

/// σ per axis [m] between neighbours; 0 where positions lie on straight lines to rounding.
double local_noise_of(const Keyframes& recording) {
  const double size = extent_of(recording.positions(), Eigen::Vector3d::Zero());
  return local_noise(recording.times(), recording.positions(), std::max(shortest_length, rounding_of_doubles * size));
}

/// As they are, without noise that could be told.
SmoothedPositions as_recorded(const Keyframes& recording, const std::vector<Stretch>& stretches) {
  SmoothedPositions result;
  for (const auto& [first, count] : stretches) {
    const auto part = recording.positions().subspan(first, count);
    result.positions.insert(result.positions.end(), part.begin(), part.end());
  }
  return result;
}

/// In which positions are smoothed: from where they are seen, the unit [m], and what is rounding of the fit [m].
struct PositionScale {
  Eigen::Vector3d origin;
  double unit, resolution;
};

/// What a search found, in metres. Where there is no noise to take away, what is not rejected stays as it is.
SmoothedPositions in_metres(const SmoothingSearch& search, const Keyframes& recording,
                            const std::vector<Stretch>& stretches, const PositionScale& scale) {
  const SmoothingSearch::Finding& found = search.finding();
  SmoothedPositions result = as_recorded(recording, stretches);
  PositionSmoothing& finding = result.finding;
  finding.edge = found.edge;
  finding.criterion = found.criterion;
  finding.chosen_on = found.chosen_on;
  finding.rejected = found.rejected;
  finding.retained_outlier_runs = found.retained_outlier_runs;
  finding.noise = scale.unit * search.residual_noise();
  const bool noisy = found.edge != LambdaChoice::Edge::shortest && finding.noise > scale.resolution;
  if (noisy || !found.criterion) finding.smoothing_time = search.smoothing_time();
  auto next = result.positions.begin();
  for (std::size_t k = 0; k < stretches.size(); ++k)
    for (std::size_t i = 0; i < stretches[k].count; ++i, ++next)
      if (finding.smoothing_time || std::ranges::binary_search(finding.rejected, stretches[k].first + i))
        *next = scale.origin + scale.unit * search.fits().fits[k].nodes.positions[i];
  return result;
}

}  // namespace

Expected<SmoothedPositions> smooth_positions(const Keyframes& recording, const SmoothOptions& options,
                                             const std::vector<Stretch>& stretches, OpenEndedWork& work) {
  const double local = local_noise_of(recording);
  if (!(local > 0.0)) return as_recorded(recording, stretches);  // straight lines stay what they are
  PositionScale scale{.origin = recording.positions()[stretches.front().first], .unit = 1.0, .resolution = 0.0};
  scale.resolution = rounding_of_fits * extent_of(recording.positions(), scale.origin);
  scale.unit = options.position_noise.value_or(std::max(scale.resolution, local));
  const bool chosen = options.position_noise || !options.smoothing_time;
  const SearchPlan plan{.penalty = options.penalty,
                        .loss = options.loss,
                        .criterion = options.position_noise ? SmoothingCriterion::ubre : SmoothingCriterion::gcv,
                        .smoothing_time = chosen ? std::nullopt : options.smoothing_time,
                        .interval = median_interval(recording.times()),
                        .unit = " m",
                        .unit_size = scale.unit};
  SmoothingSearch search(position_problems_of(recording, stretches, scale.origin, scale.unit), stretches, plan, work);
  return search.run()
      .map([&] {
        SmoothedPositions result = in_metres(search, recording, stretches, scale);
        result.finding.local_noise = local;
        return result;
      })
      .map_error([](Error error) {
        if (error.code != ErrorCode::cancelled) error.message = formatted("positions: {}", error.message);
        return error;
      });
}

}}  // namespace orispline
