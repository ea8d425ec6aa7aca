// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/tolerance_check.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <orispline/analysis/sampled.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

double per_square(double bound) { return 1.0 / (bound * bound); }

}  // namespace

ToleranceCheck::ToleranceCheck(const Keyframes& samples, Tolerance tolerance, OpenEndedWork& work)
    : samples_(samples),
      tolerance_(tolerance),
      per_square_sine_(tolerance.angle < std::numbers::pi
                           ? per_square(elementary::sine_cosine(0.5 * (tolerance.angle - angle_rounding)).sine)
                           : 0.0),
      per_square_distance_(tolerance.bounds_positions() ? per_square(tolerance.position) : 0.0),
      work_(work) {}

bool ToleranceCheck::bounds_positions() const noexcept { return has_positions() && tolerance_.bounds_positions(); }

double ToleranceCheck::excess(std::size_t sample, const Eigen::Quaterniond& orientation) const noexcept {
  return (orientation.conjugate() * samples_.orientations()[sample]).vec().squaredNorm() * per_square_sine_;
}

double ToleranceCheck::excess(std::size_t sample, const Eigen::Vector3d& position) const noexcept {
  return (position - samples_.positions()[sample]).squaredNorm() * per_square_distance_;
}

KeySet ToleranceCheck::keys_at(std::vector<std::size_t> samples) const {
  KeySet keys{.samples = std::move(samples), .orientations = {}};
  for (const std::size_t i : keys.samples) {
    keys.orientations.push_back(samples_.orientations()[i]);
    if (has_positions()) keys.positions.push_back(samples_.positions()[i]);
  }
  return keys;
}

Expected<Keyframes> ToleranceCheck::keyframes(const KeySet& keys) const {
  KeyframeData data{
      .orientations = keys.orientations, .positions = keys.positions, .angular_velocities = keys.angular_velocities};
  for (const std::size_t i : keys.samples) data.times.push_back(samples_.times()[i]);
  return Keyframes::make(std::move(data), Signs::shortest);
}

Expected<PoseCurve> ToleranceCheck::curve(const Method& method, const KeySet& keys) const {
  if (stopped()) return cancellation();
  work_.add(1.0);
  return keyframes(keys).and_then([&](const Keyframes& k) {
    if (method.options.parameters.empty()) return make_pose_curve(method, k);
    return make_pose_curve(method.at(keys.samples, size()), k);
  });
}

Expected<std::vector<WorstSample>> ToleranceCheck::worst_samples(const Method& method, const KeySet& keys) const {
  const auto curve = this->curve(method, keys);
  if (!curve) return tl::unexpected(curve.error());
  const SampledCurve at = sampled(curve->orientation, samples_.times(), Sampled::orientations);
  std::vector<WorstSample> worst(keys.size() - 1);
  for (std::size_t s = 0; s < worst.size(); ++s)
    for (std::size_t i = keys.samples[s]; i <= keys.samples[s + 1]; ++i) {
      double found = excess(i, at.orientations[i]);
      if (bounds_positions()) found = std::max(found, excess(i, curve->position->position_on(s, samples_.times()[i])));
      if (found > worst[s].excess) worst[s] = {found, i};
    }
  return worst;
}

Expected<std::vector<Miss>> ToleranceCheck::misses(const Method& method, const KeySet& keys) const {
  const auto curve = this->curve(method, keys);
  if (!curve) return tl::unexpected(curve.error());
  const SampledCurve at = sampled(curve->orientation, samples_.times(), Sampled::orientations);
  std::vector<Miss> misses;
  misses.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) {
    Eigen::Quaterniond sample = samples_.orientations()[i];
    if (sample.dot(at.orientations[i]) < 0.0) sample.coeffs() = -sample.coeffs();
    Miss& miss = misses.emplace_back(Miss{log<double>(sample * at.orientations[i].conjugate()), Eigen::Vector3d::Zero(),
                                          excess(i, at.orientations[i])});
    if (!has_positions()) continue;
    const Eigen::Vector3d position = curve->position->linear_motion(samples_.times()[i]).position;
    miss.shift = samples_.positions()[i] - position;
    miss.excess = std::max(miss.excess, excess(i, position));
  }
  return misses;
}

std::vector<WorstSample> worst_of_segments(const KeySet& keys, const std::vector<Miss>& misses) {
  std::vector<WorstSample> worst(keys.size() - 1);
  for (std::size_t s = 0; s < worst.size(); ++s)
    for (std::size_t i = keys.samples[s]; i <= keys.samples[s + 1]; ++i)
      if (misses[i].excess > worst[s].excess) worst[s] = {misses[i].excess, i};
  return worst;
}

Expected<Deviation> ToleranceCheck::deviation(const Method& method, const Keyframes& keys) const {
  return make_pose_curve(method, keys).map([&](const PoseCurve& curve) {
    Deviation worst;
    if (has_positions()) worst.position = 0.0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double t = samples_.times()[i];
      const double angle = angular_distance(curve.orientation(t), samples_.orientations()[i]);
      if (angle > worst.angle) worst.angle = angle, worst.angle_at = i;
      if (!has_positions()) continue;
      const double distance = (curve.position->linear_motion(t).position - samples_.positions()[i]).norm();
      if (distance > *worst.position) worst.position = distance, worst.position_at = i;
    }
    return worst;
  });
}

}}  // namespace orispline
