// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/bits_of_file.hpp>

#include <algorithm>
#include <cstddef>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// 1 where two quaternions are the same to the rounding of single precision, -1 where the other one's opposite is.
double same_sign(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double sign = a.dot(b) < 0.0 ? -1.0 : 1.0;
  const double off = (a.coeffs() - sign * b.coeffs()).cwiseAbs().maxCoeff();
  constexpr double rounding = 0x1p-23;
  return off <= rounding ? sign : 0.0;
}

}  // namespace

RotationChannel with_bits_of_file(RotationChannel channel, const RotationOfFile& file, SameKey same) {
  const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
  const auto& times = file.read.times;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    const auto found = std::ranges::lower_bound(times, channel.times[i]);
    if (found == times.end() || *found != channel.times[i]) continue;
    const auto k = static_cast<std::size_t>(found - times.begin());
    const bool is_same = channel.values[i].coeffs() == file.read.values[k].coeffs();
    const double sign = is_same                       ? 1.0
                        : same == SameKey::to_the_bit ? 0.0
                                                      : same_sign(channel.values[i], file.read.values[k]);
    // One key at rest has the same bits in every clip, which are then stored once.
    if (sign == 0.0 || (channel.size() == 1 && !is_same)) continue;
    channel.values[i].coeffs() = sign * file.raw.values[k].coeffs();
    if (!is_spline) continue;
    // Readers divide tangents by what they divide the value by.
    const auto restore = [&](Eigen::Quaterniond& tangent, const SharedList<Eigen::Quaterniond>& read,
                             const SharedList<Eigen::Quaterniond>& raw) {
      if (!read.empty() && sign > 0.0 && tangent.coeffs() == read[k].coeffs()) tangent = raw[k];
      else tangent.coeffs() *= file.raw.values[k].norm();
    };
    restore(channel.in_tangents[i], file.read.in_tangents, file.raw.in_tangents);
    restore(channel.out_tangents[i], file.read.out_tangents, file.raw.out_tangents);
  }
  return channel;
}

}}}  // namespace orispline::scenes::gltf
