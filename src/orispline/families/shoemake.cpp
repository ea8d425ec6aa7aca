// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/shoemake.hpp>

#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// The step after a key to the step before it, as the rule has it.
double ratio_of(double before, double after, std::string_view timing) {
  return timing == "time" ? after / before : 1.0;
}

/// The rates with which the handles of every key lie, for orientations or positions.
///
/// a_i = slerp(slerp(p_{i-1}, p_i; 1 + h₊/h₋), p_{i+1}; h₋/(h₋+h₊)) is where the leaving handle points; the arriving
/// one lies opposite, longer by h₋/h₊. The published rule has h₋ = h₊ = 1 there: Double, then Bisect.
template <CurvePoint Point>
HandleRates handle_rates(std::span<const Point> points, std::span<const double> times, std::string_view timing) {
  const auto p = reflected(points);
  const auto t = reflected(times);
  HandleRates rates;
  for (std::ptrdiff_t i = 0; i < std::ssize(points); ++i) {
    const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    const double ratio = ratio_of(before, after, timing);
    const Point continued = displaced<double>(p[i], ratio * displacement<double>(p[i - 1], p[i]));
    const Point target = on_geodesic<double>(continued, p[i + 1], 1.0 / (1.0 + ratio));
    const Eigen::Vector3d way = displacement<double>(p[i], target);
    rates.leaving.push_back(way / after);
    rates.arriving.push_back(way / (ratio * before));
  }
  return rates;
}

}  // namespace

template <CurvePoint P>
Expected<HandleCurve<P>> Shoemake::curve(const Keyframes& keys, const FamilySettings& settings) {
  const HandleRates rates = handle_rates(keys.points<P>(), keys.times(), settings.choice("timing"));
  return handle_curve(key_knots(keys), keys.points<P>(), rates.leaving, rates.arriving);
}

template Expected<HandleCurve<Eigen::Quaterniond>> Shoemake::curve<Eigen::Quaterniond>(const Keyframes&,
                                                                                       const FamilySettings&);
template Expected<HandleCurve<Eigen::Vector3d>> Shoemake::curve<Eigen::Vector3d>(const Keyframes&,
                                                                                 const FamilySettings&);

HandleTurn Shoemake::widest_handle(const Keyframes& keys, const FamilySettings& settings) {
  const auto q = keys.orientations();
  const auto t = keys.times();
  const std::string_view timing = settings.choice("timing");
  HandleTurn widest = orispline::widest_handle(t, handle_rates(q, t, timing));
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double ratio = ratio_of(t[i] - t[i - 1], t[i + 1] - t[i], timing);
    widest = wider_of(widest, {i, ratio * increment<double>(q[i - 1], q[i]).norm()});
  }
  return widest;
}

}}}  // namespace orispline::families
