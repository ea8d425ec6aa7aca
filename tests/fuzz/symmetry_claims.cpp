// SPDX-License-Identifier: Apache-2.0
#include <functional>

#include <fuzz/claim.hpp>
#include <fuzz/curve_claims.hpp>
#include <fuzz/segment_scale.hpp>
#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

namespace orispline::fuzz {

namespace {

using testing_support::Dice;

const Eigen::Quaterniond turn = exp<double>(Eigen::Vector3d(1.3, -2.1, 0.4));

/// A change of the keys and of the method, and what it makes of a motion of the unchanged curve.
struct Change {
  const char* name;
  std::function<void(KeyframeData&, Method&)> of_keys;
  std::function<Motion(const Motion&)> of_motion;
  double time_scale = 1.0;
};

/// Calls it with every body rate that keys and method state, and its order.
void for_every_rate(KeyframeData& data, Method& method, const std::function<void(Eigen::Vector3d&, int)>& change) {
  int order = 0;
  for (auto* rates : {&data.angular_velocities, &data.angular_accelerations, &data.angular_jerks}) {
    ++order;
    for (Eigen::Vector3d& rate : *rates) change(rate, order);
  }
  change(method.options.start.angular_velocity, 1);
  change(method.options.end.angular_velocity, 1);
}

Change turned_world() {
  return {"turning the world",
          [](KeyframeData& data, Method&) {
            for (auto& q : data.orientations) q = turn * q;
          },
          [](Motion m) {
            m.orientation = turn * m.orientation;
            return m;
          }};
}

Change turned_body() {
  return {"turning the body",
          [](KeyframeData& data, Method& method) {
            for (auto& q : data.orientations) q = q * turn;
            for_every_rate(data, method, [](Eigen::Vector3d& rate, int) { rate = to_body<double>(turn, rate); });
          },
          [](const Motion& m) {
            return Motion{.orientation = m.orientation * turn,
                          .angular_velocity = to_body<double>(turn, m.angular_velocity),
                          .angular_acceleration = to_body<double>(turn, m.angular_acceleration),
                          .angular_jerk = to_body<double>(turn, m.angular_jerk)};
          }};
}

/// Exact, since 4 is a power of two.
Change slower_clock() {
  return {"a slower clock",
          [](KeyframeData& data, Method& method) {
            for (double& t : data.times) t *= 4.0;
            for_every_rate(data, method, [](Eigen::Vector3d& rate, int order) { rate /= std::pow(4.0, order); });
            if (method.options.loop) *method.options.loop->period *= 4.0;
          },
          [](Motion m) {
            m.angular_velocity /= 4.0;
            m.angular_acceleration /= 16.0;
            m.angular_jerk /= 64.0;
            return m;
          },
          4.0};
}

Change other_signs() {
  return {"signs of the keys",
          [](KeyframeData& data, Method&) {
            for (std::size_t i = 1; i < data.orientations.size(); i += 2) data.orientations[i].coeffs() *= -1.0;
          },
          [](const Motion& m) { return m; }};
}

using Motions = std::vector<Motion>;

Motions motions(const AnyCurve& curve, std::span<const double> times) {
  Motions all;
  for (const double t : times) all.push_back(curve.motion(t));
  return all;
}

/// Each key turned by up to this much [rad] in a direction of its own, as an experiment on what the curve makes of it:
/// some times what turning, normalising and rounding the keys do to them. Not more, since limits of rates and the
/// choice of the shorter way are no linear functions of the keys.
constexpr double disturbance = 32.0 * std::numeric_limits<double>::epsilon();
/// What other disturbances of that size may do beside those that were tried.
constexpr double beyond_experiment = 8.0;

class Symmetries {
 public:
  explicit Symmetries(const Specimen& specimen)
      : specimen_(specimen),
        times_(testing_support::sample_times(specimen.curve.orientation.knots().times(), times_of_segment)),
        wanted_(motions(specimen.curve.orientation, times_)) {}

  /// How far every order of every segment goes where the keys are disturbed; nothing where that is a leap, such as to
  /// the other way round, or makes another curve impossible: rounding may do the same there.
  [[nodiscard]] bool measure_sensitivity() {
    const std::size_t segments = specimen_.curve.orientation.knots().segments();
    sensitivity_.assign(segments, {});
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
      Dice dice(seed);
      const auto curve = changed([&](KeyframeData& data, Method&) {
        for (auto& q : data.orientations) q = q * exp<double>(disturbance * dice.vector());
      });
      if (!curve) return false;
      const Motions found = motions(*curve, times_);
      for (std::size_t i = 0; i < times_.size(); ++i) {
        const auto off = difference(found[i], wanted_[i]);
        if (!(off[0] <= 1e-4)) return false;
        auto& most = sensitivity_[segment(i)];
        for (std::size_t k = 0; k < 4; ++k) most[k] = std::max(most[k], off[k]);
      }
    }
    return true;
  }

  void claim_holds(const Change& change) const {
    const auto curve = changed(change.of_keys);
    claim(curve.has_value(), "{}: refused: {}", change.name, curve ? "" : describe(curve.error()));
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const Motion wanted = change.of_motion(wanted_[i]);
      const auto off = difference(curve->motion(times_[i] * change.time_scale), wanted);
      for (std::size_t k = 0; k < 4; ++k) {
        const double allowed = allowed_at(i, k) / std::pow(change.time_scale, k);
        claim(off[k] <= allowed, "{}: order {} at t = {} is another by {}, allowed {}", change.name, k, times_[i],
              off[k], allowed);
      }
    }
  }

 private:
  static constexpr std::size_t times_of_segment = 5;

  [[nodiscard]] std::size_t segment(std::size_t time) const {
    return std::min(time / times_of_segment, sensitivity_.size() - 1);
  }
  /// At a knot that of the segment before it counts too.
  [[nodiscard]] double allowed_at(std::size_t time, std::size_t order) const {
    double allowed = 0.0;
    for (std::size_t i = segment(time == 0 ? 0 : time - 1); i <= segment(time); ++i) {
      const SegmentScale scale = scale_of(specimen_.curve.orientation, i);
      allowed = std::max(allowed, closed_form_rounding * scale.of_order(static_cast<int>(order)) +
                                      beyond_experiment * sensitivity_[i][order]);
    }
    return allowed;
  }
  [[nodiscard]] Expected<AnyCurve> changed(const std::function<void(KeyframeData&, Method&)>& change) const {
    KeyframeData data = specimen_.fuzzed.data;
    Method method = specimen_.method;
    change(data, method);
    return Keyframes::make(std::move(data), specimen_.fuzzed.signs).and_then([&](const Keyframes& keys) {
      return make_curve(method, keys);
    });
  }

  const Specimen& specimen_;
  std::vector<double> times_;
  Motions wanted_;
  std::vector<std::array<double, 4>> sensitivity_;
};

/// ν is a rate: it has the unit 1/s.
bool feels_the_unit_of_time(const Method& method) { return method.options.parameters.contains("nu"); }

/// The rate at a key is made of the rates of the steps beside it: where one is so many times shorter, the rounding of
/// its rate alone turns the longer one by as many roundings.
constexpr double widest_ratio_of_turning = 64.0;

/// A dot product of zero leaves the sign to the file.
bool has_half_turns(const Keyframes& keys) {
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (std::abs(keys.orientations()[i - 1].dot(keys.orientations()[i])) < 1e-12) return true;
  return false;
}

}  // namespace

void claim_symmetries(const Specimen& specimen) {
  const bool may_lead_astray =
      specimen.family.is_global() && specimen.fuzzed.widest_turn > std::min(1.5, specimen.family.key_use.widest_turn);
  if (specimen.curve.orientation.knots().segments() == 0 || may_lead_astray) return;
  Symmetries symmetries(specimen);
  const bool may_flip = specimen.fuzzed.signs == Signs::shortest && has_half_turns(specimen.keys);
  if (may_flip || !symmetries.measure_sensitivity()) return;
  if (specimen.fuzzed.step_ratio <= widest_ratio_of_turning) {
    symmetries.claim_holds(turned_world());
    symmetries.claim_holds(turned_body());
  }
  if (!feels_the_unit_of_time(specimen.method)) symmetries.claim_holds(slower_clock());
  if (specimen.fuzzed.signs == Signs::shortest) symmetries.claim_holds(other_signs());
}

}  // namespace orispline::fuzz
