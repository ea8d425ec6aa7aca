// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include <orispline/edit/channel_path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The geodesic from one curve to another, with a share that goes from 0 to 1 by a quintic. Its rates are exact.
template <CurvePoint P>
class BlendedChannel {
 public:
  /// Precondition: both curves span the domain.
  BlendedChannel(AnyCurveThrough<P> from, AnyCurveThrough<P> to, Domain over)
      : from_(std::move(from)), to_(std::move(to)), over_(over), knots_(knots_of(from_.knots(), to_.knots(), over)) {
    for (std::size_t i = 0; i < knots_.segments(); ++i) {
      const double middle = 0.5 * (knots_.span(i).start() + knots_.span(i).end());
      segments_.emplace_back(from_.knots().segment_at(middle), to_.knots().segment_at(middle));
    }
    const double middle = 0.5 * (over.start + over.end);
    if constexpr (std::same_as<P, Eigen::Quaterniond>) sign_ = from_(middle).dot(to_(middle)) < 0.0 ? -1.0 : 1.0;
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  [[nodiscard]] P point(double t, std::size_t segment) const noexcept {
    const auto [from, to] = segments_[segment];
    return between<double>(point_of(motion_on(from_, from, t)), point_of(motion_on(to_, to, t)), t);
  }
  [[nodiscard]] PointOver<P, Jet<double, 3>> point(const Jet<double, 3>& t, std::size_t segment) const noexcept {
    const auto [from, to] = segments_[segment];
    const Jet<double, 3> h = t - t.c[0];
    return between<Jet<double, 3>>(taylor(motion_on(from_, from, t.c[0]), h), taylor(motion_on(to_, to, t.c[0]), h), t);
  }

 private:
  template <Number T>
  [[nodiscard]] PointOver<P, T> between(const PointOver<P, T>& from, PointOver<P, T> to, const T& t) const noexcept {
    const T u = (t - T(over_.start)) / (over_.end - over_.start);
    const T share = u * u * u * (T(10.0) - u * (T(15.0) - T(6.0) * u));
    if constexpr (std::same_as<P, Eigen::Quaterniond>) to.coeffs() *= T(sign_);
    return on_geodesic<T>(from, to, share);
  }

  static Knots knots_of(const Knots& a, const Knots& b, Domain over) {
    std::vector<double> times{over.start, over.end};
    for (const Knots* const knots : {&a, &b})
      for (const double t : knots->times())
        if (t > over.start && t < over.end) times.push_back(t);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return Knots(std::move(times));
  }

  AnyCurveThrough<P> from_, to_;
  Domain over_;
  Knots knots_;
  std::vector<std::pair<std::size_t, std::size_t>> segments_{};  ///< of both curves
  double sign_ = 1.0;
};

}}  // namespace orispline
