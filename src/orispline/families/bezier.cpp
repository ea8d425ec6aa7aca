// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/bezier.hpp>

#include <fmt/format.h>

namespace orispline::families {
namespace {

Expected<Knots> joint_times(const Keyframes& keys) {
  if (keys.size() % 3 != 1)
    return failure(ErrorCode::bad_data, fmt::format("bezier needs 3k+1 keys (4, 7, 10, ...), found {}", keys.size()));
  std::vector<double> times;
  times.reserve(keys.size() / 3 + 1);
  for (std::size_t i = 0; i < keys.size(); i += 3) times.push_back(keys.times()[i]);
  return Knots(std::move(times));
}

}  // namespace

template <CurvePoint P>
Expected<CumulativeCurve<CubicBezierBasis, P>> Bezier::curve(const Keyframes& keys, const FamilySettings&) {
  return joint_times(keys).map(
      [&](Knots knots) { return CumulativeCurve<CubicBezierBasis, P>(std::move(knots), {}, keys.points<P>()); });
}

template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Quaterniond>> Bezier::curve<Eigen::Quaterniond>(
    const Keyframes&, const FamilySettings&);
template Expected<CumulativeCurve<CubicBezierBasis, Eigen::Vector3d>> Bezier::curve<Eigen::Vector3d>(
    const Keyframes&, const FamilySettings&);

}  // namespace orispline::families
