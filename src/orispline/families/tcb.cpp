// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/tcb.hpp>

#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// Orientations or positions with what Kochanek and Bartels make of them.
template <CurvePoint Point>
class TangentRule {
 public:
  TangentRule(std::span<const Point> points, std::span<const double> times, const FamilySettings& settings)
      : points_(points),
        times_(times),
        tension_(settings.per_key("tension")),
        continuity_(settings.per_key("continuity")),
        bias_(settings.per_key("bias")) {}

  [[nodiscard]] HandleRates rates(const FamilySettings& settings) const {
    HandleRates all = natural_rates();
    const std::size_t last = points_.size() - 1;
    const bool at_start = settings.start.rule == EndRule::handle, at_end = settings.end.rule == EndRule::handle;
    if (last == 1 && at_start && at_end) {  // each handle in the middle between the other one and its key: thirds
      all.leaving[0] = all.arriving[1] = displacement<double>(points_[0], points_[1]) / (times_[1] - times_[0]);
      return all;
    }
    const Eigen::Vector3d arriving = all.arriving[1], leaving = all.leaving[last - 1];
    if (at_start) all.leaving[0] = halfway_rate(0, 1, arriving);
    if (at_end) all.arriving[last] = halfway_rate(last, last - 1, leaving);
    return all;
  }

 private:
  /// The rates at all keys, a reflected ghost beside either end.
  [[nodiscard]] HandleRates natural_rates() const {
    const auto p = reflected(points_);
    const auto t = reflected(times_);
    HandleRates all;
    for (std::size_t key = 0; key < points_.size(); ++key) {
      const auto i = static_cast<std::ptrdiff_t>(key);
      const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
      const double slack = (1.0 - tension_[key]) / (before + after), c = continuity_[key], b = bias_[key];
      const Eigen::Vector3d first = slack * after / before * (1.0 + b) * displacement<double>(p[i - 1], p[i]);
      const Eigen::Vector3d second = slack * before / after * (1.0 - b) * displacement<double>(p[i], p[i + 1]);
      all.leaving.push_back((1.0 + c) * first + (1.0 - c) * second);
      all.arriving.push_back((1.0 - c) * first + (1.0 + c) * second);
    }
    return all;
  }

  /// The rate at an end key whose handle lies halfway to the handle of its neighbour, which has that rate.
  [[nodiscard]] Eigen::Vector3d halfway_rate(std::size_t end, std::size_t neighbour,
                                             const Eigen::Vector3d& rate) const {
    const double step = times_[neighbour] - times_[end];  // negative at the last key
    const Point handle = displaced<double>(points_[neighbour], -step / 3.0 * rate);
    return 1.5 / step * displacement<double>(points_[end], handle);
  }

  std::span<const Point> points_;
  std::span<const double> times_;
  PerKey tension_, continuity_, bias_;
};

}  // namespace

template <CurvePoint P>
Expected<HandleCurve<P>> Tcb::curve(const Keyframes& keys, const FamilySettings& settings) {
  const HandleRates rates = TangentRule(keys.points<P>(), keys.times(), settings).rates(settings);
  return handle_curve(key_knots(keys), keys.points<P>(), rates.leaving, rates.arriving);
}

template Expected<HandleCurve<Eigen::Quaterniond>> Tcb::curve<Eigen::Quaterniond>(const Keyframes&,
                                                                                  const FamilySettings&);
template Expected<HandleCurve<Eigen::Vector3d>> Tcb::curve<Eigen::Vector3d>(const Keyframes&, const FamilySettings&);

HandleTurn Tcb::widest_handle(const Keyframes& keys, const FamilySettings& settings) {
  return orispline::widest_handle(keys.times(), handle_rates(keys, settings));
}

HandleRates Tcb::handle_rates(const Keyframes& keys, const FamilySettings& settings) {
  return TangentRule(keys.orientations(), keys.times(), settings).rates(settings);
}

}}}  // namespace orispline::families
