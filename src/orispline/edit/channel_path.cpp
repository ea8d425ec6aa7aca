// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/channel_path.hpp>

#include <orispline/curve/keyframe.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <CurvePoint P>
Expected<AnyCurveThrough<P>> meant_curve(const Channel<P>& channel) {
  if (channel.interpolation != ChannelInterpolation::linear || channel.size() == 1)
    return AnyCurveThrough<P>(StoredCurve<P>{ChannelCurve<P>(channel).curve()});
  KeyframeData data{.times = channel.times};
  if constexpr (std::same_as<P, Eigen::Quaterniond>) {
    data.orientations = channel.values;
    return Keyframes::make(std::move(data)).and_then([](const Keyframes& keys) {
      return make_curve(default_method, keys);
    });
  } else {
    data.positions = channel.values;
    data.orientations.assign(channel.size(), Eigen::Quaterniond::Identity());
    return Keyframes::make(std::move(data)).and_then([](const Keyframes& keys) {
      return make_pose_curve(default_method, keys).map([](const PoseCurve& curve) { return *curve.position; });
    });
  }
}
template Expected<AnyCurve> meant_curve(const RotationChannel&);
template Expected<AnyPath> meant_curve(const VectorChannel&);

}}  // namespace orispline
