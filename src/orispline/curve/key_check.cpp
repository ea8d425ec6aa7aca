// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/key_check.hpp>

#include <cmath>

#include <fmt/format.h>

#include <orispline/curve/keyframe.hpp>

namespace orispline {
namespace {

Error key_error(std::size_t key, std::string message) {
  return {ErrorCode::bad_data, std::move(message), {.key = key}};
}

}  // namespace

std::optional<Error> check_time(std::size_t key, double time, std::optional<double> before) {
  if (!std::isfinite(time)) return key_error(key, fmt::format("time is {}, wanted a finite number", time));
  if (!before) return std::nullopt;
  if (time == *before) return key_error(key, fmt::format("duplicate time {}, wanted strictly increasing times", time));
  if (time < *before)
    return key_error(key, fmt::format("time {} comes after {}, wanted strictly increasing times", time, *before));
  if (const double step = time - *before; !(shortest_step <= step && step <= longest_step))
    return key_error(key, fmt::format("the step from time {} to {} is {:g} s, wanted {:g} to {:g}", *before, time, step,
                                      shortest_step, longest_step));
  return std::nullopt;
}

Expected<double> checked_norm(std::size_t key, const Eigen::Quaterniond& q) {
  if (!q.coeffs().allFinite())
    return tl::unexpected(
        key_error(key, "the quaternion has a component that is not finite, wanted a unit quaternion"));
  const double norm = q.coeffs().stableNorm();
  if (std::abs(norm - 1.0) <= norm_error_limit) return norm;
  return tl::unexpected(
      key_error(key, fmt::format("the quaternion has norm {:.6g}, wanted 1 within {:g}", norm, norm_error_limit)));
}

std::optional<Error> check_vector(std::size_t key, const char* what, const Eigen::Vector3d& v) {
  if (v.allFinite()) return std::nullopt;
  return key_error(key, fmt::format("the {} has a component that is not finite", what));
}

}  // namespace orispline
