// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/way_clock.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <orispline/analysis/curve_measures.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

constexpr std::size_t most_times = 2000;

/// The part of its way that a curve has gone, of the angle and of the distance alike; it grows wherever either does.
class PartOfWay {
 public:
  explicit PartOfWay(const PoseCurve& curve) : angle_(curve.orientation), domain_(curve.orientation.domain()) {
    if (curve.position) distance_.emplace(*curve.position);
  }

  [[nodiscard]] double time(std::size_t k) const {
    return std::lerp(domain_.start, domain_.end, static_cast<double>(k) / static_cast<double>(most_times - 1));
  }
  [[nodiscard]] double at(double t) const {
    const auto part = [t](const auto& travelled) {
      return travelled.total() > 0.0 ? travelled.at(t) / travelled.total() : 0.0;
    };
    return part(angle_) + (distance_ ? part(*distance_) : 0.0);
  }

 private:
  AngleTravelled angle_;
  std::optional<DistanceTravelled> distance_{};
  Domain domain_;
};

}  // namespace

report::PageClock clock_of_keys(const Keyframes& page, const Keyframes& own) {
  report::PageClock clock;
  const std::size_t count = std::min(page.size(), most_times);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t key = count > 1 ? k * (page.size() - 1) / (count - 1) : 0;
    clock.times.push_back(page.times()[key]);
    clock.own.push_back(own.times()[key]);
  }
  return clock;
}

report::PageClock clock_of_ways(const PoseCurve& page, const PoseCurve& own) {
  const PartOfWay shown(page), other(own);
  std::vector<double> parts;
  for (std::size_t k = 0; k < most_times; ++k) parts.push_back(other.at(other.time(k)));
  report::PageClock clock;
  for (std::size_t k = 0; k < most_times; ++k) {
    const double part = shown.at(shown.time(k)) * (parts.back() / shown.at(shown.time(most_times - 1)));
    const auto after = std::lower_bound(parts.begin() + 1, parts.end() - 1, part);
    const auto i = static_cast<std::size_t>(after - parts.begin());
    const double step = parts[i] - parts[i - 1];
    const double share = step > 0.0 ? std::clamp((part - parts[i - 1]) / step, 0.0, 1.0) : 1.0;
    clock.times.push_back(shown.time(k));
    clock.own.push_back(std::lerp(other.time(i - 1), other.time(i), share));
  }
  return clock;
}

}}}  // namespace orispline::pages
