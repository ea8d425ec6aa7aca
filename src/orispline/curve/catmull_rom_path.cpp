// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/catmull_rom_path.hpp>

namespace orispline {

CatmullRomPath::CatmullRomPath(const Keyframes& keys)
    : knots_({keys.times().begin(), keys.times().end()}), positions_(keys.positions().begin(), keys.positions().end()) {
  ORISPLINE_EXPECT(keys.size() >= 2 && !keys.positions().empty());
  const auto chord = [this](std::size_t i) -> Eigen::Vector3d {
    return (positions_[i + 1] - positions_[i]) / knots_.span(i).step();
  };
  const std::size_t last = keys.size() - 1;
  velocities_.reserve(keys.size());
  velocities_.push_back(chord(0));
  for (std::size_t i = 1; i < last; ++i) {
    const double before = knots_.span(i).previous_step(), after = knots_.span(i).step();
    velocities_.push_back((after * chord(i - 1) + before * chord(i)) / (before + after));
  }
  velocities_.push_back(chord(last - 1));
}

}  // namespace orispline
