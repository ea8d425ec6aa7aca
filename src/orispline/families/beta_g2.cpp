// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta_g2.hpp>

#include <orispline/curve/beta_polygon.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/points_through.hpp>
#include <orispline/families/beta_g2_handles.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

using Betas = BetasOver<double>;

Expected<BetaShape> shape_of(const Betas& betas) { return beta_shape(BetaG2::info.name, betas.beta1, betas.beta2); }

// ------------------------------------------------------------------ local: the published curve, corrected

/// Of every segment. Corrections before do not change them, for they vanish at u = 1.
std::vector<Eigen::Vector3d> corrections(const ControlPolygon<>& published, const Betas& betas) {
  const auto cubic = [&](std::size_t i) {
    const auto* of = published.increments.data() + 3 * i;
    return std::array<Eigen::Vector3d, 3>{of[0], of[1], of[2]};
  };
  std::vector<Eigen::Vector3d> lacking{Eigen::Vector3d::Zero()};
  for (std::size_t i = 1; i < published.bases.size(); ++i)
    lacking.push_back(lacking_acceleration<double>(cubic(i - 1), cubic(i), betas.beta1[i + 1], betas.beta2[i + 1]));
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
Expected<HandleChain<P>> solved_handles(std::span<const P> keys, const Betas& betas) {
  return solve_chain(BetaG2::info.name, [&](double share, const HandleChain<P>* before) {
    return HandleChain<P>(with_steps_of(share, keys), betas, before);
  });
}

}  // namespace

Expected<HandleChain<Eigen::Quaterniond>> BetaG2::handles(const Keyframes& keys, const FamilySettings& settings) {
  return solved_handles(keys.orientations(), betas_of(settings, keys.size()));
}

Expected<CumulativeCurve<BetaG2::Basis>> BetaG2::curve(const Keyframes& keys, const FamilySettings& settings) {
  const Betas betas = betas_of(settings, keys.size());
  const auto q = keys.orientations();
  const auto shape = shape_of(betas);
  if (!shape) return tl::unexpected(shape.error());
  if (!is_global(settings)) {
    const ControlPolygon<> published = beta_polygon(q, *shape);
    return CumulativeCurve<Basis>(inner_key_knots(keys), Basis{},
                                  with_corrections(published, corrections(published, betas)));
  }
  return solved_handles(q, betas).map([&](const HandleChain<Eigen::Quaterniond>& chain) {
    ControlPolygon<> cubic{.bases = {q.begin(), q.end() - 1}, .increments = {}};
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
      const auto increments = chain.increments(i);
      cubic.increments.insert(cubic.increments.end(), increments.begin(), increments.end());
    }
    const std::vector<Eigen::Vector3d> none(q.size() - 1, Eigen::Vector3d::Zero());
    return CumulativeCurve<Basis>(key_knots(keys), Basis{}, with_corrections(cubic, none));
  });
}

Expected<CubicBezierPath> BetaG2::path(const Keyframes& keys, const FamilySettings& settings) {
  const Betas betas = betas_of(settings, keys.size());
  const auto p = keys.positions();
  const auto shape = shape_of(betas);
  if (!shape) return tl::unexpected(shape.error());
  if (!is_global(settings))  // in space the published curve is G2 by itself
    return CubicBezierPath(inner_key_knots(keys), CubicBezierBasis{}, beta_polygon(p, *shape));
  const UnitPositions unit(p);
  return solved_handles<Eigen::Vector3d>(unit.points, betas).map([&](const HandleChain<Eigen::Vector3d>& chain) {
    std::vector<Eigen::Vector3d> points{p[0]};
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      points.push_back(p[i] + unit.extent * chain.increments(i)[0]);
      points.push_back(p[i + 1] - unit.extent * chain.handles()[i + 1]);
      points.push_back(p[i + 1]);
    }
    return CubicBezierPath(key_knots(keys), CubicBezierBasis{}, points);
  });
}

}}}  // namespace orispline::families
