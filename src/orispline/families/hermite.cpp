// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/hermite.hpp>

#include <algorithm>
#include <numbers>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/window_polynomial.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// Steps nearer than this to a full turn [rad] have no rotation vector that rates could be carried to.
constexpr double full_turn_margin = 1e-6;

/// How far from its key a piece may wind [rad]: there rounding turns it by some 1e-6 rad, and so much more as its keys
/// are near each other. Still farther away it would no longer be a curve of these keys.
constexpr double widest_winding = 1e10;

/// That the piece after key i does not wind farther: it comes no farther than all these turns together.
template <std::size_t N>
Expected<void> check_winding(std::string_view method, std::size_t i, const std::array<Eigen::Vector3d, N>& turns) {
  double winding = 0.0;
  for (const Eigen::Vector3d& turn : turns) winding += turn.norm();
  if (winding <= widest_winding) return {};
  return failure(ErrorCode::bad_data,
                 formatted("{}: the rates at this key and the next one wind the curve between the two by up to {:.2g} "
                           "rad, so far that rounding shows in its orientation, wanted {:g} at most; correct the times "
                           "or rates of the keys around, put keys in between, or take slerp or squad",
                           method, winding, widest_winding),
                 {.key = i});
}

std::size_t reach_of(const FamilySettings& settings) { return settings.choice("stencil") == "3" ? 1 : 2; }

/// The derivatives of orders 1…3 at key i of the polynomial through the nearest keys as they are seen from it.
template <CurvePoint P>
std::array<Displacement<P>, 3> stencil_derivatives(const Keyframes& keys, std::size_t i, std::size_t reach) {
  const Window window = shifted_window(
      keys.times(), i, reach,
      [p = keys.points<P>()](std::size_t from, std::size_t to) { return displacement<double>(p[from], p[to]); });
  return WindowPolynomial(window).derivatives();
}

/// The key's orientation with its own rates where it has them, else, and where they are free, with those of the
/// stencil.
KeyMotion motion_at(const Keyframes& keys, std::size_t i, std::size_t reach) {
  KeyMotion key{keys.orientations()[i],
                body_rates(Eigen::Vector3d::Zero(), stencil_derivatives<Eigen::Quaterniond>(keys, i, reach))};
  const std::array given{keys.angular_velocities(), keys.angular_accelerations(), keys.angular_jerks()};
  for (std::size_t k = 0; k < given.size(); ++k)
    if (!given[k].empty() && !is_free(given[k][i])) key.rates[k] = given[k][i];
  return key;
}

std::vector<KeyMotion> motions_at_keys(const Keyframes& keys, const FamilySettings& settings) {
  std::vector<KeyMotion> motions;
  motions.reserve(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) motions.push_back(motion_at(keys, i, reach_of(settings)));
  return motions;
}

}  // namespace

template <std::size_t K>
Expected<ChartCurve<2 * K + 1>> Hermite<K>::chart(const Keyframes& keys, const FamilySettings& settings) {
  Knots knots = key_knots(keys);
  const auto motions = motions_at_keys(keys, settings);
  std::vector<ChartPiece<2 * K + 1>> pieces;
  pieces.reserve(knots.segments());
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const KeyMotion &start = motions[i], &end = motions[i + 1];
    const Eigen::Vector3d step = increment<double>(start.orientation, end.orientation);
    if (step.norm() > 2.0 * std::numbers::pi - full_turn_margin)
      return failure(ErrorCode::bad_data,
                     formatted("{}: the step to the next key is a full turn, which has no axis; put a key in between, "
                               "or set form=cumulative",
                               info.name),
                     {.key = i});
    pieces.push_back(hermite_piece<K>(start.orientation, step, start.rates, end.rates, knots.span(i).step()));
    if (const auto sound = check_winding(info.name, i, pieces.back().coefficients); !sound)
      return tl::unexpected(sound.error());
  }
  return ChartCurve<2 * K + 1>(std::move(knots), std::move(pieces));
}

template <std::size_t K>
auto Hermite<K>::cumulative(const Keyframes& keys, const FamilySettings& settings) -> Expected<Cumulative> {
  Knots knots = key_knots(keys);
  const auto motions = motions_at_keys(keys, settings);
  ControlPolygon<> polygon{.bases = {keys.orientations().begin(), keys.orientations().end() - 1}, .increments = {}};
  polygon.increments.reserve((2 * K + 1) * knots.segments());
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const auto increments = cumulative_hermite_increments<K>(motions[i], motions[i + 1], knots.span(i).step());
    if (const auto sound = check_winding(info.name, i, increments); !sound) return tl::unexpected(sound.error());
    polygon.increments.insert(polygon.increments.end(), increments.begin(), increments.end());
  }
  return Cumulative(std::move(knots), {}, std::move(polygon));
}

template <std::size_t K>
Expected<AnyCurve> Hermite<K>::curve(const Keyframes& keys, const FamilySettings& settings) {
  const auto any = [](auto curve) { return AnyCurve(std::move(curve)); };
  return settings.choice("form") == "cumulative" ? cumulative(keys, settings).map(any) : chart(keys, settings).map(any);
}

template <std::size_t K>
Expected<HermitePath<2 * K + 1>> Hermite<K>::path(const Keyframes& keys, const FamilySettings& settings) {
  const auto p = keys.positions();
  std::vector<typename HermitePath<2 * K + 1>::Derivatives> derivatives(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto all = stencil_derivatives<Eigen::Vector3d>(keys, i, reach_of(settings));
    std::copy_n(all.begin(), K, derivatives[i].begin());
  }
  return HermitePath<2 * K + 1>(key_knots(keys), {p.begin(), p.end()}, std::move(derivatives));
}

template struct Hermite<1>;
template struct Hermite<2>;
template struct Hermite<3>;

}}}  // namespace orispline::families
