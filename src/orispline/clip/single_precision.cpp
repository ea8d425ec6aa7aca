// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/single_precision.hpp>

#include <algorithm>
#include <functional>
#include <utility>

#include <orispline/clip/finite_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

double as_float(double number) { return static_cast<double>(static_cast<float>(number)); }

Eigen::Quaterniond as_floats(const Eigen::Quaterniond& value) {
  return Eigen::Quaterniond(Eigen::Vector4d(value.coeffs().cast<float>().cast<double>()));
}
// By component: of value.cast<float>().cast<double>() GCC 12 at -O3 leaves x and y as they were.
Eigen::Vector3d as_floats(const Eigen::Vector3d& value) { return value.unaryExpr(&as_float); }

Eigen::Vector3d as_read(const Eigen::Vector3d& value) { return as_floats(value); }

/// Floats are not quite a unit quaternion, and that is not quite floats: a few rounds nearly always end where both are
/// the same.
Eigen::Quaterniond as_read(Eigen::Quaterniond value) {
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::Quaterniond read = as_floats(value).normalized();
    if (read.coeffs() == std::exchange(value, read).coeffs()) break;
  }
  return value;
}

}  // namespace

template <CurvePoint P>
std::optional<Channel<P>> held_in_single_precision(Channel<P> channel) {
  std::vector<double> times = channel.times;
  std::ranges::transform(times, times.begin(), as_float);
  if (std::ranges::adjacent_find(times, std::greater_equal()) != times.end()) return std::nullopt;
  channel.times = std::move(times);
  for (auto* const tangents : {&channel.in_tangents, &channel.out_tangents})
    for (P& tangent : *tangents) tangent = as_floats(tangent);
  for (P& value : channel.values) value = as_read(value);
  return is_finite(channel) ? std::optional(std::move(channel)) : std::nullopt;
}

template std::optional<RotationChannel> held_in_single_precision(RotationChannel);
template std::optional<VectorChannel> held_in_single_precision(VectorChannel);

}}  // namespace orispline
