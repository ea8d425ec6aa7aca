// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <random>
#include <workload/keys.hpp>
#include <workload/track.hpp>

namespace orispline::bench {

namespace {

/// The same numbers with every standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(engine_() >> 11U);
  }
  [[nodiscard]] Eigen::Vector3d axis() {
    const double z = between(-1.0, 1.0), turn = between(0.0, 2.0 * std::numbers::pi), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace

Track random_track(std::size_t keys, std::uint64_t seed) {
  Dice dice(seed);
  Track track;
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  double t = 0.0;
  for (std::size_t i = 0; i < keys; ++i) {
    track.times.push_back(t);
    track.orientations.insert(track.orientations.end(), q.coeffs().begin(), q.coeffs().end());
    track.tensions.push_back(dice.between(0.35, 0.65));
    t += dice.between(0.6, 1.4);
    q = (q * Eigen::AngleAxisd(2.0 * dice.between(0.05, 1.2), dice.axis())).normalized();
  }
  return normalised(track);
}

std::vector<double> EvenTimes::all() const {
  std::vector<double> times(count);
  for (std::size_t k = 0; k < count; ++k) times[k] = (*this)[k];
  return times;
}

EvenTimes even_times(const Track& track, std::size_t count) {
  const double almost = 1.0 - 1e-12;  // so that rounding does not carry the last sample past the end
  return {track.times.front(), almost * track.duration() / static_cast<double>(count - 1), count};
}

std::vector<double> random_times(const Track& track, std::size_t count, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<double> times(count);
  for (double& t : times) t = dice.between(track.times.front(), track.times.back());
  return times;
}

}  // namespace orispline::bench
