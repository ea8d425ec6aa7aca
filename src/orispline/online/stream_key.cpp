// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/stream_key.hpp>

#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_check.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

struct Part {
  std::optional<Eigen::Vector3d> StreamKey::*value;
  bool KeyParts::*wanted;
  const char *name, *one;
  std::optional<Error> (*check)(std::size_t, const char*, const Eigen::Vector3d&);
};
constexpr std::array parts{
    Part{&StreamKey::position, &KeyParts::position, "position", "a position", check_vector},
    Part{&StreamKey::angular_velocity, &KeyParts::angular_velocity, "angular velocity", "an angular velocity",
         check_rate},
    Part{&StreamKey::angular_acceleration, &KeyParts::angular_acceleration, "angular acceleration",
         "an angular acceleration", check_rate},
    Part{&StreamKey::angular_jerk, &KeyParts::angular_jerk, "angular jerk", "an angular jerk", check_rate}};

}  // namespace

Eigen::Quaterniond unit_orientation(const Eigen::Quaterniond& orientation) {
  return normalised(orientation, checked_norm(0, orientation).value());
}

KeyParts parts_of(const StreamKey& key) noexcept {
  KeyParts found;
  for (const Part& part : parts) found.*part.wanted = (key.*part.value).has_value();
  return found;
}

Expected<Eigen::Quaterniond> checked_orientation(std::uint64_t index, const StreamKey& key,
                                                 std::span<const double> before, const KeyParts& wanted) {
  const auto place = static_cast<std::size_t>(index);
  if (auto error = check_time(place, key.time, before)) return tl::unexpected(std::move(*error));
  for (const Part& part : parts) {
    const auto& value = key.*part.value;
    if (!before.empty() && value.has_value() != wanted.*part.wanted)
      return failure(ErrorCode::bad_data,
                     value ? formatted("found {}, wanted none as the keys before have none", part.one)
                           : formatted("found no {}, wanted one as the keys before have", part.name),
                     {.key = place});
    if (value)
      if (auto error = part.check(place, part.name, *value)) return tl::unexpected(std::move(*error));
  }
  const auto norm = checked_norm(place, key.orientation);
  if (!norm) return tl::unexpected(norm.error());
  return normalised(key.orientation, *norm);
}

}}  // namespace orispline
