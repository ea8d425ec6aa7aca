// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/euler_turns.hpp>

#include <cmath>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/io/orientation_form.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr double full = 2.0 * std::numbers::pi;
constexpr double rounding = 1e-9;                            // of angles in a file [rad]
constexpr double small_step = 5.0 * std::numbers::pi / 180;  // below, noise may turn the sign
constexpr double likeness = 4.0;                             // steps of a recording beside each other

/// What is left of a step of an angle that began anew.
double rest_of(double step) { return std::remainder(step, full); }

bool are_alike(double rest, double beside) {
  if (std::abs(beside) <= rounding) return false;
  const bool same_way = rest * beside > 0.0 || std::abs(rest) <= small_step;
  return same_way && std::abs(rest) <= likeness * std::abs(beside);
}

/// 180° and -180° are one angle, and rounding decides which of them a recording says.
bool is_the_same_half_turn(double from, double to) {
  return std::abs(from + to) <= rounding && std::abs(std::abs(from) - std::numbers::pi) <= rounding;
}

}  // namespace

bool EulerTurns::looks_wrapped(const Step& step, const Eigen::Vector3d& beside) const {
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double turn = step.to[i] - step.from[i];
    if (std::abs(turn) <= std::numbers::pi || is_the_same_half_turn(step.from[i], step.to[i])) continue;
    if (most_[i] - least_[i] > full + rounding || !are_alike(rest_of(turn), rest_of(beside[i]))) return false;
  }
  return true;
}

void EulerTurns::note(const Step& step) {
  Lost& lost = step.is_whole ? whole_ : half_;
  if (lost.steps++ == 0) lost.first = step;
}

void EulerTurns::add(const Eigen::Vector3d& angles, const Eigen::Quaterniond& q) {
  if (keys_++ == 0) {
    least_ = most_ = angles_ = angles;
    q_ = q;
    return;
  }
  const Eigen::Vector3d turn = angles - angles_;
  least_ = least_.cwiseMin(angles);
  most_ = most_.cwiseMax(angles);
  if (const auto open = std::exchange(open_, std::nullopt); open && !looks_wrapped(*open, turn)) note(*open);
  const Step step{keys_ - 2, angles_, angles, turn.cwiseAbs().maxCoeff() >= full - rounding};
  if (step.is_whole || q.dot(q_) < -rounding) {
    if (!step_ || !looks_wrapped(step, *step_)) open_ = step;
  }
  step_ = turn;
  angles_ = angles;
  q_ = q;
}

void EulerTurns::finish() {
  if (const auto open = std::exchange(open_, std::nullopt)) note(*open);
}

std::vector<Warning> EulerTurns::warnings(Signs signs, const EulerOrder& order) const {
  const bool keeps_halves = signs == Signs::as_given;
  const std::size_t steps = whole_.steps + (keeps_halves ? 0 : half_.steps);
  if (steps == 0) return {};
  const bool half_first = !keeps_halves && half_.steps > 0 && (whole_.steps == 0 || half_.first.key < whole_.first.key);
  const Step& first = half_first ? half_.first : whole_.first;
  Eigen::Index angle = 0;
  (first.to - first.from).cwiseAbs().maxCoeff(&angle);
  const double from = first.from[angle] * degrees, to = first.to[angle] * degrees;
  const std::string_view name = names_by_axis(order)[static_cast<std::size_t>(angle)];
  const std::string cure = whole_.steps == 0 ? "set `signs` to as-given to turn as the angles say"
                           : keeps_halves
                               ? "put keys in between: a step must turn by less than 360°"
                               : "put keys in between and set `signs` to as-given to turn as the angles say: "
                                 "a step must turn by less than 360°";
  return {Warning{
      .code = "lost_turns",
      .message = formatted("{} of Euler angles, the first with {} from {:.6g}° to {:.6g}°, {} turned the short way; {}",
                           counted(steps, "step"), name, from, to, steps == 1 ? "is" : "are", cure),
      .where = {.key = first.key},
      .numbers = {{"steps", static_cast<double>(steps)}, {"from_deg", from}, {"to_deg", to}}}};
}

}}}  // namespace orispline::io
