// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/hermite_channel.hpp>

#include <optional>
#include <utility>

#include <orispline/clip/cubic_channel.hpp>
#include <orispline/families/hermite.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Of the tolerance, for the keys of rotations; the rest is for the cubics.
constexpr double share_of_rates = 0.88;

Eigen::Vector3d rate_between(const CubicTargets<Eigen::Quaterniond>& targets, std::size_t i) {
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(targets.points[i]).conjugate() * Eigen::Quaterniond(targets.points[i + 1]);
  return log<double>(turn) / (targets.times[i + 1] - targets.times[i]);
}
Eigen::Vector3d rate_between(const CubicTargets<Eigen::Vector3d>& targets, std::size_t i) {
  return (targets.points[i + 1] - targets.points[i]) / (targets.times[i + 1] - targets.times[i]);
}

Expected<RotationChannel> channel_of(const CubicSamples<Eigen::Quaterniond>& samples, HermiteKeys found,
                                     double tolerance, const Method& method) {
  KeyframeData data{.angular_velocities = std::move(found.rates)};
  for (const std::size_t sample : found.samples) {
    data.times.push_back(samples.targets.times[sample * samples.stride]);
    data.orientations.emplace_back(samples.targets.points[sample * samples.stride]);
  }
  return Keyframes::make(std::move(data))
      .and_then([&](const Keyframes& keys) { return make_curve(method, keys); })
      .map([&](const AnyCurve& curve) { return cubic_channel(curve, (1.0 - share_of_rates) * tolerance).channel; });
}

Expected<VectorChannel> channel_of(const CubicSamples<Eigen::Vector3d>& samples, HermiteKeys found, double,
                                   const Method&) {
  VectorChannel channel{.interpolation = ChannelInterpolation::cubicspline};
  for (const std::size_t sample : found.samples) {
    channel.times.push_back(samples.targets.times[sample * samples.stride]);
    channel.values.push_back(samples.targets.points[sample * samples.stride]);
  }
  channel.in_tangents = channel.out_tangents = std::move(found.rates);
  return channel;
}

}  // namespace

bool seeks_rates(const Method& method) {
  if (method.name != families::HermiteC1::info.name) return false;
  const auto form = method.options.choices.find("form");
  return form == method.options.choices.end() || form->second == families::HermiteC1::forms.front();
}

template <CurvePoint P>
Eigen::Vector3d rate_at_seam(const CubicTargets<P>& targets) {
  return 0.5 * (rate_between(targets, 0) + rate_between(targets, targets.times.size() - 2));
}

template <CurvePoint P>
Expected<Channel<P>> hermite_channel(const CubicSamples<P>& samples, double tolerance, const Method& method,
                                     bool closed) {
  const double of_keys = std::same_as<P, Eigen::Quaterniond> ? share_of_rates * tolerance : tolerance;
  const auto seam = closed ? std::optional(rate_at_seam(samples.targets)) : std::nullopt;
  return channel_of(samples, fewest_hermite_keys(samples, of_keys, seam), tolerance, method);
}

template Eigen::Vector3d rate_at_seam(const CubicTargets<Eigen::Quaterniond>&);
template Eigen::Vector3d rate_at_seam(const CubicTargets<Eigen::Vector3d>&);
template Expected<Channel<Eigen::Quaterniond>> hermite_channel(const CubicSamples<Eigen::Quaterniond>&, double,
                                                               const Method&, bool);
template Expected<Channel<Eigen::Vector3d>> hermite_channel(const CubicSamples<Eigen::Vector3d>&, double, const Method&,
                                                            bool);

}}  // namespace orispline
