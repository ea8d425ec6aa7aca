// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/squad.hpp>

#include <array>
#include <span>

#include <orispline/curve/one_axis.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

Eigen::Vector3d SquadCurve::inner_increment(const Eigen::Quaterniond& key, const Eigen::Quaterniond& leaving,
                                            const Eigen::Vector3d& step, const Eigen::Quaterniond& next,
                                            const Eigen::Quaterniond& arriving) noexcept {
  const Eigen::Vector3d first = increment<double>(key, leaving), last = increment<double>(next, arriving);
  const Eigen::Vector3d along = step + last - first;
  const bool round = wraps(along) && have_one_axis(std::array{first, step, last});
  return round ? increment_near(along, leaving, arriving) : increment<double>(leaving, arriving);
}

namespace {

/// The rotation vectors from key i to its neighbours; at an end the missing one by the end rule.
struct Neighbours {
  Eigen::Vector3d next, previous;
};

Neighbours neighbours_of(const Keyframes& keys, std::size_t i, const FamilySettings& settings) {
  const auto q = keys.orientations();
  const std::size_t last = q.size() - 1;
  // Backwards along the arc that arrives: of a full turn the logarithm could not tell which way it was.
  const auto to = [&](std::size_t j) -> Eigen::Vector3d {
    return j > i ? increment<double>(q[i], q[j]) : Eigen::Vector3d(-increment<double>(q[j], q[i]));
  };
  const auto ghost = [](EndRule rule, const Eigen::Vector3d& inward) -> Eigen::Vector3d {
    const bool continued =
        rule == EndRule::reflect || rule == EndRule::natural;  // with one key inwards they are one rule
    return continued ? Eigen::Vector3d(-inward) : Eigen::Vector3d::Zero();
  };
  if (i == 0) return {.next = to(1), .previous = ghost(settings.start.rule, to(1))};
  if (i == last) return {.next = ghost(settings.end.rule, to(last - 1)), .previous = to(last - 1)};
  return {.next = to(i + 1), .previous = to(i - 1)};
}

/// The rotation vector from key i to the inner quaternion of Eberly, (22), or of the end rule.
Eigen::Vector3d chosen_handle(const Keyframes& keys, std::size_t i, const FamilySettings& settings) {
  const bool bare =
      (i == 0 && settings.start.rule == EndRule::key) || (i == keys.size() - 1 && settings.end.rule == EndRule::key);
  if (bare) return Eigen::Vector3d::Zero();
  const Neighbours n = neighbours_of(keys, i, settings);
  return -0.25 * (n.next + n.previous);
}

/// That to the inner quaternion which the key is given, else the chosen one.
Eigen::Vector3d handle_to(std::span<const Eigen::Quaterniond> given, const Keyframes& keys, std::size_t i,
                          const Eigen::Vector3d& chosen) {
  const bool is_given = !given.empty() && !is_free_inner(given[i]);
  return is_given ? increment<double>(keys.orientations()[i], given[i]) : chosen;
}

}  // namespace

Expected<SquadCurve> Squad::curve(const Keyframes& keys, const FamilySettings& settings) {
  return SquadCurve(keys, [&](std::size_t i) -> SquadCurve::Handles {
    const Eigen::Vector3d chosen = chosen_handle(keys, i, settings);
    return {.leaving = handle_to(keys.inner_leaving(), keys, i, chosen),
            .arriving = handle_to(keys.inner_arriving(), keys, i, chosen)};
  });
}

namespace {

/// The handles of key i.
auto timed_handles(const Keyframes& keys, const FamilySettings& settings) {
  const auto t = keys.times();
  const std::size_t last = keys.size() - 1;
  const bool boyle = settings.choice("variant") == "boyle";
  return [=, &keys, &settings](std::size_t i) -> SquadCurve::Handles {
    const Neighbours n = neighbours_of(keys, i, settings);
    const double before = i == 0 ? t[1] - t[0] : t[i] - t[i - 1];  // ghosts stand at the mirrored distance
    const double after = i == last ? before : t[i + 1] - t[i];
    const double leaving = boyle ? 0.25 : 0.5 * after / (before + after);
    const double arriving = boyle ? 0.25 : 0.5 * before / (before + after);
    return {.leaving = -leaving * (n.next + after / before * n.previous),
            .arriving = -arriving * (before / after * n.next + n.previous)};
  };
}

}  // namespace

Expected<SquadCurve> SquadTimed::curve(const Keyframes& keys, const FamilySettings& settings) {
  return SquadCurve(keys, timed_handles(keys, settings));
}

HandleTurn SquadTimed::widest_handle(const Keyframes& keys, const FamilySettings& settings) {
  return orispline::widest_handle(keys.size(), timed_handles(keys, settings));
}

}}}  // namespace orispline::families
