// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retimed_method.hpp>

#include <string>
#include <utility>

#include <orispline/analysis/continuity.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Whether slowing can bring what is limited within limits at all: where a derivative jumps, the next one is infinite.
/// `order`: of the highest derivative that must not jump, 1 for ω, 2 for α.
Expected<void> check_continuity(const FamilyInfo& family, const Method& method, const Keyframes& keys, int order,
                                Slowing slowing) {
  const std::string_view jumping = order == 1 ? "angular velocity" : "angular acceleration",
                         limited = order == 1 ? "acceleration or torque" : "jerk";
  const auto refused = [&](std::string_view why, const std::string& wanted) {
    return failure(ErrorCode::bad_argument,
                   formatted("{}: its {} jumps at keys{}, which no slowing brings within a limit of {}, wanted {}",
                             family.name, jumping, why, limited, wanted));
  };
  const auto is_smooth_here = [&](std::string_view why, const std::string& wanted) {
    return make_curve(method, keys).and_then([&](const AnyCurve& curve) -> Expected<void> {
      if (continuity_at_keys(curve).order() >= order) return {};
      return refused(why, wanted);
    });
  };
  const bool as_promised = method.options.parameters.empty() && method.options.choices.empty();
  if (family.continuity_uneven >= order && as_promised) return {};
  if (family.continuity_uneven >= order)
    return is_smooth_here(" with these settings", formatted("others, with which it is C{}", order));
  if (family.continuity_uniform < order) return refused("", formatted("a method that is C{}, such as auto", order));
  if (slowing != Slowing::uniform)
    return refused(" whose times are uneven",
                   formatted("all intervals slowed alike, or a method that is C{} on any, such as auto", order));
  return is_smooth_here(" whose times are uneven, as these are",
                        formatted("even ones, or a method that is C{} on any, such as auto", order));
}

/// Whether keys of a method may get other times at all. Errors: those of retime().
Expected<void> check_motion(const FamilyInfo& family, const Method& method, const Keyframes& keys) {
  const auto refused = [](std::string message) { return failure(ErrorCode::bad_argument, std::move(message)); };
  if (family.rate_orders > 0)
    return refused(formatted("{}: this method takes rates from the keys, wanted one that has its own", family.name));
  if (method.options.loop) return refused(formatted("{}: loops are not slowed, wanted an open curve", family.name));
  for (const End& end : {method.options.start, method.options.end})
    if (!end.angular_velocity.isZero(0.0))
      return refused(
          formatted("{}: found a rate at an end, which slowing would change, wanted an end rule without "
                    "one, such as natural or rest",
                    family.name));
  if (keys.size() < 2) return failure(ErrorCode::bad_data, "found 1 key, wanted 2 at least: one key does not move");
  return {};
}

/// Whether slowing can bring what is limited within limits: where a derivative jumps, the next one is infinite; and
/// whether there is a position where one is limited. Errors: those of retime().
Expected<void> check_limits(const FamilyInfo& family, const Method& method, const Keyframes& keys,
                            const RetimeOptions& options) {
  const MotionLimits& limits = options.limits;
  if (keys.positions().empty() && options.constant_speed)
    return bad_option("constant_speed", "the keys have no positions, wanted px,py,pz as well");
  if (keys.positions().empty() && limits.speed)
    return bad_option("max_speed", "the keys have no positions, wanted px,py,pz as well");
  if (keys.positions().empty() && limits.linear_acceleration)
    return bad_option("max_linear_acceleration", "the keys have no positions, wanted px,py,pz as well");
  const int order = limits.jerk ? 2 : limits.acceleration || limits.torque || limits.linear_acceleration ? 1 : 0;
  return order == 0 ? Expected<void>() : check_continuity(family, method, keys, order, options.slowing);
}

}  // namespace

Expected<void> check_retimed(const FamilyInfo& family, const Method& method, const Keyframes& keys,
                             const RetimeOptions& options) {
  return check_motion(family, method, keys).and_then([&] { return check_limits(family, method, keys, options); });
}

}}  // namespace orispline
