// SPDX-License-Identifier: Apache-2.0
#include "output/smoothing_json.hpp"

#include <array>

namespace orispline::cli {

Json places_json(const std::vector<std::size_t>& samples, const std::vector<std::uint32_t>& lines,
                 const std::vector<Decimal>& times) {
  Json list = Json::array();
  for (const std::size_t i : samples)
    list.push_back({{"key", i}, {"line", lines[i]}, {"time_s", times[i].to_string()}});
  return list;
}

Json criterion_of(const orispline::Smoothing& smoothing) {
  if (!smoothing.criterion) return nullptr;
  constexpr std::array names{"gcv", "ubre", "reml"};
  return names[static_cast<std::size_t>(*smoothing.criterion)];
}

}  // namespace orispline::cli
