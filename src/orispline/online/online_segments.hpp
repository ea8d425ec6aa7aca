// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <orispline/online/recent_keys.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/path.hpp>

namespace orispline {

/// The segments of one family by their place in a ring: nothing is allocated after construction.
class OnlineSegments {
 public:
  virtual ~OnlineSegments() = default;
  /// Keys behind the end of a segment that it blends.
  [[nodiscard]] virtual std::size_t look_ahead() const noexcept = 0;
  /// Makes the segment from key `s` of these to the next one. Errors: those of `ghost_increment`.
  [[nodiscard]] virtual Expected<void> store(std::size_t place, const RecentKeys& keys, std::size_t s) = 0;
  [[nodiscard]] virtual Eigen::Quaterniond orientation(double t, std::size_t place) const noexcept = 0;
  [[nodiscard]] virtual Motion motion(double t, std::size_t place) const noexcept = 0;
  [[nodiscard]] virtual LinearMotion linear_motion(double t, std::size_t place) const noexcept = 0;
};

/// A family of which a stream of keys can be interpolated.
struct OnlineMethod {
  const FamilyInfo* family;
  Expected<std::unique_ptr<OnlineSegments>> (*segments)(std::size_t places, const FamilySettings& settings);
};

/// The names of these families.
[[nodiscard]] std::span<const std::string_view> online_methods() noexcept;

/// The one of that name; another one is an error (bad_argument) that lists them.
[[nodiscard]] Expected<OnlineMethod> find_online_method(std::string_view name);

}  // namespace orispline
