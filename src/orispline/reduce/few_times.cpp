// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/few_times.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include <orispline/clip/compressed_bytes.hpp>
#include <orispline/math/number.hpp>
#include <orispline/reduce/clip_bytes.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t farthest_reach = 64;  // keys; more save little, and are long to look at

/// From one key to another, at shares of the time between them.
class Geodesic {
 public:
  Geodesic(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) : from_(from), to_(to) {
    const double cosine = from.dot(to);
    if (cosine < 0.0) to_.coeffs() = -to_.coeffs();
    const double half_chord = 0.5 * (from_.coeffs() - to_.coeffs()).norm();
    angle_ = 2.0 * elementary::arctangent(half_chord, std::sqrt(std::max(0.0, 1.0 - half_chord * half_chord)));
    sine_ = elementary::sine_cosine(angle_).sine;
  }
  /// The angle from there [rad].
  [[nodiscard]] double distance(double share, const Eigen::Quaterniond& rotation) const {
    const bool is_straight = angle_ < 1e-6;
    const double a = is_straight ? 1.0 - share : elementary::sine_cosine((1.0 - share) * angle_).sine / sine_;
    const double b = is_straight ? share : elementary::sine_cosine(share * angle_).sine / sine_;
    const Eigen::Vector4d point = a * from_.coeffs() + b * to_.coeffs();
    const double chord =
        std::sqrt(std::min((point - rotation.coeffs()).squaredNorm(), (point + rotation.coeffs()).squaredNorm()));
    return 2.0 * chord;  // of the small angles that count here
  }

 private:
  Eigen::Quaterniond from_, to_;
  double angle_ = 0.0, sine_ = 0.0;
};

class Line {
 public:
  Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) : from_(from), to_(to) {}
  [[nodiscard]] double distance(double share, const Eigen::Vector3d& place) const {
    return (from_ + share * (to_ - from_) - place).norm();
  }

 private:
  Eigen::Vector3d from_, to_;
};

template <CurvePoint P>
using Straight = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, Geodesic, Line>;

/// The keys from the first to the last, each as far as all of these reach.
std::vector<std::size_t> chain_of(const std::vector<std::size_t>& last) {
  std::vector<std::size_t> keys{0};
  while (keys.back() + 1 < last.size()) keys.push_back(last[keys.back()]);
  return keys;
}

}  // namespace

template <CurvePoint P>
KeyReach reach_of(const Channel<P>& rounded, const ChannelCurve<P>& motion, double tolerance) {
  const SharedList<double>& times = rounded.times;
  const SharedList<P>& values = rounded.values;
  const std::size_t n = rounded.size();
  std::vector<P> there;
  for (const double t : times) there.push_back(motion.at(t));
  const auto holds = [&](std::size_t i, std::size_t j) {
    const Straight<P> straight(values[i], values[j]);
    for (std::size_t k = i + 1; k < j; ++k)
      if (straight.distance((times[k] - times[i]) / (times[j] - times[i]), there[k]) > tolerance) return false;
    return true;
  };
  KeyReach reach{.bytes_of_key = static_cast<double>(compressed_bytes(rounded)) / static_cast<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t j = std::min(i + 1, n - 1);
    while (j + 1 < n && j + 1 - i <= farthest_reach && holds(i, j + 1)) ++j;
    reach.last.push_back(j);
  }
  return reach;
}

template KeyReach reach_of(const RotationChannel&, const ChannelCurve<Eigen::Quaterniond>&, double);
template KeyReach reach_of(const VectorChannel&, const ChannelCurve<Eigen::Vector3d>&, double);

std::vector<std::vector<std::size_t>> keys_at_few_times(const std::vector<KeyReach>& channels) {
  const std::size_t count = channels.size();
  std::vector<std::size_t> row(count);
  std::iota(row.begin(), row.end(), std::size_t{0});
  std::vector<std::size_t> alone;
  for (const KeyReach& channel : channels) alone.push_back(chain_of(channel.last).size());
  std::ranges::stable_sort(row, {}, [&](std::size_t i) { return alone[i]; });
  constexpr double bytes_of_time = 3.0;
  constexpr double bytes_of_step = 3.0 / 8.0;  // steps twice as wide take a bit more of each of three numbers
  std::vector<double> least(count + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> begin_of(count + 1, 0);
  least[0] = 0.0;
  for (std::size_t a = 0; a < count; ++a) {
    std::vector<std::size_t> last = channels[row[a]].last;
    double of_key = bytes_of_time;
    for (std::size_t b = a; b < count; ++b) {
      const KeyReach& channel = channels[row[b]];
      for (std::size_t i = 0; i < last.size(); ++i) last[i] = std::min(last[i], channel.last[i]);
      of_key += channel.bytes_of_key;
      const std::size_t keys = chain_of(last).size();
      const auto bits = static_cast<double>(std::bit_width(last.size() / keys) - 1);
      const double of_step = bytes_of_step * static_cast<double>(b + 1 - a) * bits;
      const double bytes = least[a] + text_of_times + (of_key + of_step) * static_cast<double>(keys);
      if (bytes < least[b + 1]) least[b + 1] = bytes, begin_of[b + 1] = a;
    }
  }
  std::vector<std::vector<std::size_t>> keys(count);
  for (std::size_t end = count; end > 0; end = begin_of[end]) {
    std::vector<std::size_t> last = channels[row[begin_of[end]]].last;
    for (std::size_t b = begin_of[end]; b < end; ++b)
      for (std::size_t i = 0; i < last.size(); ++i) last[i] = std::min(last[i], channels[row[b]].last[i]);
    for (std::size_t b = begin_of[end]; b < end; ++b) keys[row[b]] = chain_of(last);
  }
  return keys;
}

}}  // namespace orispline
