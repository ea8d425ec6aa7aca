// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta_g2.hpp>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/points_through.hpp>
#include <orispline/families/beta_g2_handles.hpp>
#include <orispline/families/betas.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

// ------------------------------------------------------------------ local: the published curve, corrected

/// Of every segment; that behind an open start needs none. Corrections before do not change them, for they vanish at
/// u = 1.
std::vector<Eigen::Vector3d> corrections(const ControlPolygon<>& published, const Betas& auxiliary,
                                         const FamilySettings& settings) {
  const auto cubic = [&](std::size_t i) {
    const auto* of = published.increments.data() + 3 * i;
    return std::array<Eigen::Vector3d, 3>{of[0], of[1], of[2]};
  };
  const std::size_t segments = published.bases.size();
  std::vector<Eigen::Vector3d> lacking(segments, Eigen::Vector3d::Zero());
  for (std::size_t i = settings.closure ? 0 : 1; i < segments; ++i)
    lacking[i] = lacking_acceleration<double>(cubic((i + segments - 1) % segments), cubic(i), auxiliary.beta1[i + 1],
                                              auxiliary.beta2[i + 1]);
  return lacking;
}

/// A polygon of cubic segments, each with its correction behind it.
ControlPolygon<> with_corrections(const ControlPolygon<>& cubic, const std::vector<Eigen::Vector3d>& corrections) {
  ControlPolygon<> polygon{.bases = cubic.bases, .increments = {}};
  for (std::size_t i = 0; i < cubic.bases.size(); ++i) {
    const auto* segment = cubic.increments.data() + 3 * i;
    polygon.increments.insert(polygon.increments.end(), segment, segment + 3);
    polygon.increments.push_back(corrections[i]);
  }
  return polygon;
}

// ------------------------------------------------------------------ global: handles solved for

template <CurvePoint P>
Expected<HandleChain<P>> solved_handles(std::span<const P> keys, const FamilySettings& settings) {
  return solve_chain(BetaG2::info.name, [&](double share, const HandleChain<P>* before) {
    return HandleChain<P>(with_steps_of(share, keys), betas_of(settings, keys.size()), settings.closure, before);
  });
}

}  // namespace

Expected<HandleChain<Eigen::Quaterniond>> BetaG2::handles(const Keyframes& keys, const FamilySettings& settings) {
  return solved_handles(keys.orientations(), settings);
}

Expected<CumulativeCurve<BetaG2::Basis>> BetaG2::curve(const Keyframes& keys, const FamilySettings& settings) {
  const auto q = keys.orientations();
  const auto shape = auxiliary_shape(settings, keys.size());
  if (!shape) return tl::unexpected(shape.error());
  if (!is_global(settings)) {
    const auto published = published_polygon<Eigen::Quaterniond>(keys, settings, *shape);
    const auto lacking = corrections(published, auxiliary_betas(settings, keys.size()), settings);
    return CumulativeCurve<Basis>(published_knots(keys, settings), Basis{}, with_corrections(published, lacking));
  }
  return solved_handles(q, settings).map([&](const HandleChain<Eigen::Quaterniond>& chain) {
    ControlPolygon<> cubic;
    for (std::size_t i = 0; i < chain.segments(); ++i) {
      const auto increments = chain.increments(i);
      cubic.bases.push_back(q[i]);
      cubic.increments.insert(cubic.increments.end(), increments.begin(), increments.end());
    }
    const std::vector<Eigen::Vector3d> none(chain.segments(), Eigen::Vector3d::Zero());
    return CumulativeCurve<Basis>(four_key_knots(keys, settings), Basis{}, with_corrections(cubic, none));
  });
}

Expected<CubicBezierPath> BetaG2::path(const Keyframes& keys, const FamilySettings& settings) {
  const auto p = keys.positions();
  const auto shape = auxiliary_shape(settings, keys.size());
  if (!shape) return tl::unexpected(shape.error());
  if (!is_global(settings))  // in space the published curve is G2 by itself
    return CubicBezierPath(published_knots(keys, settings), CubicBezierBasis{},
                           published_polygon<Eigen::Vector3d>(keys, settings, *shape));
  const UnitPositions unit(p);
  return solved_handles<Eigen::Vector3d>(unit.points, settings).map([&](const HandleChain<Eigen::Vector3d>& chain) {
    std::vector<Eigen::Vector3d> points{p[0]};
    for (std::size_t i = 0; i < chain.segments(); ++i) {
      const std::size_t next = (i + 1) % p.size();
      points.push_back(p[i] + unit.extent * chain.increments(i)[0]);
      points.push_back(p[next] - unit.extent * chain.handles()[next]);
      points.push_back(p[next]);
    }
    return CubicBezierPath(four_key_knots(keys, settings), CubicBezierBasis{}, points);
  });
}

}}}  // namespace orispline::families
