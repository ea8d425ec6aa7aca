// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/keyframe.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_check.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// What a key may have besides its time and orientation, with its name in the singular and in the plural, and what it
/// must be.
struct Optional {
  std::vector<Eigen::Vector3d> KeyframeData::*values;
  const char *one, *many;
  std::optional<Error> (*check)(std::size_t, const char*, const Eigen::Vector3d&);
};
constexpr std::array optional_data{
    Optional{&KeyframeData::positions, "position", "positions", check_vector},
    Optional{&KeyframeData::angular_velocities, "angular velocity", "angular velocities", check_rate},
    Optional{&KeyframeData::angular_accelerations, "angular acceleration", "angular accelerations", check_rate},
    Optional{&KeyframeData::angular_jerks, "angular jerk", "angular jerks", check_rate}};

std::optional<Error> check_lengths(const KeyframeData& data) {
  const std::size_t n = data.times.size();
  const auto differs = [n](const char* what, std::size_t size) -> std::optional<Error> {
    return Error{ErrorCode::bad_data, formatted("found {} {} for {} times, wanted one per key", size, what, n), {}};
  };
  if (data.orientations.size() != n) return differs("orientations", data.orientations.size());
  for (const Optional& some : optional_data)
    if (const std::size_t size = (data.*some.values).size(); size != 0 && size != n) return differs(some.many, size);
  if (n == 0) return Error{ErrorCode::bad_data, "empty: no keys", {}};
  return std::nullopt;
}

std::optional<Error> check_vectors(const KeyframeData& data, std::size_t i) {
  for (const Optional& some : optional_data)
    if (const auto& values = data.*some.values; !values.empty())
      if (auto error = some.check(i, some.one, values[i])) return error;
  return std::nullopt;
}

/// What stands for the data of no keys.
const KeyframeData& no_data() {
  static const KeyframeData none;
  return none;
}

}  // namespace

Keyframes::Keyframes() noexcept : data_(std::shared_ptr<const KeyframeData>(), &no_data()) {}

Expected<Keyframes> Keyframes::make(KeyframeData data, Signs signs) {
  if (auto error = check_lengths(data)) return tl::unexpected(std::move(*error));
  Keyframes keys;
  KeyAlignment alignment;
  const bool times_are_fine = have_comparable_steps(data.times);
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    if (!times_are_fine)
      if (auto error = check_time(i, data.times[i], std::span(data.times).first(i)))
        return tl::unexpected(std::move(*error));
    Eigen::Quaterniond& q = data.orientations[i];
    const auto norm = checked_norm(i, q);
    if (!norm) return tl::unexpected(norm.error());
    if (auto error = check_vectors(data, i)) return tl::unexpected(std::move(*error));
    q = alignment.next(normalised(q, *norm), *norm, signs, i > 0 ? &data.orientations[i - 1] : nullptr);
  }
  keys.report_ = alignment.report;
  keys.data_ = std::make_shared<const KeyframeData>(std::move(data));
  return keys;
}

bool Keyframes::rests_after(std::size_t i) const {
  ORISPLINE_EXPECT(i + 1 < size());
  const auto q = orientations();
  const auto p = positions();
  const double chord = (q[i + 1].coeffs() - q[i].coeffs()).norm();  // half the angle, where that is small
  return 2.0 * chord <= rest_angle && (p.empty() || (p[i + 1] - p[i]).norm() <= rest_length);
}

std::vector<std::size_t> Keyframes::rests() const {
  std::vector<std::size_t> rests;
  for (std::size_t i = 0; i + 1 < size(); ++i)
    if (rests_after(i)) rests.push_back(i);
  return rests;
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
  return with(std::move(kept_data));
}

Keyframes Keyframes::with(KeyframeData data) const {
  Keyframes keys = *this;
  keys.data_ = std::make_shared<const KeyframeData>(std::move(data));
  return keys;
}

Keyframes Keyframes::at(std::span<const std::size_t> indices) const {
  ORISPLINE_EXPECT(!indices.empty());
  KeyframeData kept;
  const auto pick = [indices](auto& to, const auto& from) {
    if (from.empty()) return;
    to.reserve(indices.size());
    for (const std::size_t i : indices) to.push_back(from[i]);
  };
  pick(kept.times, data_->times);
  pick(kept.orientations, data_->orientations);
  for (const Optional& some : optional_data) pick(kept.*some.values, (*data_).*some.values);
  for (std::size_t i = 1; i < kept.orientations.size(); ++i)
    if (Eigen::Quaterniond& q = kept.orientations[i]; q.dot(kept.orientations[i - 1]) < 0.0) q.coeffs() = -q.coeffs();
  return with(std::move(kept));
}

Expected<Keyframes> Keyframes::with_times(std::vector<double> times) const {
  KeyframeData data = *data_;
  data.times = std::move(times);
  if (auto error = check_lengths(data)) return tl::unexpected(std::move(*error));
  if (auto error = check_times(data.times)) return tl::unexpected(std::move(*error));
  return with(std::move(data));
}

Expected<Keyframes> Keyframes::with_rates(std::vector<Eigen::Vector3d> angular_velocities,
                                          std::vector<Eigen::Vector3d> angular_accelerations,
                                          std::vector<Eigen::Vector3d> angular_jerks) const {
  KeyframeData data = *data_;
  data.angular_velocities = std::move(angular_velocities);
  data.angular_accelerations = std::move(angular_accelerations);
  data.angular_jerks = std::move(angular_jerks);
  if (auto error = check_lengths(data)) return tl::unexpected(std::move(*error));
  for (std::size_t i = 0; i < data.times.size(); ++i)
    if (auto error = check_vectors(data, i)) return tl::unexpected(std::move(*error));
  return with(std::move(data));
}

}}  // namespace orispline
