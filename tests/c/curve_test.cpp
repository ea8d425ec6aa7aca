// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include <nlohmann/json.hpp>

#include <orispline/analysis.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>

#include "c/handles.hpp"

namespace orispline { namespace {

using namespace testing_support;

orispline_motion motion_at(const CurveHandle& curve, double time, orispline_side side = ORISPLINE_RIGHT) {
  orispline_motion motion;
  expect_ok(call(orispline_curve_motion, static_cast<const orispline_curve*>(curve.get()), time, side, ORISPLINE_XYZW,
                 &motion));
  return motion;
}

/// The numbers of C++ in the order of the struct.
std::array<double, 25> numbers_of(const Motion& motion, const LinearMotion& linear) {
  std::array<double, 25> numbers;
  auto to = std::ranges::copy(motion.orientation.coeffs(), numbers.begin()).out;
  for (const Eigen::Vector3d& v : {motion.angular_velocity, motion.angular_acceleration, motion.angular_jerk,
                                   linear.position, linear.velocity, linear.acceleration, linear.jerk})
    to = std::ranges::copy(v, to).out;
  return numbers;
}

TEST(CurveOfC, HasTheBitsOfEveryMethod) {
  const KeyframeData data = walk(13);
  const Keyframes keys = keyframes(data);
  const KeysHandle handle = keys_of(data, {}, ORISPLINE_XYZW);
  for (const FamilyInfo& family : families_info()) {
    const PoseCurve wanted = make_pose_curve(family.name, keys).value();
    const CurveHandle curve = curve_through(handle, std::string(family.name).c_str());
    for (const double t : sample_times(wanted.orientation.knots().times(), 3))
      for (const Side side : {Side::right, Side::left}) {
        const auto found = motion_at(curve, t, side == Side::left ? ORISPLINE_LEFT : ORISPLINE_RIGHT);
        const auto numbers = numbers_of(wanted.orientation.motion(t, side), wanted.position->linear_motion(t, side));
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the same bits
        EXPECT_EQ(std::memcmp(&found, numbers.data(), sizeof found), 0) << family.name << " at " << t;
      }
  }
}

TEST(CurveOfC, GivesOrientationsInTheOrderThatIsAskedFor) {
  const CurveHandle curve = curve_through(keys_of(walk()), "timed-c2");
  std::array<double, 4> first{}, last{};
  for (const double t : {within(walk()), -1e9, 1e9}) {
    expect_ok(call(orispline_curve_orientation, static_cast<const orispline_curve*>(curve.get()), t, ORISPLINE_WXYZ,
                   first.data()));
    expect_ok(call(orispline_curve_orientation, static_cast<const orispline_curve*>(curve.get()), t, ORISPLINE_XYZW,
                   last.data()));
    EXPECT_EQ(first, (std::array{last[3], last[0], last[1], last[2]}));
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the same bits
    EXPECT_EQ(std::memcmp(last.data(), motion_at(curve, t).orientation, sizeof last), 0);
  }
}

TEST(CurveOfC, GivesNaNForATimeThatIsNone) {
  const CurveHandle curve = curve_through(keys_of(walk()), "auto");
  const orispline_motion motion = motion_at(curve, nan);
  for (const double number : motion.orientation) EXPECT_TRUE(std::isnan(number));
  for (const double number : motion.velocity) EXPECT_TRUE(std::isnan(number));
}

TEST(CurveOfC, HasNoPositionsWhereItsKeysHaveNone) {
  KeyframeData data = walk();
  data.positions.clear();
  const CurveHandle curve = curve_through(keys_of(data), "auto");
  EXPECT_EQ(orispline_curve_has_positions(curve.get()), 0);
  for (const double number : motion_at(curve, 0.5).position) EXPECT_TRUE(std::isnan(number));
  EXPECT_EQ(orispline_curve_has_positions(curve_through(keys_of(walk()), "auto").get()), 1);
}

TEST(CurveOfC, TakesSettingsOfItsKeysWhereItsTextIsSilent) {
  const KeyframeData data = walk(4);
  const std::vector<double> tensions{0.25, 0.5, 0.75, 1.0};
  const KeysHandle keys = keys_of(data, {column("tension", tensions)});
  const CurveHandle curve = curve_through(keys, "timed-c2:ends=rest");
  const orispline_curve* const handle = curve.get();
  EXPECT_EQ(text_by(orispline_curve_method, handle), "timed-c2:tension=0.25,0.5,0.75,1:ends=rest");
  const AnyCurve wanted =
      make_curve(method_from_text("timed-c2:tension=0.25,0.5,0.75,1:ends=rest").value(), keyframes(data)).value();
  EXPECT_EQ(motion_at(curve, within(data)).angular_velocity[1], wanted.motion(within(data)).angular_velocity.y());
  const CurveHandle other = curve_through(keys, "timed-c2:tension=0.5");
  const orispline_curve* const of_text = other.get();
  EXPECT_EQ(text_by(orispline_curve_method, of_text), "timed-c2:tension=0.5");
}

TEST(CurveOfC, TakesRatesAndInnerQuaternionsOfItsKeys) {
  KeyframeData data = walk(5);
  data.positions.clear();
  std::vector<double> rates(15, 0.25);
  std::fill_n(rates.begin() + 3, 3, nan);
  KeyframeData with_rates = data;
  for (std::size_t i = 0; i < 5; ++i)
    with_rates.angular_velocities.push_back(i == 1 ? free_rate() : Eigen::Vector3d::Constant(0.25));
  const CurveHandle curve = curve_through(keys_of(data, {column("angular_velocities", rates)}), "hermite-c2");
  const AnyCurve wanted = make_curve("hermite-c2", keyframes(with_rates)).value();
  EXPECT_EQ(motion_at(curve, within(data)).angular_velocity[2], wanted.motion(within(data)).angular_velocity.z());

  const std::vector<double> inner = flat(data.orientations, ORISPLINE_WXYZ);
  const CurveHandle squad =
      curve_through(keys_of(data, {column("inner_leaving", inner), column("inner_arriving", inner)}), "squad");
  KeyframeData with_inner = data;
  with_inner.inner_leaving = with_inner.inner_arriving = data.orientations;
  EXPECT_EQ(motion_at(squad, within(data)).angular_velocity[2],
            make_curve("squad", keyframes(with_inner)).value().motion(within(data)).angular_velocity.z());
}

TEST(CurveOfC, IsThatOfAutoWhereNoMethodIsNamed) {
  const CurveHandle curve = curve_through(keys_of(walk()), nullptr);
  const orispline_curve* const handle = curve.get();
  EXPECT_EQ(text_by(orispline_curve_method, handle), "auto");
}

TEST(CurveOfC, LivesLongerThanItsKeys) {
  const KeyframeData data = walk();
  KeysHandle keys = keys_of(data);
  const CurveHandle curve = curve_through(keys, "auto");
  const double before = motion_at(curve, within(data)).orientation[0];
  keys.reset();
  EXPECT_EQ(motion_at(curve, within(data)).orientation[0], before);
}

TEST(CurveOfC, SaysWhereItIsAndWhatItIsWorth) {
  const KeyframeData data = walk();
  const PoseCurve wanted = make_pose_curve("squad", keyframes(data)).value();
  const CurveHandle owned = curve_through(keys_of(data), "squad");
  const orispline_curve* const curve = owned.get();
  double start = 0.0, end = 0.0;
  expect_ok(call(orispline_curve_domain, curve, &start, &end));
  EXPECT_EQ(start, wanted.orientation.domain().start);
  EXPECT_EQ(end, wanted.orientation.domain().end);

  orispline_continuity found;
  expect_ok(call(orispline_curve_continuity, curve, &found));
  const Continuity continuity = continuity_at_keys(wanted.orientation);
  EXPECT_EQ(found.order, continuity.order());
  EXPECT_EQ(found.angular_velocity.largest, continuity.angular_velocity.largest);
  EXPECT_EQ(found.angular_velocity.key, static_cast<std::int64_t>(continuity.angular_velocity.key));
  EXPECT_EQ(found.orientation_jump, 0.0);

  const std::vector<int> orders = orders_at_keys(wanted.orientation);
  std::vector<std::int32_t> told(orders.size());
  expect_ok(call(orispline_curve_orders, curve, told.data(), told.size()));
  EXPECT_EQ(told, orders);
  EXPECT_EQ(call(orispline_curve_orders, curve, told.data(), told.size() + 1).option(), "count");
  const CurveHandle points = curve_through(keys_of(walk(7)), "bezier");
  std::vector<std::int32_t> at_points(7);
  expect_ok(call(orispline_curve_orders, static_cast<const orispline_curve*>(points.get()), at_points.data(),
                 at_points.size()));
  EXPECT_EQ(at_points, (std::vector<std::int32_t>{3, 3, 3, 0, 3, 3, 3}));
  const CurveHandle loop = curve_through(keys_of(data), "timed-c1:period=9");
  expect_ok(call(orispline_curve_orders, static_cast<const orispline_curve*>(loop.get()), told.data(), told.size()));
  EXPECT_EQ(told, std::vector<std::int32_t>(data.times.size(), 1));

  const std::array<double, 9> inertia{1, 0, 0, 0, 2, 0, 0, 0, 2.5};
  orispline_peaks largest;
  expect_ok(call(orispline_curve_peaks, curve, inertia.data(), &largest));
  EXPECT_EQ(largest.angular_velocity.value, peaks(wanted.orientation).angular_velocity.value);
  EXPECT_GT(largest.torque.value, largest.angular_acceleration.value);
  expect_ok(call(orispline_curve_peaks, curve, static_cast<const double*>(nullptr), &largest));
  EXPECT_TRUE(std::isnan(largest.torque.value));
}

TEST(CurveOfC, TellsWhatItsRatesAreNowhereAbove) {
  const KeyframeData data = walk(9);
  const AnyCurve wanted = make_curve("auto", keyframes(data)).value();
  const CurveHandle bounded = curve_through(keys_of(data), "auto"), unbounded = curve_through(keys_of(data), "squad");
  const std::array<double, 9> inertia{1, 0, 0, 0, 2, 0, 0, 0, 2.5};
  orispline_peaks largest;
  std::array<double, 3> bounds{};
  const auto find = [&](const CurveHandle& curve, const double* tensor) {
    expect_ok(call(orispline_curve_bounded_peaks, static_cast<const orispline_curve*>(curve.get()), tensor, &largest,
                   bounds.data()));
  };
  find(bounded, inertia.data());
  EXPECT_EQ(bounds[0], peaks(wanted).angular_velocity.bound);
  EXPECT_EQ(bounds[1], peaks(wanted).angular_acceleration.bound);
  EXPECT_GE(bounds[2], largest.torque.value);
  find(bounded, nullptr);
  EXPECT_TRUE(std::isnan(largest.torque.value) && std::isnan(bounds[2]));
  find(unbounded, inertia.data());
  EXPECT_TRUE(std::ranges::all_of(bounds, [](double bound) { return std::isnan(bound); }));
}

TEST(CurveOfC, TellsItsWarnings) {
  KeyframeData data{.times = {0.0, 1.0, 2.0}, .orientations = {{1, 0, 0, 0}, {1e-4, 1, 0, 0}, {1, 1e-4, 0, 0}}};
  for (auto& q : data.orientations) q.normalize();
  const KeysHandle keys = [&] {
    orispline_keys* made = nullptr;
    const auto numbers = flat(data.orientations, ORISPLINE_WXYZ);
    expect_ok(call(orispline_keys_make, data.times.data(), numbers.data(), std::size_t{3}, ORISPLINE_WXYZ,
                   ORISPLINE_SHORTEST, static_cast<const orispline_column*>(nullptr), std::size_t{0}, &made));
    return KeysHandle(made);
  }();
  const CurveHandle owned = curve_through(keys, "slerp");
  const orispline_curve* const curve = owned.get();
  const auto warnings = nlohmann::json::parse(text_by(orispline_curve_warnings, curve));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0]["code"], "near_half_turn");
  EXPECT_EQ(warnings[0]["steps"], 2);
}

TEST(CurveOfC, IsBakedAndPlayed) {
  const CurveHandle owned = curve_through(keys_of(walk()), "auto");
  const orispline_curve* const curve = owned.get();
  for (const orispline_type type : {ORISPLINE_DOUBLE, ORISPLINE_FLOAT}) {
    orispline_baked* made = nullptr;
    expect_ok(call(orispline_bake, curve, 1e-5, type, static_cast<orispline_progress>(nullptr),
                   static_cast<void*>(nullptr), &made));
    const BakedHandle baked(made);
    orispline_baked_parts parts;
    expect_ok(call(orispline_baked_look, static_cast<const orispline_baked*>(made), &parts));
    EXPECT_EQ(parts.end_count, parts.pieces + 1);
    EXPECT_EQ(parts.degree, type == ORISPLINE_FLOAT ? 5 : 9);
    EXPECT_LE(parts.largest_difference, 1e-5);

    // As the header says a player computes it.
    const double t = within(walk());
    std::size_t i = 0;
    while (i + 1 < parts.pieces && t >= parts.ends[i + 1]) ++i;
    const double s = (t - parts.scales[2 * i]) * parts.scales[2 * i + 1];
    std::array<double, 4> q{}, wanted{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t power = static_cast<std::size_t>(parts.degree) + 1; power-- > 0;) {
        const std::size_t place = (4 * i + k) * (static_cast<std::size_t>(parts.degree) + 1) + power;
        q[k] = q[k] * s + (type == ORISPLINE_FLOAT
                               ? static_cast<double>(static_cast<const float*>(parts.coefficients)[place])
                               : static_cast<const double*>(parts.coefficients)[place]);
      }
    expect_ok(call(orispline_curve_orientation, curve, t, ORISPLINE_XYZW, wanted.data()));
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(q[k], wanted[k], 1e-5);

    orispline_baked* again = nullptr;
    expect_ok(call(orispline_baked_make, static_cast<const orispline_baked_parts*>(&parts), &again));
    const BakedHandle stored(again);
    std::array<float, 8> single{};
    std::array<double, 8> twice{};
    void* const numbers = type == ORISPLINE_FLOAT ? static_cast<void*>(single.data()) : twice.data();
    const std::array<double, 2> times{t, 0.1};
    const orispline_output output{ORISPLINE_ORIENTATION, type, numbers, 0};
    expect_ok(call(orispline_baked_sample_at, static_cast<const orispline_baked*>(again), times.data(), times.size(),
                   ORISPLINE_XYZW, &output, std::size_t{1}));
    EXPECT_NEAR(type == ORISPLINE_FLOAT ? static_cast<double>(single[1]) : twice[1], wanted[1], 1e-5);
  }
}

TEST(CurveOfC, IsBakedAsTheTextThatPlayersRead) {
  const CurveHandle owned = curve_through(keys_of(walk()), "auto");
  const orispline_curve* const curve = owned.get();
  const auto baked = nlohmann::json::parse(text_by(orispline_bake_text, curve, 1e-5, 1e-3));
  EXPECT_EQ(baked["orispline"], "baked");
  const bool has_positions = orispline_curve_has_positions(curve) == 1;
  EXPECT_EQ(baked["version"], has_positions ? 2 : 1);
  EXPECT_EQ(baked["pieces"].size() + 1, baked["ends"].size());
  EXPECT_EQ(baked.contains("position_pieces"), has_positions);
  EXPECT_LE(baked["largest_difference"], 1e-5);
  char* text = nullptr;
  orispline_error* error = nullptr;
  EXPECT_EQ(orispline_bake_text(curve, 1e-5, -1.0, &text, &error),
            has_positions ? ORISPLINE_BAD_ARGUMENT : ORISPLINE_OK);
  orispline_text_free(text);
  orispline_error_free(error);
}

TEST(KeysOfC, GiveBackWhatTheyHold) {
  const KeyframeData data = walk(6);
  const std::vector<double> tensions(6, 0.5);
  const KeysHandle owned = keys_of(data, {column("tension", tensions)});
  const orispline_keys* const keys = owned.get();
  EXPECT_EQ(orispline_keys_count(keys), 6u);
  const auto json = nlohmann::json::parse(text_by(orispline_keys_json, keys));
  EXPECT_EQ(json["count"], 6);
  EXPECT_EQ(json["method"], nullptr);
  const std::map<std::string, std::vector<double>> held{
      {"times", data.times},
      {"orientations", flat(keyframes(data).data().orientations, ORISPLINE_WXYZ)},
      {"positions", flat(data.positions)},
      {"tension", tensions}};
  std::vector<double> numbers;
  for (const auto& entry : json["columns"]) {
    numbers.assign(6 * entry["width"].get<std::size_t>(), nan);
    const std::string name = entry["name"];
    expect_ok(call(orispline_keys_column, keys, name.c_str(), ORISPLINE_WXYZ, numbers.data(), numbers.size()));
    EXPECT_EQ(numbers, held.at(name)) << name;
  }
  EXPECT_EQ(json["columns"].size(), 4u);
}

TEST(MethodsOfC, AreThoseOfTheRegistry) {
  const auto json = nlohmann::json::parse(text_by(orispline_methods_json));
  ASSERT_EQ(json.size(), families_info().size());
  for (std::size_t i = 0; i < json.size(); ++i) EXPECT_EQ(json[i]["name"], families_info()[i].name);
  EXPECT_EQ(text_by(orispline_method_text, "timed-c2:tension=0.60:ends=rest"), "timed-c2:tension=0.6:ends=rest");
  EXPECT_EQ(orispline_abi(), ORISPLINE_C_ABI);
}

}}  // namespace orispline
