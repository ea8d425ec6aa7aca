// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/uniform.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

template <CurvePoint P>
Expected<AnyCurveThrough<P>> UniformFamily::curve(const Keyframes& keys, const FamilySettings& settings) {
  return with_basis<AnyCurveThrough<P>>(
      settings, [&](auto basis) { return four_key_curve<P>(keys, settings, std::move(basis)); });
}

template Expected<AnyCurveThrough<Eigen::Quaterniond>> UniformFamily::curve<Eigen::Quaterniond>(const Keyframes&,
                                                                                                const FamilySettings&);
template Expected<AnyCurveThrough<Eigen::Vector3d>> UniformFamily::curve<Eigen::Vector3d>(const Keyframes&,
                                                                                          const FamilySettings&);

}}}  // namespace orispline::families
