// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/fields/json.hpp>

namespace orispline {

/// Keys of arm.csv about z by these angles [rad], one second apart.
inline Track turns_of(const std::vector<double>& angles) {
  KeyframeData data;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    data.times.push_back(static_cast<double>(i));
    data.orientations.emplace_back(Eigen::AngleAxisd(angles[i], Eigen::Vector3d::UnitZ()));
  }
  Track track(*Keyframes::make(std::move(data)));
  track.name = "data/arm.csv";
  return track;
}

inline std::shared_ptr<const Track> turns(const std::vector<double>& angles, std::string recipe = "") {
  Track track = turns_of(angles);
  track.recipe.method = std::move(recipe);
  return std::make_shared<const Track>(std::move(track));
}

/// A member of an object; null where there is none.
inline Json member(const Json& json, std::string_view name) {
  for (const auto& [key, value] : std::get<Json::Object>(json.value()))
    if (key == name) return value;
  return nullptr;
}

inline double number(const Json& json, std::string_view name) { return std::get<double>(member(json, name).value()); }
inline std::uint64_t count(const Json& json, std::string_view name) {
  return std::get<std::uint64_t>(member(json, name).value());
}

}  // namespace orispline
