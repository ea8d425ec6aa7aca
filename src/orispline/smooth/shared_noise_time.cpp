// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/shared_noise_time.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <orispline/base/parallel.hpp>
#include <orispline/curve/stretches.hpp>
#include <orispline/math/chain_elimination.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/number.hpp>
#include <orispline/math/scalar_link.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using elementary::exponential, elementary::natural_logarithm;

constexpr std::size_t fewest_tracks = 6, share_of_tracks = 3, most_tracks = 8, most_samples = 1000;
constexpr double white_share = 0.03;    // of σ, for the condition of the fit
constexpr double price = 0.12;          // of each value: that of a recorded motion without noise may gain 0.11
constexpr double nearly_as_well = 0.9;  // of the gain over white noise
constexpr std::array relative_times{0.0, 1.2, 1.7, 2.4, 3.4, 4.8, 6.8, 9.6, 13.6, 19.2, 27.0, 38.0};  // in intervals
constexpr double first_lambda = 0.01, last_lambda = 1e8, lambda_ratio = 4.0;                          // in intervals³
using Evidence = std::array<double, relative_times.size()>;

/// The way of a track, the sum of its turns, about which its noise is what it is about the orientations.
struct Way {
  std::vector<double> times{};  // in intervals
  std::vector<Eigen::Vector3d> places{};
};

/// The middle of a track, which is all that is looked at.
Stretch middle_of(const Keyframes& track) {
  const std::size_t count = std::min(track.size(), most_samples);
  return {(track.size() - count) / 2, count};
}

Way way_of(const Keyframes& track) {
  const auto [first, count] = middle_of(track);
  const double interval = median_interval(track.times());
  Way way;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i < first + count; ++i) {
    if (i > first) place += shortest_increment(track.orientations()[i - 1], track.orientations()[i]);
    way.times.push_back(track.times()[i] / interval);
    way.places.push_back(place);
  }
  return way;
}

/// -2 log of the restricted likelihood, but for a constant, of a motion with this weight of its penalty beside noise of
/// any size that correlates within `time`.
double evidence(const Way& way, double time, double lambda) {
  using Chain = ChainElimination<3, 2, 3>;  // value, rate and noise; the three axes are right-hand sides
  Chain chain;
  const std::size_t count = way.times.size();
  chain.start(count);
  double squares = 0.0, logarithms = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    Chain::Low low = Chain::Low::Zero();
    low(0, 0) = low(0, 2) = 1.0 / white_share;
    low.block<1, 3>(0, 6) = way.places[i].transpose() / white_share;
    if (i == 0) low(1, 2) = 1.0;
    if (i + 1 < count) {
      const double duration = way.times[i + 1] - way.times[i];
      const Eigen::Matrix<double, 2, 4> link = std::sqrt(lambda) * scalar_link<2>(duration);
      low.block<2, 2>(2, 0) = link.leftCols<2>();
      low.block<2, 2>(2, 3) = link.rightCols<2>();
      const double kept = time > 0.0 ? exponential(-duration / time) : 0.0, fresh = 1.0 - kept * kept;
      low(4, 2) = -kept / std::sqrt(fresh);
      low(4, 5) = 1.0 / std::sqrt(fresh);
      logarithms += natural_logarithm(fresh) - 2.0 * natural_logarithm(lambda);
    }
    squares += chain.add(low).squaredNorm();
  }
  const double freedom = 3.0 * (static_cast<double>(count) - 2.0);
  return 3.0 * (chain.log_determinant() + logarithms) + freedom * natural_logarithm(squares / freedom);
}

/// With the penalty that explains it best at each time, for each value.
Evidence evidences(const Way& way) {
  Evidence all{};
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k] = std::numeric_limits<double>::infinity();
    for (double lambda = first_lambda; lambda < last_lambda; lambda *= lambda_ratio)
      all[k] = std::min(all[k], evidence(way, relative_times[k], lambda));
    all[k] /= 3.0 * static_cast<double>(way.times.size());
  }
  return all;
}

/// Not of a track that rests there or is drawn.
bool shows_noise(const Keyframes& track) {
  const auto [first, count] = middle_of(track);
  return local_noise(track.times().subspan(first, count), track.orientations().subspan(first, count)) > 0.0;
}

/// The quietest third of the tracks that show noise.
std::vector<const Keyframes*> quietest(std::span<const Keyframes> tracks) {
  std::vector<std::pair<double, std::size_t>> noises;
  for (std::size_t i = 0; i < tracks.size(); ++i)
    if (shows_noise(tracks[i])) noises.emplace_back(local_noise(tracks[i].times(), tracks[i].orientations()), i);
  std::ranges::sort(noises);
  noises.resize(noises.size() < fewest_tracks ? 0 : std::min(most_tracks, noises.size() / share_of_tracks));
  std::vector<const Keyframes*> quiet;
  for (const auto& [noise, i] : noises) quiet.push_back(&tracks[i]);
  return quiet;
}

}  // namespace

std::optional<double> shared_noise_time(std::span<const Keyframes> tracks, unsigned threads) {
  const std::vector<const Keyframes*> quiet = quietest(tracks);
  if (quiet.empty()) return std::nullopt;
  std::vector<Evidence> each(quiet.size());
  parallel_for(quiet.size(), threads, [&](std::size_t i) { each[i] = evidences(way_of(*quiet[i])); });
  Evidence all{};
  std::vector<double> intervals;
  for (std::size_t i = 0; i < quiet.size(); ++i) {
    for (std::size_t k = 0; k < all.size(); ++k) all[k] += each[i][k] / static_cast<double>(quiet.size());
    intervals.push_back(median_interval(quiet[i]->times()));
  }
  const double gain = all.front() - std::ranges::min(all);
  if (!(gain > price)) return std::nullopt;
  const double enough = all.front() - nearly_as_well * gain;
  const auto shortest = std::ranges::find_if(all, [enough](double value) { return value <= enough; });
  return relative_times[static_cast<std::size_t>(shortest - all.begin())] * median(std::move(intervals));
}

}}  // namespace orispline
