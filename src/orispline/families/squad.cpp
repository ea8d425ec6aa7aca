// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/squad.hpp>

namespace orispline::families {
namespace {

using Quaternions = std::vector<Eigen::Quaterniond>;

/// The rotation vectors from key i to its neighbours; at an end the missing one by the end rule.
struct Neighbours {
  Eigen::Vector3d next, previous;
};

Neighbours neighbours_of(const Keyframes& keys, std::size_t i, const FamilySettings& settings) {
  const auto q = keys.orientations();
  const std::size_t last = q.size() - 1;
  const auto to = [&](std::size_t j) { return increment<double>(q[i], q[j]); };
  const auto ghost = [](EndRule rule, const Eigen::Vector3d& inward) -> Eigen::Vector3d {
    return rule == EndRule::reflect ? Eigen::Vector3d(-inward) : Eigen::Vector3d::Zero();
  };
  if (i == 0) return {.next = to(1), .previous = ghost(settings.start.rule, to(1))};
  if (i == last) return {.next = ghost(settings.end.rule, to(last - 1)), .previous = to(last - 1)};
  return {.next = to(i + 1), .previous = to(i - 1)};
}

Eigen::Quaterniond moved(const Eigen::Quaterniond& q, const Eigen::Vector3d& by) { return q * exp<double>(by); }

}  // namespace

SquadCurve::SquadCurve(const Keyframes& keys, const Quaternions& leaving, const Quaternions& arriving)
    : knots_({keys.times().begin(), keys.times().end()}) {
  const auto q = keys.orientations();
  pieces_.reserve(q.size() - 1);
  for (std::size_t i = 0; i + 1 < q.size(); ++i)
    pieces_.push_back({.key = q[i],
                       .inner = leaving[i],
                       .key_increment = increment<double>(q[i], q[i + 1]),
                       .inner_increment = increment<double>(leaving[i], arriving[i + 1])});
}

Expected<SquadCurve> Squad::curve(const Keyframes& keys, const FamilySettings& settings) {
  const auto q = keys.orientations();
  const std::size_t last = q.size() - 1;
  const auto is_bare = [&](std::size_t i) {
    return (i == 0 && settings.start.rule == EndRule::key) || (i == last && settings.end.rule == EndRule::key);
  };
  Quaternions inner;
  inner.reserve(q.size());
  for (std::size_t i = 0; i <= last; ++i) {
    const Neighbours n = neighbours_of(keys, i, settings);
    inner.push_back(is_bare(i) ? q[i] : moved(q[i], -0.25 * (n.next + n.previous)));
  }
  return SquadCurve(keys, inner, inner);
}

Expected<SquadCurve> SquadTimed::curve(const Keyframes& keys, const FamilySettings& settings) {
  const auto q = keys.orientations();
  const auto t = keys.times();
  Quaternions leaving, arriving;
  leaving.reserve(q.size());
  arriving.reserve(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Neighbours n = neighbours_of(keys, i, settings);
    const bool first = i == 0, last = i + 1 == q.size();
    const double before = first ? t[1] - t[0] : t[i] - t[i - 1];  // ghosts stand at the mirrored distance
    const double after = last ? before : t[i + 1] - t[i];
    const double both = before + after;
    leaving.push_back(moved(q[i], -after / (2.0 * both) * (n.next + after / before * n.previous)));
    arriving.push_back(moved(q[i], -before / (2.0 * both) * (before / after * n.next + n.previous)));
  }
  return SquadCurve(keys, leaving, arriving);
}

}  // namespace orispline::families
