// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/catmull_rom_path.hpp>

#include <orispline/curve/three_key_rates.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

CatmullRomPath::CatmullRomPath(const Keyframes& keys, const PerKey& tension)
    : knots_({keys.times().begin(), keys.times().end()}), positions_(keys.positions().begin(), keys.positions().end()) {
  ORISPLINE_EXPECT(keys.size() >= 2 && !keys.positions().empty());
  std::vector<Eigen::Vector3d> chords;
  chords.reserve(keys.size() - 1);
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) chords.push_back(positions_[i + 1] - positions_[i]);
  velocities_ = three_key_rates(keys.times(), chords);
  for (std::size_t i = 0; i < velocities_.size(); ++i) velocities_[i] *= tension[i];
}

}}  // namespace orispline
