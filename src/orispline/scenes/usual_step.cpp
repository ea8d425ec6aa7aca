// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/usual_step.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

double usual_step_of(const Clip& clip) {
  double usual = 0.0;
  const auto look = [&](const auto& channels) {
    for (const auto& channel : channels) {
      std::vector<double> steps;
      for (std::size_t i = 0; i + 1 < channel.size(); ++i) steps.push_back(channel.times[i + 1] - channel.times[i]);
      if (steps.size() < 2) continue;
      const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
      std::ranges::nth_element(steps, middle);
      usual = std::max(usual, *middle);
    }
  };
  look(clip.rotations);
  look(clip.translations);
  return usual;
}

}}}  // namespace orispline::scenes
