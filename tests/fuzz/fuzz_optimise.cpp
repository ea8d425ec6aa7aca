// SPDX-License-Identifier: Apache-2.0
// Up to 40 samples and one of the tasks: what each promises, in time.
#include <ctime>

#include <fuzz/claim.hpp>
#include <fuzz/fuzzed_method.hpp>
#include <fuzz/segment_scale.hpp>
#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/reduce/tolerance_check.hpp>
#include <orispline/retime/motion_limits.hpp>
#include <orispline/retime/rate_bounds.hpp>
#include <orispline/retime/retime.hpp>
#include <orispline/smooth/smooth.hpp>
#include <orispline/tune/tune.hpp>
#include <support/specimens.hpp>

namespace orispline::fuzz { namespace {

/// Of a length; infinite where there is none.
double size_of(const std::optional<Limit>& limit) { return limit ? limit->sizes[0] : HUGE_VAL; }

constexpr std::size_t most_samples = 40;
/// What a task takes, on all its threads. Only a fuzzer looks for inputs that are slow; a replay claims no time.
class Stopwatch {
 public:
  ~Stopwatch() {
#if defined(ORISPLINE_FUZZ_SLOWED)
    constexpr double longest_task = 20.0;  // [s] of processor time, slowed down twentyfold: a second of a user
    const double taken = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
    claim(taken <= longest_task, "it takes {} s", taken);
#endif
  }

 private:
  [[maybe_unused]] std::clock_t start_ = std::clock();
};

/// A method of the list.
template <std::size_t N>
Method chosen(FuzzInput& input, const std::array<const char*, N>& names, const FuzzedKeys& keys) {
  const FamilyInfo& family = *find_family(names[input.below(N)]).value();
  return fuzzed_method(input, family, keys);
}

AnyCurve curve_of(const Method& method, const Keyframes& keys) {
  auto curve = make_curve(method, keys);
  claim(curve.has_value(), "the result has no curve: {}", curve ? "" : describe(curve.error()));
  return *std::move(curve);
}

void try_reduce(FuzzInput& input, const Track& track, const FuzzedKeys& fuzzed) {
  constexpr std::array names{"auto", "timed-c2", "slerp", "hermite-c1", "squad-timed", "tcb"};
  ReduceOptions options{.tolerance = {.angle = std::pow(10.0, -static_cast<double>(input.below(7)))}};
  Flags flags(input);
  if (flags.next()) options.values = KeyValues::refitted;
  if (flags.next()) options.tolerance.position = 0.1;
  const Method method = chosen(input, names, fuzzed);
  const Situation situation(
      [&] { return fmt::format("reduce to {} rad by {}", options.tolerance.angle, text_of(method)); });
  const Stopwatch stopwatch;
  const auto reduction = reduce(track, method, options);
  if (!reduction) return claim_plain(reduction.error());
  const auto& kept = reduction->samples;
  claim(kept.size() == reduction->track.keys.size() && kept.front() == 0 && kept.back() == track.keys.size() - 1,
        "{} keys at {} samples from {} to {}", reduction->track.keys.size(), kept.size(), kept.front(), kept.back());
  claim(reduction->deviation.angle <= options.tolerance.angle, "its deviation is {}", reduction->deviation.angle);
  const AnyCurve curve = curve_of(reduction->method, reduction->track.keys);
  for (std::size_t i = 0; i < track.keys.size(); ++i) {
    const double off = angular_distance(curve(track.keys.times()[i]), track.keys.orientations()[i]);
    claim(off <= options.tolerance.angle + angle_rounding, "sample {} is missed by {} rad", i, off);
  }
}

/// The largest |ω| [rad/s] and |α| [rad/s²] that are met on the way, on both sides of the knots.
std::pair<double, double> met(const AnyCurve& curve) {
  double rate = 0.0, acceleration = 0.0;
  for (std::size_t i = 0; i < curve.knots().segments(); ++i)
    for (int k = 0; k <= 64; ++k) {
      const KnotSpan span = curve.knots().span(i);
      const Motion m = curve.motion_on(i, k == 64 ? span.end() : span.start() + span.step() * k / 64.0);
      rate = std::max(rate, m.angular_velocity.norm());
      acceleration = std::max(acceleration, m.angular_acceleration.norm());
    }
  return {rate, acceleration};
}

/// The promise, and what lies between two of 64 places on a segment: at most an eighth of the square of their distance
/// times the second derivative of the peak.
constexpr double slack_of_retiming = 1e-4, slack_of_places = 5e-3;

void try_retime(FuzzInput& input, const Track& track, const FuzzedKeys& fuzzed) {
  constexpr std::array names{"auto", "timed-c2", "timed-c3", "slerp", "quintic", "timed-c1", "rotation-spline"};
  RetimeOptions options;
  Flags flags(input);
  const double size = std::pow(10.0, static_cast<double>(input.below(7)) - 3.0);
  if (flags.next()) options.limits.rate = size;
  if (flags.next()) options.limits.acceleration = 2.0 * size;
  const bool per_interval = flags.next();
  const Method method = chosen(input, names, fuzzed);
  const Situation situation([&] { return fmt::format("retime {} to size {}", text_of(method), size); });
  const Stopwatch stopwatch;
  const auto retiming = retime(track, method, options);
  if (!retiming) return claim_plain(retiming.error());
  claim(retiming->time_scale >= 1.0, "it is slowed {} times", retiming->time_scale);
  const auto [rate, acceleration] = met(curve_of(retiming->method, retiming->track.keys));
  const double rate_limit = size_of(options.limits.rate);
  const double acceleration_limit = size_of(options.limits.acceleration);
  claim(rate <= rate_limit * (1.0 + 1e-9), "it turns at {} rad/s, allowed {}", rate, rate_limit);
  claim(acceleration <= acceleration_limit * (1.0 + 1e-9), "it has {} rad/s², allowed {}", acceleration,
        acceleration_limit);
  const double used = std::max(rate / rate_limit, std::sqrt(acceleration / acceleration_limit));
  double bounds = 0.0;  // as shares of the limits; what the motion uses of them is found again but for rounding
  const auto quantities = quantities_of(options.limits);
  for (const SegmentPeaks& peaks : retiming->peaks)
    for (std::size_t k = 0; k < quantities.size(); ++k)
      bounds = std::max(bounds, std::pow(peaks[k].bound / quantities[k].limit, 1.0 / quantities[k].order()));
  const bool is_warned_of =
      std::ranges::any_of(retiming->warnings, [](const Warning& warning) { return warning.code == "loose_bounds"; });
  if (retiming->time_scale > 1.0) {
    claim(bounds >= 1.0 - slack_of_retiming, "it is slowed {} times, and its bounds are {} of the limits",
          retiming->time_scale, bounds);
    claim(is_warned_of || used >= 1.0 - retiming->slack - slack_of_retiming - slack_of_places,
          "it is slowed {} times, and uses {} of the limits", retiming->time_scale, used);
  }
  if (!per_interval) return;
  options.slowing = Slowing::per_interval;
  const auto each = retime(track, method, options);
  if (!each) return claim_plain(each.error());
  claim(each->time_scale <= retiming->time_scale * (1.0 + slack_of_retiming), "interval by interval {} times, else {}",
        each->time_scale, retiming->time_scale);
}

void try_smooth(FuzzInput& input, const Track& track) {
  SmoothOptions options;
  Flags flags(input);
  options.penalty = flags.next() ? Penalty::jerk : Penalty::acceleration;
  options.loss = std::array{Loss::robust, Loss::l2, Loss::huber, Loss::tukey}[flags.next(4)];
  const unsigned stated = flags.next(4);
  const double size = std::pow(10.0, static_cast<double>(input.below(9)) - 6.0);
  if (stated == 1) options.noise = std::min(size, 0.5);
  if (stated == 2) options.smoothing_time = size;
  const Situation situation(
      [&] { return fmt::format("smooth: loss {}, stated {} {}", static_cast<int>(options.loss), stated, size); });
  const Stopwatch stopwatch;
  const auto smoothing = smooth(track, options);
  if (!smoothing) return claim_plain(smoothing.error());
  const Keyframes& keys = smoothing->track.keys;
  for (const Eigen::Quaterniond& q : keys.orientations()) claim(q.coeffs().allFinite(), "an orientation is not finite");
  for (const auto& rates : {keys.angular_velocities(), keys.angular_accelerations()})
    for (const Eigen::Vector3d& rate : rates) claim(rate.allFinite(), "a rate is not finite");
  for (const double number : {smoothing->smoothing_time, smoothing->lambda, smoothing->noise, smoothing->local_noise})
    claim(std::isfinite(number), "a result is {}", number);
  const AnyCurve curve = curve_of(smoothing->method, keys);
  for (const double t : testing_support::sample_times(curve.knots().times()))
    claim(is_finite(curve.motion(t)), "the motion at t = {} is not finite", t);
}

void try_tune(FuzzInput& input, const Track& track, const FuzzedKeys& fuzzed) {
  constexpr std::array names{"timed-c2", "timed-c1",           "timed-c3", "timed-sextic",
                             "quintic",  "hermite-cumulative", "nu-exact"};
  TuneOptions options;
  options.objective = std::array{Objective::acceleration, Objective::jerk, Objective::linearised}[input.below(3)];
  const Method method = chosen(input, names, fuzzed);
  const Situation situation(
      [&] { return fmt::format("tune {}, objective {}", text_of(method), static_cast<int>(options.objective)); });
  const Stopwatch stopwatch;
  const auto tuning = tune(track, method, options);
  if (!tuning) return claim_plain(tuning.error());
  claim(std::isfinite(tuning->energy_before) && std::isfinite(tuning->energy_after), "energies {} and {}",
        tuning->energy_before, tuning->energy_after);
  claim(tuning->energy_after <= tuning->energy_before * (1.0 + 1e-9), "the energy rises from {} to {}",
        tuning->energy_before, tuning->energy_after);
  static_cast<void>(curve_of(tuning->method, tuning->track.keys));
}

void claim_finite(const DistanceStatistics& statistics) {
  for (const double number : {statistics.rms, statistics.mean, statistics.largest, statistics.median})
    claim(std::isfinite(number), "a distance is {}", number);
}

void try_compare(FuzzInput& input, const Track& track) {
  const Decimation decimation{.keep_every = 1 + input.below(8),
                              .spacing = std::array{Spacing::even, Spacing::jittered, Spacing::random}[input.below(3)],
                              .seed = input.byte()};
  const auto kept = kept_samples(decimation, track.keys.size());
  for (std::size_t i = 1; i < kept.size(); ++i) claim(kept[i - 1] < kept[i], "sample {} is kept twice", kept[i]);
  claim(kept.front() == 0 && kept.back() < track.keys.size(), "samples {} to {} are kept", kept.front(), kept.back());
  const Keyframes keys = track.keys.at(kept);
  std::vector<Candidate> candidates;
  for (const char* name : {"auto", "timed-c2", "squad"}) candidates.push_back({name, keys});
  const Stopwatch stopwatch;
  const MeasureOptions options{.leave_out = input.below(2) == 0 ? LeaveOut::no : LeaveOut::yes};
  const Comparison comparison =
      compare(candidates, {.times = track.keys.times(), .orientations = track.keys.orientations()}, options);
  for (const auto& measures : comparison.measures) {
    if (!measures) {
      claim_plain(measures.error());
      continue;
    }
    claim_finite(measures->distance);
    for (const double number : {measures->energies.acceleration, measures->energies.jerk,
                                measures->peaks.angular_velocity.value, measures->angle_travelled})
      claim(std::isfinite(number), "a measure is {}", number);
  }
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  FuzzInput input(data, size);
  const std::size_t task = input.below(5);
  FuzzInput of_task = input.part(32);
  const FuzzedKeys fuzzed = fuzzed_keys(input, most_samples);
  const auto keys = Keyframes::make(fuzzed.data, fuzzed.signs);
  if (!keys) return claim_plain(keys.error()), 0;
  const Track track(*keys);
  const Situation situation([&] { return told("auto", fuzzed); });
  if (task == 0) try_reduce(of_task, track, fuzzed);
  if (task == 1) try_retime(of_task, track, fuzzed);
  if (task == 2) try_smooth(of_task, track);
  if (task == 3) try_tune(of_task, track, fuzzed);
  if (task == 4) try_compare(of_task, track);
  return 0;
}
