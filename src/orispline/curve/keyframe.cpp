// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/keyframe.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <orispline/base/expect.hpp>

namespace orispline {
namespace {

Error key_error(std::size_t key, std::string message) {
  return {ErrorCode::bad_data, std::move(message), {.key = key}};
}

/// What a key may have besides its time and orientation, with its name in the singular and in the plural.
struct Optional {
  std::vector<Eigen::Vector3d> KeyframeData::*values;
  const char *one, *many;
};
constexpr std::array optional_data{
    Optional{&KeyframeData::positions, "position", "positions"},
    Optional{&KeyframeData::angular_velocities, "angular velocity", "angular velocities"},
    Optional{&KeyframeData::angular_accelerations, "angular acceleration", "angular accelerations"},
    Optional{&KeyframeData::angular_jerks, "angular jerk", "angular jerks"}};

std::optional<Error> check_lengths(const KeyframeData& data) {
  const std::size_t n = data.times.size();
  const auto differs = [n](const char* what, std::size_t size) -> std::optional<Error> {
    return Error{ErrorCode::bad_data, fmt::format("found {} {} for {} times, wanted one per key", size, what, n), {}};
  };
  if (data.orientations.size() != n) return differs("orientations", data.orientations.size());
  for (const Optional& some : optional_data)
    if (const std::size_t size = (data.*some.values).size(); size != 0 && size != n) return differs(some.many, size);
  if (n == 0) return Error{ErrorCode::bad_data, "empty: no keys", {}};
  return std::nullopt;
}

std::optional<Error> check_key(const KeyframeData& data, std::size_t i) {
  const double t = data.times[i];
  if (!std::isfinite(t)) return key_error(i, fmt::format("time is {}, wanted a finite number", t));
  if (i > 0 && t == data.times[i - 1])
    return key_error(i, fmt::format("duplicate time {}, wanted strictly increasing times", t));
  if (i > 0 && t < data.times[i - 1])
    return key_error(i, fmt::format("time {} comes after {}, wanted strictly increasing times", t, data.times[i - 1]));
  if (i > 0 && !(shortest_step <= t - data.times[i - 1] && t - data.times[i - 1] <= longest_step))
    return key_error(i, fmt::format("the step from time {} to {} is {:g} s, wanted {:g} to {:g}", data.times[i - 1], t,
                                    t - data.times[i - 1], shortest_step, longest_step));
  if (!data.orientations[i].coeffs().allFinite())
    return key_error(i, "the quaternion has a component that is not finite, wanted a unit quaternion");
  for (const Optional& some : optional_data)
    if (const auto& values = data.*some.values; !values.empty() && !values[i].allFinite())
      return key_error(i, fmt::format("the {} has a component that is not finite", some.one));
  return std::nullopt;
}

}  // namespace

Expected<Keyframes> Keyframes::make(KeyframeData data, Signs signs) {
  if (auto error = check_lengths(data)) return tl::unexpected(std::move(*error));
  Keyframes keys;
  bool negated = false;  // whether the key before was
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    if (auto error = check_key(data, i)) return tl::unexpected(std::move(*error));
    Eigen::Quaterniond& q = data.orientations[i];
    const double norm = q.coeffs().stableNorm();
    const double norm_error = std::abs(norm - 1.0);
    if (!(norm_error <= norm_error_limit))
      return tl::unexpected(
          key_error(i, fmt::format("the quaternion has norm {:.6g}, wanted 1 within {:g}", norm, norm_error_limit)));
    keys.report_.largest_norm_error = std::max(keys.report_.largest_norm_error, norm_error);
    if (norm_error > unit_norm_tolerance) ++keys.report_.non_unit_keys;
    q.coeffs() /= norm;
    if (i == 0) continue;
    const bool against_previous = q.dot(data.orientations[i - 1]) < 0.0;  // which is aligned already
    if (against_previous != negated) ++keys.report_.sign_flips;
    if (signs == Signs::as_given) continue;
    negated = against_previous;
    if (negated) q.coeffs() = -q.coeffs();
  }
  keys.data_ = std::make_shared<const KeyframeData>(std::move(data));
  return keys;
}

Keyframes Keyframes::first(std::size_t count) const {
  ORISPLINE_EXPECT(1 <= count && count <= size());
  KeyframeData kept_data = *data_;
  const auto cut = [count](auto& values) {
    if (!values.empty()) values.erase(values.begin() + static_cast<std::ptrdiff_t>(count), values.end());
  };
  cut(kept_data.times);
  cut(kept_data.orientations);
  for (const Optional& some : optional_data) cut(kept_data.*some.values);
  Keyframes kept = *this;
  kept.data_ = std::make_shared<const KeyframeData>(std::move(kept_data));
  return kept;
}

}  // namespace orispline
