// SPDX-License-Identifier: Apache-2.0
// Pages made from plain results, as a program makes them: no command, no file, no clock.
#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/report/page_json.hpp>
#include <pages/page_head.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

/// Turns about z by sin(2t) at 100 Hz, turned about random axes by half a degree and less.
Track noisy(std::size_t count) {
  testing_support::Dice dice(5);
  KeyframeData data;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, std::sin(2.0 * t))) *
                                exp<double>(Eigen::Vector3d(0.5 / degrees * dice.vector())));
  }
  Track track = Keyframes::make(std::move(data)).value();
  track.name = "folder/noisy";
  return track;
}

void expect_head(const report::Page& page) {
  EXPECT_EQ(page.command, head.command);
  EXPECT_EQ(page.date, head.date);
  ASSERT_FALSE(page.notes.empty());
  EXPECT_EQ(page.notes.front(), head.notes.front());
}

/// Every measure has its column, but for the order, which has one of its own, and what is shown where samples are
/// rejected.
void expect_columns(const report::Page& page) {
  for (const report::PageMethod& method : page.methods) {
    EXPECT_EQ(method.failure, "");
    EXPECT_FALSE(method.measures.empty());
    for (const auto& [id, value] : method.measures) {
      if (id == "continuity" || id == "rms_accepted_deg") continue;
      EXPECT_EQ(std::ranges::count(page.columns, id, &report::PageColumn::id), 1) << id;
    }
  }
}

TEST(CurvesPage, ShowsEachCurveWithItsOwnKeysAndItsAnglesToTheTruth) {
  const Keyframes truth = noisy(201).keys;
  const std::vector<std::size_t> few{0, 100, 200}, more{0, 50, 100, 150, 200};
  std::vector<pages::NamedCurve> curves;
  for (const auto& [name, kept] : {std::pair{"few", &few}, std::pair{"more", &more}}) {
    const Keyframes keys = truth.at(*kept);
    curves.push_back({name, keys, make_pose_curve(default_method, keys).value()});
  }
  const report::Page page = pages::curves_page(curves, head, truth);
  expect_head(page);
  expect_columns(page);
  EXPECT_EQ(page.reference.value().times.size(), 201U);
  ASSERT_EQ(page.methods.size(), 2U);
  EXPECT_EQ(page.methods[0].keys.value().path.times, (std::vector<double>{0.0, 1.0, 2.0}));
  EXPECT_EQ(page.methods[1].keys.value().path.times.size(), 5U);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const DistanceStatistics distance =
        distance_to_reference(curves[i].curve.orientation, {truth.times(), truth.orientations()});
    EXPECT_DOUBLE_EQ(page.methods[i].measures.at("rms_deg"), distance.rms * degrees);
    EXPECT_DOUBLE_EQ(std::ranges::max(page.methods[i].samples.errors), distance.largest * degrees);
  }
}

TEST(CurvesPage, HasNoAnglesToATruthThatThereIsNot) {
  const Keyframes keys = noisy(5).keys;
  const std::vector<pages::NamedCurve> curves{{"it", keys, make_pose_curve(default_method, keys).value()}};
  const report::Page page = pages::curves_page(curves, head);
  EXPECT_FALSE(page.reference.has_value());
  EXPECT_TRUE(page.methods[0].samples.errors.empty());
  EXPECT_EQ(page.methods[0].measures.count("rms_deg"), 0U);
}

TEST(CurvesPage, HasNoAnglesOfACurveOfWhichTheTruthIsNotThat) {
  const Keyframes truth = noisy(50).keys, keys = truth.at(std::vector<std::size_t>{0, 20, 49});
  const PoseCurve curve = make_pose_curve(default_method, keys).value();
  const std::vector<pages::NamedCurve> curves{{"of it", keys, curve},
                                              {"of another", keys, curve, pages::Truth::unknown}};
  const report::Page page = pages::curves_page(curves, head, truth);
  EXPECT_TRUE(page.reference.has_value());
  EXPECT_EQ(page.methods[0].measures.count("rms_deg"), 1U);
  EXPECT_EQ(page.methods[0].samples.errors.size(), 50U);
  EXPECT_EQ(page.methods[1].measures.count("rms_deg"), 0U);
  EXPECT_TRUE(page.methods[1].samples.errors.empty());
}

TEST(MotionPage, ShowsOneCurveWithItsKeysAndItsShape) {
  Track track = Keyframes::make(testing_support::random_walk(3, 8, testing_support::Spacing::uneven)).value();
  const Method method{"quintic", {.parameters = {{"tension", {0.4}}}}};
  const report::Page page = pages::motion_page(track, method, head).value();
  expect_head(page);
  expect_columns(page);
  EXPECT_EQ(page.title, "quintic, 8 keys");
  ASSERT_EQ(page.methods.size(), 1u);
  EXPECT_EQ(page.methods[0].name, "quintic:tension=0.4");
  const AnyCurve curve = make_curve(method, track.keys).value();
  EXPECT_EQ(page.methods[0].continuity, "C" + std::to_string(continuity_at_keys(curve).order()));
  EXPECT_DOUBLE_EQ(page.methods[0].measures.at("peak_rate_rad_s"), peaks(curve).angular_velocity.value);
  EXPECT_FALSE(page.methods[0].measures.contains("rms_deg"));  // there is nothing to compare with
  EXPECT_TRUE(page.methods[0].samples.torques.empty());
  track.name = "folder/keys.csv";
  const Eigen::Matrix3d inertia = Eigen::Vector3d(1.0, 2.0, 2.5).asDiagonal();
  const report::Page torques = pages::motion_page(track, method, head, inertia).value();
  EXPECT_EQ(torques.title, "keys.csv: quintic, 8 keys");
  EXPECT_DOUBLE_EQ(torques.methods[0].measures.at("peak_torque_n_m"), peaks(curve, inertia).torque.value);
  EXPECT_EQ(torques.methods[0].samples.torques.size(), torques.methods[0].samples.path.times.size());
  EXPECT_FALSE(pages::motion_page(track, "no-such-method", head));
}

TEST(SmoothPage, ShowsTheSmoothedMotionBesideTheRecording) {
  const Track recording = noisy(300);
  const Smoothing smoothing = smooth(recording).value();
  const report::Page page = pages::smooth_page(recording, smoothing, head);
  expect_head(page);
  expect_columns(page);
  EXPECT_EQ(page.title.substr(0, 27), "noisy smoothed: 300 samples");
  ASSERT_EQ(page.methods.size(), 2u);
  EXPECT_EQ(page.methods[0].name, "smoothed");
  EXPECT_GT(page.methods[0].measures.at("rms_deg"), 0.0);
  EXPECT_LT(page.methods[0].measures.at("energy"), 0.01 * page.methods[1].measures.at("energy"));
  EXPECT_EQ(json_of(page), json_of(pages::smooth_page(recording, smoothing, head)));
}

TEST(SmoothPage, DrawsStandardDeviationsAsBandsThatEndAtGaps) {
  Track recording = noisy(300);
  EXPECT_TRUE(pages::smooth_page(recording, smooth(recording).value(), head).methods[0].bands.empty());
  std::vector<double> times(recording.keys.times().begin(), recording.keys.times().end());
  for (std::size_t i = 150; i < 300; ++i) times[i] += 5.0;
  recording = recording.with_times(times).value();
  const Smoothing smoothing = smooth(recording, {.gap = 1.0, .sigma = true}).value();
  const report::Page page = pages::smooth_page(recording, smoothing, head);
  ASSERT_EQ(page.methods[0].bands.size(), 3u);
  constexpr double radius = 2.5002777108094975;  // of 90 %, by the chi distribution of three degrees of freedom
  const double first = std::sqrt(smoothing.sigmas->orientations[0].squaredNorm() / 3.0);
  for (const char* const of : {"error", "angle"}) {
    const report::PageBand& turn = page.methods[0].bands.at(of);
    EXPECT_NEAR(turn.high[0], radius * first * degrees, 1e-9);
    EXPECT_EQ(turn.low[0], 0.0);
    std::size_t empty = 0;
    for (std::size_t i = 0; i < turn.times.size(); ++i) {
      const bool is_in_gap = times[149] < turn.times[i] && turn.times[i] < times[150];
      EXPECT_EQ(std::isnan(turn.high[i]), is_in_gap) << of << " at " << turn.times[i];
      empty += is_in_gap ? 1 : 0;
    }
    EXPECT_GT(empty, 0u);
  }
  const report::PageBand& rate = page.methods[0].bands.at("w");
  ASSERT_EQ(rate.times.size(), 301u);  // the keys, and one that ends the band
  EXPECT_TRUE(std::isnan(rate.high[150]));
  const double speed = smoothing.nodes.angular_velocities[10].norm();
  EXPECT_LT(rate.low[10], speed);
  EXPECT_NEAR(rate.low[10] + rate.high[10], 2.0 * speed, 1e-12);
  EXPECT_TRUE(page.methods[1].bands.empty());
}

TEST(ReducePage, PutsTheSmallestReductionFirst) {
  const Track recording = noisy(200);
  const ReduceOptions options{.tolerance = {.angle = 2.0 / degrees}};
  std::vector<Reduction> reductions;
  for (const std::string_view method : {"slerp", "auto"})
    reductions.push_back(reduce(recording, method, options).value());
  const report::Page page = pages::reduce_page(recording, reductions, options, head, 0.125);
  expect_head(page);
  expect_columns(page);
  EXPECT_DOUBLE_EQ(page.limits.at("error"), 2.0);
  ASSERT_EQ(page.methods.size(), 2u);
  EXPECT_LE(page.methods[0].measures.at("keys"), page.methods[1].measures.at("keys"));
  EXPECT_EQ(page.methods[0].name, reductions[smallest(reductions)].method.name);
  EXPECT_NE(page.notes[1].find("smoothing time of 0.125 s"), std::string::npos);
}

TEST(RetimePage, ShowsBothMotionsWithTheirCertificates) {
  const Track before = Keyframes::make(testing_support::random_walk(3, 8, testing_support::Spacing::uneven)).value();
  const MotionLimits limits{.rate = 0.1};
  const Retiming retiming = retime(before, "timed-c2", {.limits = limits}).value();
  const report::Page page = pages::retime_page(before, retiming, limits, head);
  expect_head(page);
  expect_columns(page);
  ASSERT_EQ(page.methods.size(), 2u);
  EXPECT_LE(page.methods[0].measures.at("rate_bound_deg_s"), 0.1 * degrees);
  EXPECT_GT(page.methods[1].measures.at("rate_max_deg_s"), 0.1 * degrees);
  EXPECT_EQ(page.limits.at("w"), 0.1);
  EXPECT_EQ(page.units.at("w").name, "°/s");  // as the certificates
  EXPECT_DOUBLE_EQ(page.units.at("w").size * degrees, 1.0);
}

/// A value at a time, linear between.
double at_time(const std::vector<double>& times, const std::vector<double>& values, double t) {
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, t);
  const auto i = static_cast<std::size_t>(after - times.begin());
  return std::lerp(values[i - 1], values[i], (t - times[i - 1]) / (times[i] - times[i - 1]));
}

/// The largest angle between both motions where the page of a retiming shows them at one time [deg].
double largest_apart(const Track& before, const Method& method, const RetimeOptions& options) {
  const Retiming retiming = retime(before, method, options).value();
  const report::Page page = pages::retime_page(before, retiming, options.limits, head);
  const auto& evenness = retiming.evenness;
  const Keyframes keys = evenness ? before.keys.with_times(evenness->path_times).value() : before.keys;
  const std::vector<double> typed(before.keys.times().begin(), before.keys.times().end()),
      shaping(keys.times().begin(), keys.times().end());
  const PoseCurve after = make_pose_curve(retiming.method, retiming.track.keys).value(),
                  path = make_pose_curve(evenness ? evenness->path_method : retiming.method, keys).value();
  EXPECT_FALSE(page.methods[0].clock);
  const report::PageClock clock = page.methods[1].clock.value();
  EXPECT_TRUE(std::ranges::is_sorted(clock.times) && std::ranges::is_sorted(clock.own));
  EXPECT_NEAR(clock.own.front(), before.keys.times().front(), 1e-9);
  EXPECT_NEAR(clock.own.back(), before.keys.times().back(), 1e-9);
  const Domain domain = after.orientation.domain();
  double largest = 0.0;
  for (std::size_t k = 0; k <= 5000; ++k) {
    const double t = std::lerp(domain.start, domain.end, static_cast<double>(k) / 5000.0);
    const double own = at_time(typed, shaping, at_time(clock.times, clock.own, t));
    largest = std::max(largest, angular_distance(after.orientation(t), path.orientation(own)) * degrees);
  }
  return largest;
}

TEST(RetimePage, HasAClockByWhichBothMotionsAreAtTheSamePlace) {
  const Track before = Keyframes::make(testing_support::random_walk(3, 40, testing_support::Spacing::uneven)).value();
  const MotionLimits limits{.rate = 0.1};
  EXPECT_LE(largest_apart(before, "timed-c2", {.limits = limits}), 1e-6);
  EXPECT_LE(largest_apart(before, "auto", {.constant_rate = 0.1, .path_times = PathTimes::typed}), 0.5);
  EXPECT_LE(largest_apart(before, "auto", {.constant_rate = 0.1}), 0.5);
  // of slerps the way between two keys is one, whatever the times
  EXPECT_LE(largest_apart(before, "slerp", {.limits = limits, .slowing = Slowing::per_interval}), 1e-6);
}

TEST(ComparePage, HasTheCurvesOfTheFirstKeysAndTheMeasuresOfAll) {
  const Track recording = noisy(101);
  std::vector<ComparedMethod> methods;
  for (const std::size_t step : {10u, 20u})
    for (const std::string label : {"auto", "slerp", "unknown"}) {
      std::vector<std::size_t> kept;
      for (std::size_t i = 0; i < recording.keys.size(); i += step) kept.push_back(i);
      ComparedMethod compared{.label = label, .key_set = step / 20, .candidate = {label, recording.keys.at(kept)}};
      compared.measures = measure(compared.candidate, {recording.keys.times(), recording.keys.orientations()});
      methods.push_back(std::move(compared));
    }
  const report::Page page = pages::compare_page({.methods = methods,
                                                 .recording = {recording.keys.times(), recording.keys.orientations()},
                                                 .key_sets = {"every 10th", "every 20th"},
                                                 .measures = measures_of({MeasureGroup::distance, MeasureGroup::shape}),
                                                 .sorted_by = "max"},
                                                head);
  expect_head(page);
  EXPECT_EQ(page.title, "3 methods on 11 keys");
  EXPECT_EQ(page.sorted_by, "max_deg");
  ASSERT_EQ(page.methods.size(), 3u);
  EXPECT_TRUE(page.methods[0].measures.contains("rms_deg_1"));
  EXPECT_FALSE(page.methods[0].measures.contains("mean_deg_1"));
  EXPECT_FALSE(page.methods[1].measures.contains("energy"));  // infinite: the rates of slerps jump
  EXPECT_NE(page.methods[2].failure, "");
  const auto column = std::ranges::find(page.columns, "max_deg_1", &report::PageColumn::id);
  ASSERT_NE(column, page.columns.end());
  EXPECT_EQ(column->label, "max, every 20th");
}

/// On every 10th sample, in this order; that of no such name has failed.
report::Page compared(const std::vector<std::string>& labels, const std::vector<std::string>& named,
                      const Decimal& epoch = {}) {
  const Track recording = noisy(101);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < recording.keys.size(); i += 10) kept.push_back(i);
  std::vector<ComparedMethod> methods;
  for (const std::string& label : labels) {
    methods.push_back({.label = label, .candidate = {label, recording.keys.at(kept)}});
    methods.back().measures =
        measure(methods.back().candidate, {recording.keys.times(), recording.keys.orientations()});
  }
  return pages::compare_page({.methods = methods,
                              .recording = {recording.keys.times(), recording.keys.orientations()},
                              .epoch = epoch,
                              .key_sets = {""},
                              .named = named,
                              .measures = measures_of({MeasureGroup::distance, MeasureGroup::shape})},
                             head);
}

/// With a gap of 5 s after the first half.
Keyframes interrupted(const Keyframes& keys) {
  std::vector<double> times(keys.times().begin(), keys.times().end());
  for (std::size_t i = times.size() / 2; i < times.size(); ++i) times[i] += 5.0;
  return Keyframes::make({.times = times, .orientations = {keys.orientations().begin(), keys.orientations().end()}})
      .value();
}

TEST(ComparePage, DrawsTheLargestErrorOfEveryFewSamplesOfAllMethodsAtTheSameTimes) {
  const Keyframes recording = interrupted(noisy(10'001).keys);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < recording.size(); i += 10) kept.push_back(i);
  const Keyframes keys = recording.at(kept);
  const RecordedMotion recorded{recording.times(), recording.orientations()};
  std::vector<ComparedMethod> methods;
  for (const std::string label : {"auto", "slerp", "quintic"}) {
    methods.push_back({.label = label, .candidate = {label, keys, stretches_between_gaps(keys.times(), 1.0).value()}});
    methods.back().measures = measure(methods.back().candidate, recorded);
  }
  const report::Page page = pages::compare_page({.methods = methods,
                                                 .recording = recorded,
                                                 .key_sets = {""},
                                                 .measures = measures_of({MeasureGroup::distance}),
                                                 .gap = 1.0},
                                                head);
  EXPECT_EQ(page.notes.back(), "A drawn error is the largest of about 5 samples. The table counts all samples.");
  for (const report::PageMethod& method : page.methods) {
    const auto& [t, errors] = std::pair(method.samples.error_times, method.samples.errors);
    EXPECT_EQ(t, page.methods[0].samples.error_times);
    EXPECT_LE(t.size(), 2000u + 3 + 3);  // and those of the largest errors, and about the gap
    double largest = 0.0, largest_at = 0.0;
    for (std::size_t i = 0; i < t.size(); ++i) {
      EXPECT_TRUE(t[i] <= 49.99 || t[i] >= 55.0 || std::isnan(errors[i])) << t[i];
      if (errors[i] > largest) std::tie(largest, largest_at) = std::pair(errors[i], t[i]);
    }
    EXPECT_DOUBLE_EQ(largest, method.measures.at("max_deg")) << method.name;
    EXPECT_DOUBLE_EQ(largest_at, method.measures.at("max_at_s")) << method.name;
  }
}

TEST(ComparePage, ShowsTheDefaultBesideTheWorstOfTheWidelyUsedSplines) {
  const report::Page page = compared({"rotation-spline", "auto", "squad", "slerp", "impossible"}, {"all"});
  EXPECT_EQ(page.first, "auto");
  EXPECT_EQ(page.second, "squad");
  for (const std::string_view name : {"rotation-spline", "squad", "tcb"}) EXPECT_TRUE(find_family(name)) << name;
}

TEST(ComparePage, DrawsTheBandOfAMethodThatHasOneAboutItsError) {
  const report::Page page = compared({"measured", "auto"}, {"measured", "auto"});
  EXPECT_TRUE(page.methods[1].bands.empty());
  const report::PageBand& band = page.methods[0].bands.at("error");
  EXPECT_EQ(band.label, "90 % of the truth, as the keys tell");
  EXPECT_EQ(band.times, page.methods[0].samples.path.times);
  EXPECT_EQ(band.low, std::vector<double>(band.times.size(), 0.0));
  EXPECT_GT(*std::ranges::max_element(band.high), 0.0);
  const report::PageBand& angle = page.methods[0].bands.at("angle");
  for (std::size_t i = 0; i < angle.times.size(); ++i) EXPECT_LE(angle.low[i], angle.high[i]);
  EXPECT_EQ(angle.low.front(), 0.0);
  EXPECT_LT(*std::ranges::max_element(band.high), 180.0);
}

TEST(ComparePage, ShowsTheDefaultBesideWhatTheUserNamed) {
  EXPECT_EQ(compared({"auto", "squad", "slerp"}, {"auto", "slerp", "squad"}).second, "slerp");
  const report::Page failed = compared({"auto", "squad", "slerp", "impossible"}, {"impossible", "slerp"});
  EXPECT_EQ(failed.first + " " + failed.second, "auto slerp");
  const report::Page without = compared({"timed-c2", "slerp"}, {"slerp", "timed-c2"});
  EXPECT_EQ(without.first + " " + without.second, "timed-c2 slerp");
  EXPECT_EQ(compared({"auto"}, {"auto"}).second, "");
}

TEST(ComparePage, TellsMomentsFromTheStartOfItsPlots) {
  const report::Page page = compared({"auto"}, {}, Decimal::from_double(1.7e9));
  EXPECT_EQ(page.time_start, "1700000000");
  EXPECT_LE(page.methods[0].measures.at("max_at_s"), 1.0);
  const auto column = std::ranges::find(page.columns, "max_at_s", &report::PageColumn::id);
  ASSERT_NE(column, page.columns.end());
  EXPECT_TRUE(column->is_time);
}

TEST(Page, OfVeryManyKeysShowsSomeAndSaysSo) {
  const Track recording = noisy(2500);
  const Smoothing smoothing = smooth(recording, {.smoothing_time = 0.1}).value();
  const report::Page page = pages::smooth_page(recording, smoothing, {.title = "Another title"});
  EXPECT_EQ(page.title, "Another title");
  EXPECT_LE(page.keys.path.times.size(), 2000u);
  EXPECT_EQ(page.notes.front(), "Of the 2500 keys 2000 are shown, evenly picked.");
}

}}  // namespace orispline
