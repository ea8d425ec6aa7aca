// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/key_check.hpp>

#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

Error key_error(std::size_t key, std::string message) {
  return {ErrorCode::bad_data, std::move(message), {.key = key}};
}

/// What is wrong with a time that cannot follow.
Error time_error(std::size_t key, double time, std::optional<double> before) {
  if (!std::isfinite(time) || !before) return key_error(key, formatted("time is {}, wanted a finite number", time));
  if (time == *before) return key_error(key, formatted("duplicate time {}, wanted strictly increasing times", time));
  if (time < *before)
    return key_error(key, formatted("time {} comes after {}, wanted strictly increasing times", time, *before));
  return key_error(key, formatted("the step from time {} to {} is {:g} s, wanted {:g} to {:g}", *before, time,
                                  time - *before, shortest_step, longest_step));
}

Error norm_error(std::size_t key, const Eigen::Vector4d& components) {
  if (!components.allFinite())
    return key_error(key, "the quaternion has a component that is not finite, wanted a unit quaternion");
  return key_error(key, formatted("the quaternion has norm {:.6g}, wanted 1 within {:g}", components.stableNorm(),
                                  norm_error_limit));
}

}  // namespace

std::optional<Error> check_time(std::size_t key, double time, std::optional<double> before) {
  const double step = before ? time - *before : 0.0;
  if (before ? shortest_step <= step && step <= longest_step : std::isfinite(time)) return std::nullopt;
  return time_error(key, time, before);
}

Expected<double> checked_norm(std::size_t key, const Eigen::Quaterniond& q) {
  // The bits of stableNorm for all norms near 1, in a fraction of its time; NaN when a component is not finite.
  const double largest = q.coeffs().cwiseAbs().maxCoeff();
  const double norm = largest * std::sqrt((q.coeffs() * (1.0 / largest)).squaredNorm());
  if (std::abs(norm - 1.0) <= norm_error_limit) return norm;
  return tl::unexpected(norm_error(key, q.coeffs()));
}

std::optional<Error> check_vector(std::size_t key, const char* what, const Eigen::Vector3d& v) {
  if (v.allFinite()) return std::nullopt;
  return key_error(key, formatted("the {} has a component that is not finite", what));
}

}  // namespace orispline::inline ORISPLINE_ABI
