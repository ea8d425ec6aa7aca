// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/barry_goldman.hpp>

#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

template <CurvePoint P>
Expected<Pyramid<P>> BarryGoldman::curve(const Keyframes& keys, const FamilySettings&) {
  const auto p = reflected(keys.points<P>());
  const auto t = reflected(keys.times());
  std::vector<typename Pyramid<P>::Segment> segments;
  for (std::ptrdiff_t i = 0; i + 1 < std::ssize(keys.times()); ++i)
    segments.push_back({.points = {p[i - 1], p[i], p[i + 1], p[i + 2]},
                        .times = {t[i - 1], t[i], t[i + 1], t[i + 2]},
                        .steps = {displacement<double>(p[i - 1], p[i]), displacement<double>(p[i], p[i + 1]),
                                  displacement<double>(p[i + 1], p[i + 2])}});
  return Pyramid<P>(key_knots(keys), std::move(segments));
}

template Expected<Pyramid<Eigen::Quaterniond>> BarryGoldman::curve<Eigen::Quaterniond>(const Keyframes&,
                                                                                       const FamilySettings&);
template Expected<Pyramid<Eigen::Vector3d>> BarryGoldman::curve<Eigen::Vector3d>(const Keyframes&,
                                                                                 const FamilySettings&);

}}}  // namespace orispline::families
