// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/keyframe.hpp>

#include <algorithm>

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/curve/key_parts.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

std::optional<Error> check_lengths(const KeyframeData& data) {
  const std::size_t n = data.times.size();
  const auto differs = [n](const char* what, std::size_t size) -> std::optional<Error> {
    return Error{ErrorCode::bad_data, formatted("found {} {} for {} times, wanted one per key", size, what, n), {}};
  };
  if (data.orientations.size() != n) return differs("orientations", data.orientations.size());
  if (auto error = first_error_of_parts([&](const auto& part) -> std::optional<Error> {
        const std::size_t size = (data.*part.list).size();
        return size == 0 || size == n ? std::nullopt : differs(part.many, size);
      }))
    return error;
  if (n == 0) return Error{ErrorCode::bad_data, "empty: no keys", {}};
  return std::nullopt;
}

/// What is wrong with a time beside those before it, since the last jump.
std::optional<Error> check_time_of(const KeyframeData& data, std::size_t i) {
  const std::span<const double> times(data.times);
  std::size_t first = i - std::min(i, keys_seen_together - 1);
  for (std::size_t k = first; data.jumps && k <= i; ++k)
    if (is_jump(times, k)) first = k;
  return check_time(i, times[i], times.subspan(first, i - first));
}

/// Says of data that are good whether they have jumps.
KeyframeData settled(KeyframeData data) {
  data.jumps = data.jumps && std::ranges::adjacent_find(data.times) != data.times.end();
  return data;
}

std::optional<Error> check_parts(const KeyframeData& data, std::size_t i) {
  return first_error_of_parts([&](const auto& part) -> std::optional<Error> {
    const auto& list = data.*part.list;
    return list.empty() ? std::nullopt : part.check(i, part.one, list[i]);
  });
}

/// Calls `change` with the inner quaternions of a key, but not with those that are free.
template <class Change>
void for_each_inner(KeyframeData& data, std::size_t i, Change change) {
  for (auto* list : {&data.inner_leaving, &data.inner_arriving})
    if (!list->empty() && !is_free_inner((*list)[i])) change((*list)[i]);
}

/// Of the two signs of q the one that is nearer to another quaternion.
void align(Eigen::Quaterniond& q, const Eigen::Quaterniond& other) {
  if (q.dot(other) < 0.0) q.coeffs() = -q.coeffs();
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
      if (auto error = check_time_of(data, i)) return tl::unexpected(std::move(*error));
    Eigen::Quaterniond& q = data.orientations[i];
    const auto norm = checked_norm(i, q);
    if (!norm) return tl::unexpected(norm.error());
    if (auto error = check_parts(data, i)) return tl::unexpected(std::move(*error));
    const bool follows = i > 0 && data.times[i] != data.times[i - 1];
    q = alignment.next(normalised(q, *norm), *norm, signs, follows ? &data.orientations[i - 1] : nullptr);
    for_each_inner(data, i, [&q, i](Eigen::Quaterniond& inner) {
      inner = normalised(inner, checked_norm(i, inner).value());
      align(inner, q);
    });
  }
  keys.report_ = alignment.report;
  keys.data_ = std::make_shared<const KeyframeData>(settled(std::move(data)));
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
  KeyframeData kept = *data_;
  for_each_list(kept, [count](auto& list) {
    if (!list.empty()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(count), list.end());
  });
  return with(std::move(kept));
}

Keyframes Keyframes::with(KeyframeData data) const {
  Keyframes keys = *this;
  keys.data_ = std::make_shared<const KeyframeData>(settled(std::move(data)));
  return keys;
}

Keyframes Keyframes::at(std::span<const std::size_t> indices) const {
  ORISPLINE_EXPECT(!indices.empty());
  KeyframeData kept = list_by_list(*data_, [indices](const auto& list) { return entries_at(list, indices); });
  for (std::size_t i = 1; i < kept.orientations.size(); ++i) {
    Eigen::Quaterniond& q = kept.orientations[i];
    align(q, kept.orientations[i - 1]);
    for_each_inner(kept, i, [&q](Eigen::Quaterniond& inner) { align(inner, q); });
  }
  return with(std::move(kept));
}

Expected<Keyframes> Keyframes::with_times(std::vector<double> times) const {
  KeyframeData data = *data_;
  data.times = std::move(times);
  if (auto error = check_lengths(data)) return tl::unexpected(std::move(*error));
  const bool times_are_fine = have_comparable_steps(data.times);
  for (std::size_t i = 0; !times_are_fine && i < data.times.size(); ++i)
    if (auto error = check_time_of(data, i)) return tl::unexpected(std::move(*error));
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
    if (auto error = check_parts(data, i)) return tl::unexpected(std::move(*error));
  return with(std::move(data));
}

}}  // namespace orispline
