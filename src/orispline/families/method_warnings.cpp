// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/method_warnings.hpp>

#include <algorithm>
#include <array>
#include <optional>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/one_axis.hpp>
#include <orispline/curve/rate_comparison.hpp>
#include <orispline/curve/stretched_curve.hpp>
#include <orispline/curve/three_key_rates.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/overshot_span.hpp>
#include <orispline/families/overturned_span.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Shorter closing steps than this share of the shortest one between keys are worth a warning.
constexpr double closing_share = 1e-3;

std::optional<Warning> closing_step(const Method& method, const Keyframes& keys) {
  const auto times = keys.times();
  if (!method.options.loop || !method.options.loop->period || times.size() < 2) return std::nullopt;
  const double closing = *method.options.loop->period - (times.back() - times.front());
  double shortest = times[1] - times[0];
  for (std::size_t i = 1; i < times.size(); ++i) shortest = std::min(shortest, times[i] - times[i - 1]);
  if (closing <= 0.0 || closing >= closing_share * shortest) return std::nullopt;
  return Warning{
      .code = "closing_step",
      .message = formatted("the curve returns to the first key in {:.2g} s, where other steps take {:.4g} s and more, "
                           "so its rates are huge; use `closed` if the last key is the first one again",
                           closing, shortest),
      .numbers = {{"closing_step_s", closing}, {"shortest_step_s", shortest}},
      .option = "period"};
}

std::optional<Warning> overwound(const Method& method, const Keyframes& keys) {
  const auto found = overwound_tangent(method, keys);
  if (!found || !*found) return std::nullopt;
  const HandleTurn& wound = **found;
  const double turn = wound.turn / full_turn * 360.0;
  return Warning{.code = "overwound_tangent",
                 .message = formatted("a handle of {} turns by {:.4g} degrees, wanted less than a full turn: the "
                                      "angular velocity may jump there; take timed-c1, which has no such limit",
                                      method.name, turn),
                 .where = {.key = wound.key},
                 .numbers = {{"turn_deg", turn}}};
}

constexpr std::size_t fewest_keys = 4;           // that tell how the orientations turn
constexpr double misfit_of_opposed_rates = 1.2;  // beyond that of rests, 1; independent ones have √2

/// Rates that turn otherwise than the keys do.
std::optional<Warning> contradicting_rates(const FamilyInfo& family, const Keyframes& keys) {
  const auto rates = keys.angular_velocities();
  if (family.rate_orders == 0 || rates.empty() || keys.size() < fewest_keys) return std::nullopt;
  const auto all_turned = three_key_rates(keys.times(), increments_between(keys.orientations()));
  std::vector<Eigen::Quaterniond> orientations;
  std::vector<Eigen::Vector3d> given, turned;  // where they are not free
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (is_free(rates[i]) || !all_turned[i].allFinite()) continue;  // the latter beside a jump
    orientations.push_back(keys.orientations()[i]);
    given.push_back(rates[i]);
    turned.push_back(all_turned[i]);
  }
  if (given.size() < fewest_keys) return std::nullopt;
  const RateComparison comparison{orientations, given, turned};
  const double misfit = comparison.misfit();
  const auto meaning = comparison.better_meaning();
  if (!meaning && misfit <= misfit_of_opposed_rates) return std::nullopt;
  return Warning{.code = "contradicting_rates",
                 .message = formatted(
                     "the rates of the keys contradict their orientations, from which they differ by {:.3g} times "
                     "their size; {}",
                     misfit, meaning ? meaning->cure : "wanted rates of the body in its own frame in rad/s"),
                 .numbers = {{"misfit", misfit}}};
}

/// Beyond this share of the largest angular velocity, what angular accelerations add up to is no error of sampling.
constexpr double largest_sum = 10.0;

/// Accelerations by which the body would turn far quicker than its rates say: an accelerometer's, [m/s²].
std::optional<Warning> contradicting_accelerations(const FamilyInfo& family, const Keyframes& keys) {
  const auto times = keys.times();
  const auto rates = keys.angular_velocities(), accelerations = keys.angular_accelerations();
  if (family.rate_orders < 2 || !any_given(rates) || accelerations.empty() || keys.size() < fewest_keys)
    return std::nullopt;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // of the trapezia: ∫α dt is the change of ω, both of the body
  double largest_change = 0.0, largest_rate = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!is_free(rates[i])) largest_rate = std::max(largest_rate, rates[i].norm());
    if (i == 0) continue;
    const Eigen::Vector3d both = accelerations[i - 1] + accelerations[i];
    if (both.hasNaN()) sum.setZero();  // one is free
    else sum += 0.5 * (times[i] - times[i - 1]) * both;
    largest_change = std::max(largest_change, sum.norm());
  }
  if (largest_change <= largest_sum * largest_rate) return std::nullopt;
  return Warning{
      .code = "contradicting_accelerations",
      .message = formatted(
          "the angular accelerations of the keys add up to {:.3g} rad/s, but the angular velocities reach only "
          "{:.3g} rad/s; if an accelerometer measured them in m/s², take hermite-c1, which does not read them",
          largest_change, largest_rate),
      .numbers = {{"summed_rad_s", largest_change}, {"largest_rate_rad_s", largest_rate}}};
}

/// Turning so far during a rest is motion [rad].
constexpr double moving_angle = 10.0 * rest_angle;

bool moves_between(const AnyCurve& curve, std::size_t segment) {
  const KnotSpan span = curve.knots().span(segment);
  return std::ranges::any_of(std::array{0.2, 0.4, 0.6, 0.8}, [&](double u) {
    const Motion motion = curve.motion_on(segment, span.start() + u * span.step());
    return motion.angular_velocity.norm() * span.step() > moving_angle;
  });
}

/// Whether the keys say how the curve moves, beyond where it is.
bool says_how_it_moves(const FamilyInfo& family, const Keyframes& keys) {
  return (family.rate_orders > 0 && any_given(keys.angular_velocities())) ||
         (family.takes_inner_quaternions() && keys.have_inner_quaternions());
}

/// Equal keys between which the curve does not stand still.
template <class CurveOf>
std::optional<Warning> moving_rests(const Method& method, const FamilyInfo& family, const Keyframes& keys,
                                    const CurveOf& curve_of) {
  if (!family.interpolates || family.key_use.stride > 1 || says_how_it_moves(family, keys)) return std::nullopt;
  std::vector<std::size_t> rests = keys.rests();
  if (rests.empty()) return std::nullopt;
  const AnyCurve* const curve = curve_of();
  if (!curve) return std::nullopt;
  std::erase_if(rests, [&](std::size_t i) { return !moves_between(*curve, i); });
  if (rests.empty()) return std::nullopt;
  return Warning{
      .code = "moving_rests",
      .message = formatted("{} moves in {} between equal keys; take the method auto:hold=1, which stands still there",
                           method.name, counted(rests.size(), "rest")),
      .where = {.key = rests.front()},
      .numbers = {{"rests", static_cast<double>(rests.size())}}};
}

/// Where the curve moves far otherwise than its keys: it turns farther there, or swings away.
std::optional<Warning> odd_span(const Method& method, const FamilyInfo& family, const Track& track,
                                const AnyCurve* made) {
  if (auto overturned = overturned_span(method, family, track, made)) return overturned;
  if (says_how_it_moves(family, track.keys)) return std::nullopt;
  return overshot_span(method, family, track, made);
}

/// Farther apart are the two sides of a key than rounding explains [rad].
constexpr double smallest_jump = 1e-6;

/// `key 2, and at 3 more`
std::string others(std::size_t places) { return places > 1 ? formatted(", and at {} more", places - 1) : ""; }

/// A curve of a family of one's own whose segments do not meet.
template <class CurveOf>
std::optional<Warning> jumps_at_keys(const Method& method, const CurveOf& curve_of) {
  if (!method.own) return std::nullopt;
  const AnyCurve* const curve = curve_of();
  if (!curve) return std::nullopt;
  const auto t = curve->knots().times();
  const std::size_t segments = curve->knots().segments();
  std::size_t jumps = 0, where = 0;
  double largest = 0.0;
  for (std::size_t i = method.options.loop ? 0 : 1; i < segments; ++i) {
    if (is_gap(*curve, i)) continue;
    const std::size_t before = i == 0 ? segments - 1 : i - 1;
    const double jump = angular_distance(curve->orientation_on(before, t[before + 1]), curve->orientation_on(i, t[i]));
    if (!(jump > smallest_jump)) continue;
    ++jumps;
    if (jump > largest) largest = jump, where = i;
  }
  if (jumps == 0) return std::nullopt;
  return Warning{
      .code = "jump_at_key",
      .message = formatted("the curve of {} jumps by {:.4g} degrees at this key{}; take functions that go on "
                           "from segment to segment at these times",
                           method.name, largest / full_turn * 360.0, others(jumps)),
      .where = {.key = where},
      .numbers = {{"jump_deg", largest / full_turn * 360.0}, {"keys", static_cast<double>(jumps)}}};
}

/// Keys at which parameters of blending functions of one's own let the body rest or turn back.
std::optional<Warning> corners_at_keys(const Method& method, const Keyframes& keys) {
  const auto* const family = dynamic_cast<const BlendingFamily*>(method.own.get());
  if (!family || keys.size() < 2) return std::nullopt;
  const auto settings = settle(family->info(), method.options, keys.size());
  if (!settings) return std::nullopt;
  const std::vector<std::size_t> corners = possible_corners(*family, keys, *settings);
  if (corners.empty()) return std::nullopt;
  const auto shape = std::ranges::find(family->findings(), BlendingFinding::Promise::shape, &BlendingFinding::promise);
  return Warning{.code = "corner_at_key",
                 .message = formatted(
                     "the body of {} rests or turns back at this key{}, and its path may have a corner there: it is "
                     "G{} wherever {}, which these settings miss",
                     method.name, others(corners.size()), shape->order, shape->provided),
                 .where = {.key = corners.front()},
                 .numbers = {{"keys", static_cast<double>(corners.size())}}};
}

}  // namespace

std::vector<Warning> warnings_of(const KeyframeReport& keys) {
  if (keys.near_half_turns == 0) return {};
  return {Warning{
      .code = "near_half_turn",
      .message = formatted("{} to the next key {} nearly 180°, so the motion may go the wrong way round; put a key in "
                           "between, or set `signs` to as-given",
                           counted(keys.near_half_turns, "step"), keys.near_half_turns == 1 ? "turns by" : "turn by"),
      .where = {.key = keys.first_near_half_turn},
      .numbers = {{"steps", static_cast<double>(keys.near_half_turns)}}}};
}

std::vector<Warning> warnings_of(const Method& method, const Track& track, const AnyCurve* made) {
  std::vector<Warning> warnings;
  for (Warning& warning : warnings_of(track.keys.report())) warnings.push_back(track.located(std::move(warning)));
  const auto family = family_of_method(method);
  if (!family) return warnings;
  const Method shaped = completed(method, **family, track);
  std::optional<AnyCurve> made_now;
  const auto curve = [&]() -> const AnyCurve* {
    if (made) return made;
    if (!made_now)
      if (auto now = make_curve(shaped, track.keys)) made_now = *std::move(now);
    return made_now ? &*made_now : nullptr;
  };
  for (const auto& warning :
       {contradicting_rates(**family, track.keys), contradicting_accelerations(**family, track.keys),
        closing_step(shaped, track.keys), overwound(shaped, track.keys),
        moving_rests(shaped, **family, track.keys, curve), jumps_at_keys(shaped, curve),
        corners_at_keys(shaped, track.keys), odd_span(shaped, **family, track, made)})
    if (warning) warnings.push_back(track.located(*warning));
  return warnings;
}

}}  // namespace orispline
