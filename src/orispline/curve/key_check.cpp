// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/key_check.hpp>

#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Error key_error(std::size_t key, std::string message) {
  return {ErrorCode::bad_data, std::move(message), {.key = key}};
}

/// The bits of stableNorm for all norms near 1, in a fraction of its time; NaN when a component is not finite.
double norm_of(const Eigen::Quaterniond& q) noexcept {
  const double largest = q.coeffs().cwiseAbs().maxCoeff();
  return largest * std::sqrt((q.coeffs() * (1.0 / largest)).squaredNorm());
}

/// What is wrong with a time that cannot follow another one.
Error time_error(std::size_t key, double time, double before) {
  if (time == before) return key_error(key, formatted("duplicate time {}, wanted strictly increasing times", time));
  if (time < before)
    return key_error(key, formatted("time {} comes after {}, wanted strictly increasing times", time, before));
  return key_error(key, formatted("the step from time {} to {} is {:g} s, wanted {:g} to {:g}", before, time,
                                  time - before, shortest_step, longest_step));
}

Error norm_error(std::size_t key, const char* what, const Eigen::Vector4d& components) {
  if (!components.allFinite())
    return key_error(key, formatted("the {} has a component that is not finite, wanted a unit quaternion", what));
  return key_error(
      key, formatted("the {} has norm {:.6g}, wanted 1 within {:g}", what, components.stableNorm(), norm_error_limit));
}

/// Of what may be free, but lacks some of its components.
template <int Size>
std::optional<Error> check_is_whole(std::size_t key, const char* what, const Eigen::Matrix<double, Size, 1>& value) {
  const auto missing = value.array().isNaN().count();
  if (missing == 0) return std::nullopt;
  return key_error(key, formatted("the {} lacks {} of its {} components, wanted all of them, or none to leave it free",
                                  what, missing, Size));
}

}  // namespace

std::optional<Error> check_time(std::size_t key, double time, std::span<const double> before) {
  if (!std::isfinite(time)) return key_error(key, formatted("time is {}, wanted a finite number", time));
  if (before.empty()) return std::nullopt;
  const double step = time - before.back();
  if (!(shortest_step <= step && step <= longest_step)) return time_error(key, time, before.back());
  const auto together = before.last(std::min(before.size(), keys_seen_together - 1));
  for (std::size_t i = 1; i < together.size(); ++i)
    if (const double other = together[i] - together[i - 1]; !are_comparable(step, other))
      return key_error(key, formatted("the step from time {} to {} is {:g} s, and one of {:g} s is among the {} before "
                                      "it, wanted neither longer than {:g} times the other",
                                      before.back(), time, step, other, keys_seen_together - 2, widest_step_ratio));
  return std::nullopt;
}

bool have_comparable_steps(std::span<const double> times) noexcept {
  double shortest = longest_step, longest = shortest_step;
  bool are_steps = times.empty() || std::isfinite(times.front());
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double step = times[i] - times[i - 1];
    are_steps &= shortest_step <= step && step <= longest_step;
    shortest = std::min(shortest, step);
    longest = std::max(longest, step);
  }
  return are_steps && (times.size() < 2 || are_comparable(shortest, longest));
}

std::optional<Error> check_times(std::span<const double> times) {
  if (have_comparable_steps(times)) return std::nullopt;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (auto error = check_time(i, times[i], times.first(i))) return error;
  return std::nullopt;
}

Expected<double> checked_norm(std::size_t key, const Eigen::Quaterniond& q, const char* what) {
  const double norm = norm_of(q);
  if (std::abs(norm - 1.0) <= norm_error_limit) return norm;
  return tl::unexpected(norm_error(key, what, q.coeffs()));
}

Eigen::Quaterniond normalised(Eigen::Quaterniond q, double norm) noexcept {
  if (norm == 1.0) return q;
  const Eigen::Quaterniond divided(q.coeffs() / norm);
  const double left = norm_of(divided);
  const bool is_nearer = std::abs(left - 1.0) < std::abs(norm - 1.0);
  if (is_nearer && left != 1.0) return normalised(divided, left);
  // Which of the two is a toss-up for keys that are unit but for rounding: chosen without a branch, by 1 or 0.
  const auto chosen = static_cast<double>(is_nearer);
  return Eigen::Quaterniond(q.coeffs() / (chosen * norm + (1.0 - chosen)));
}

std::optional<Error> check_vector(std::size_t key, const char* what, const Eigen::Vector3d& v) {
  if (is_in_range(v)) return std::nullopt;
  if (!v.allFinite())
    return key_error(key, formatted("the {} has a component that is not finite, wanted finite numbers", what));
  return key_error(key, formatted("the {} has a component of {:g}, wanted {:g} at most", what, v.cwiseAbs().maxCoeff(),
                                  largest_component));
}

std::optional<Error> check_rate(std::size_t key, const char* what, const Eigen::Vector3d& rate) {
  if (is_free(rate)) return std::nullopt;
  if (auto error = check_is_whole(key, what, rate)) return error;
  return check_vector(key, what, rate);
}

std::optional<Error> check_inner(std::size_t key, const char* what, const Eigen::Quaterniond& inner) {
  if (is_free_inner(inner)) return std::nullopt;
  if (auto error = check_is_whole(key, what, inner.coeffs())) return error;
  const auto norm = checked_norm(key, inner, what);
  return norm ? std::nullopt : std::optional(norm.error());
}

}}  // namespace orispline
