// SPDX-License-Identifier: Apache-2.0
// Families of curves of one's own, as classes: blending functions with a tension, and a curve that is no product of
// any. Each is a method for every task. As data, without C++: docs/own-blending.md.

#include <cstdio>
#include <vector>

#include <orispline/analysis.hpp>
#include <orispline/orispline.hpp>
#include <orispline/own_curves.hpp>
#include <orispline/reduce.hpp>
#include <orispline/retime.hpp>
#include <orispline/tune.hpp>

namespace {

using orispline::FamilyInfo;

/// A cubic with the rate tension (a + b)/h at a key, a and b being the increments beside it: C1 on even keys.
struct Cardinal {
  static constexpr std::array parameters{orispline::tunable(orispline::resting_at_zero({"tension", 0.5, -10.0, 10.0}))};
  static constexpr FamilyInfo info{.name = "cardinal",
                                   .title = "Cumulative cardinal spline",
                                   .source = "this example",
                                   .continuity_uniform = 1,
                                   .keeps_constant_rate_uniform = true,
                                   .support_keys = 4,
                                   .parameters = parameters,
                                   .ends = orispline::four_key_ends_repeat,
                                   .closes = true};

  struct Basis {
    static constexpr std::size_t increments = 3, stride = 1;
    static constexpr int degree = 3;
    orispline::PerKey tension;

    /// Bernstein coefficients of the three functions on one segment.
    [[nodiscard]] orispline::BernsteinRows<3, 4> coefficients(orispline::KnotSpan span) const {
      const double a = tension[span.i] / 3.0, b = tension[span.i + 1] / 3.0;
      return {{{1.0, 1.0 + a, 1.0, 1.0}, {0.0, a, 1.0 - b, 1.0}, {0.0, 0.0, -b, 0.0}}};
    }

    template <orispline::Number T>
    [[nodiscard]] std::array<T, 3> operator()(orispline::KnotSpan span, const T& t) const {
      return orispline::bernstein_sums(coefficients(span), span.normalised(t));
    }
  };

  [[nodiscard]] static Basis basis(const orispline::FamilySettings& settings) { return {settings.per_key("tension")}; }
};

/// From key to key along the geodesic, with a speed that begins and ends at rest: C1, a stop at every key.
struct Stops {
  static constexpr FamilyInfo info{.name = "stops",
                                   .title = "Stop at every key",
                                   .source = "this example",
                                   .continuity_uniform = 1,
                                   .continuity_uneven = 1,
                                   .continuity_of_shape = 0,
                                   .support_keys = 2};

  template <orispline::CurvePoint P>
  class Curve {
   public:
    Curve(orispline::Knots knots, std::vector<P> points) : knots_(std::move(knots)), points_(std::move(points)) {}

    [[nodiscard]] const orispline::Knots& knots() const { return knots_; }

    /// The derivatives follow from this: T is also a number that carries them.
    template <orispline::Number T>
    [[nodiscard]] orispline::PointOver<P, T> point(const T& t, std::size_t segment) const {
      const T u = knots_.span(segment).normalised(t);
      const T way = u * u * (T(3.0) - u * 2.0);
      return orispline::on_geodesic(orispline::constant<T>(points_[segment]),
                                    orispline::constant<T>(points_[segment + 1]), way);
    }

   private:
    orispline::Knots knots_;
    std::vector<P> points_;
  };

  template <orispline::CurvePoint P>
  [[nodiscard]] static orispline::Expected<Curve<P>> curve(const orispline::Keyframes& keys,
                                                           const orispline::FamilySettings&) {
    const auto points = keys.points<P>();
    return Curve<P>(orispline::key_knots(keys), {points.begin(), points.end()});
  }
};

/// A recording of six seconds.
orispline::Expected<orispline::Keyframes> recorded() {
  orispline::KeyframeData data;
  for (int i = 0; i <= 240; ++i) {
    const double t = 0.025 * i;
    data.times.push_back(t);
    data.orientations.push_back(orispline::exp(Eigen::Vector3d(std::sin(t), 0.3 * t, std::cos(0.7 * t))));
  }
  return orispline::Keyframes::make(data);
}

/// Each method through every 12th sample, beside all samples.
void compared(const orispline::Keyframes& recording, const std::vector<orispline::Method>& methods) {
  orispline::KeyframeData kept;
  for (std::size_t i = 0; i < recording.size(); i += 12) {
    kept.times.push_back(recording.times()[i]);
    kept.orientations.push_back(recording.orientations()[i]);
  }
  const auto keys = orispline::Keyframes::make(kept);
  std::vector<orispline::Candidate> candidates;
  for (const orispline::Method& method : methods) candidates.push_back({method, *keys});
  const auto comparison = orispline::compare(candidates, {recording.times(), recording.orientations()});
  for (std::size_t i = 0; i < methods.size(); ++i)
    std::printf("%-9s %.5f rad off at most, C%d in time\n", methods[i].name.c_str(),
                comparison.measures[i]->distance.largest, comparison.measures[i]->continuity.order());
}

/// Its tensions, the fewest keys, and a motion within a limit.
orispline::Expected<void> optimised(const orispline::Keyframes& recording, const orispline::Method& method) {
  const auto reduction = orispline::reduce(recording, method, {.tolerance = {.angle = 0.02}});
  if (!reduction) return tl::unexpected(reduction.error());
  std::printf("reduce: %zu of %zu keys\n", reduction->track.keys.size(), recording.size());
  const auto tuning = orispline::tune(reduction->track, method);
  if (!tuning) return tl::unexpected(tuning.error());
  std::printf("tune: %s energy\n", tuning->energy_after < tuning->energy_before ? "less" : "the same");
  const auto retiming = orispline::retime(reduction->track, method, {.limits = {.rate = 0.5}});
  if (!retiming) return tl::unexpected(retiming.error());
  std::printf("retime: slowed by %.1f\n", retiming->time_scale);
  return {};
}

}  // namespace

int main() {
  const auto recording = recorded();
  if (!recording) return std::fprintf(stderr, "%s\n", describe(recording.error()).c_str()), 1;
  const auto cardinal = orispline::own_method<Cardinal>(), stops = orispline::own_method<Stops>();
  compared(*recording, {"auto", cardinal, stops});
  if (const auto done = optimised(*recording, cardinal); !done)
    return std::fprintf(stderr, "%s\n", describe(done.error()).c_str()), 1;
}
