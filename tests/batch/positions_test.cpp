// SPDX-License-Identifier: Apache-2.0
// Positions with their rates, in the same call as orientations.
#include <limits>

#include <batch/agreement.hpp>
#include <batch/refused_samples.hpp>
#include <batch/specimen_curves.hpp>
#include <curve/counting_new.hpp>
#include <support/not_finite.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Room for a sample of everything.
template <class T>
struct Poses {
  std::size_t count;
  Layout layout = Layout::interleaved;
  std::vector<T> orientations = std::vector<T>(4 * count), positions = std::vector<T>(3 * count),
                 velocities = positions, accelerations = positions, jerks = positions;

  [[nodiscard]] Samples<T> spans() {
    return {.orientations = orientations,
            .positions = positions,
            .velocities = velocities,
            .accelerations = accelerations,
            .linear_jerks = jerks,
            .layout = layout};
  }
  [[nodiscard]] Eigen::Vector3d read(const std::vector<T>& from, std::size_t i) const {
    const std::size_t first = layout == Layout::planar ? i : 3 * i, next = layout == Layout::planar ? count : 1;
    return Eigen::Matrix<T, 3, 1>(from[first], from[first + next], from[first + 2 * next]).template cast<double>();
  }
  [[nodiscard]] LinearMotion operator[](std::size_t i) const {
    return {.position = read(positions, i),
            .velocity = read(velocities, i),
            .acceleration = read(accelerations, i),
            .jerk = read(jerks, i)};
  }
};

struct NamedPose {
  std::string name;
  PoseCurve curve;
};

/// One curve of every family with its path; the uniform families also with degrees beyond the kernel's.
std::vector<NamedPose> pose_of_every_family(std::uint64_t seed, double first_time = 0.0) {
  std::vector<NamedPose> curves;
  for (const FamilyInfo& family : families_info()) {
    KeyframeData walk =
        posed_walk(seed, family.key_use.keys_for(7), Spacing::uneven, step_on(family, Spacing::uneven, 0.7));
    for (double& t : walk.times) t += first_time;
    curves.push_back({std::string(family.name), make_pose_curve(family.name, keyframes(walk)).value()});
  }
  return curves;
}

/// Largest coordinate and rate of the scalar evaluator's along the path, at least 1.
LinearMotion size_of(const AnyPath& path, std::span<const double> times) {
  const Eigen::Vector3d one = Eigen::Vector3d::Ones();
  LinearMotion size{one, one, one, one};
  for (const double t : times) {
    const LinearMotion linear_motion = path.linear_motion(t);
    size.position = size.position.cwiseMax(linear_motion.position.cwiseAbs().maxCoeff());
    size.velocity = size.velocity.cwiseMax(linear_motion.velocity.cwiseAbs().maxCoeff());
    size.acceleration = size.acceleration.cwiseMax(linear_motion.acceleration.cwiseAbs().maxCoeff());
    size.jerk = size.jerk.cwiseMax(linear_motion.jerk.cwiseAbs().maxCoeff());
  }
  return size;
}

/// Allowed differences in units of the rounding of 1.
struct PathLimits {
  double position, velocity, acceleration, jerk;
};

template <class T>
void expect_agreement(const Poses<T>& poses, const PoseCurve& curve, std::span<const double> times, PathLimits limits) {
  constexpr auto unit = static_cast<double>(std::numeric_limits<T>::epsilon());
  const LinearMotion size = size_of(*curve.position, times);
  double off[4] = {0.0, 0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const LinearMotion wanted = curve.position->linear_motion(times[i]), found = poses[i];
    const auto compare = [&](double& worst, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double of) {
      const double units = (a - b).lpNorm<Eigen::Infinity>() / (unit * of);
      if (!(units <= worst)) worst = units;
    };
    compare(off[0], found.position, wanted.position, size.position.x());
    compare(off[1], found.velocity, wanted.velocity, size.velocity.x());
    compare(off[2], found.acceleration, wanted.acceleration, size.acceleration.x());
    compare(off[3], found.jerk, wanted.jerk, size.jerk.x());
  }
  EXPECT_LE(off[0], limits.position);
  EXPECT_LE(off[1], limits.velocity);
  EXPECT_LE(off[2], limits.acceleration);
  EXPECT_LE(off[3], limits.jerk);
}

std::vector<double> times_along(const PoseCurve& curve, std::size_t count) {
  const auto [start, end] = curve.orientation.domain();
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k)
    times.push_back(start + (end - start) * static_cast<double>(k) / static_cast<double>(count));
  const auto knots = curve.position->knots().times();
  times.insert(times.end(), knots.begin(), knots.end());
  std::ranges::sort(times);
  return times;
}

TEST(BatchPositions, AgreeWithTheScalarEvaluatorForEveryFamily) {
  for (const double first_time : {0.0, 1.7e9})
    for (const auto& [name, curve] : pose_of_every_family(121, first_time)) {
      SCOPED_TRACE(name);
      const std::vector<double> times = times_along(curve, 700);
      Poses<double> poses{times.size()};
      ASSERT_TRUE(sample<double>(curve, times, poses.spans()));
      expect_agreement(poses, curve, times, {32.0, 256.0, 4096.0, 65536.0});
      Poses<float> floats{times.size()};
      ASSERT_TRUE(sample<float>(curve, times, floats.spans()));
      expect_agreement(floats, curve, times, {8.0, 32.0, 128.0, 512.0});
    }
}

TEST(BatchPositions, StandBesideTheOrientationsOfTheCurveAlone) {
  for (const auto& [name, curve] : pose_of_every_family(123)) {
    SCOPED_TRACE(name);
    const std::vector<double> times = times_along(curve, 200);
    Poses<double> poses{times.size()};
    ASSERT_TRUE(sample<double>(curve, times, poses.spans()));
    std::vector<double> alone(4 * times.size());
    ASSERT_TRUE(sample<double>(curve.orientation, times, Samples<double>{.orientations = alone}));
    EXPECT_EQ(poses.orientations, alone);
  }
}

TEST(BatchPositions, HaveTheSameBitsByEveryDoorAndAllocateNothing) {
  for (const auto& [name, curve] : pose_of_every_family(125)) {
    SCOPED_TRACE(name);
    constexpr std::size_t count = 1000;
    const auto [start, end] = curve.orientation.domain();
    const double dt = 1.02 * (end - start) / count, t0 = start - 0.01 * (end - start);
    std::vector<double> times;
    for (std::size_t k = 0; k < count; ++k) times.push_back(static_cast<double>(k) * dt + t0);
    Poses<double> given{count}, even{count}, any{count}, planar{count, Layout::planar};
    const std::vector<double> reversed(times.rbegin(), times.rend());
    const std::size_t before = allocations_of_this_thread();
    EXPECT_TRUE(sample<double>(curve, times, given.spans()));
    EXPECT_TRUE(sample_uniform<double>(curve, t0, dt, even.spans()));
    EXPECT_TRUE(sample_at<double>(curve, reversed, any.spans()));
    EXPECT_TRUE(sample<double>(curve, times, planar.spans()));
    EXPECT_EQ(allocations_of_this_thread(), before);
    EXPECT_EQ(even.positions, given.positions);
    EXPECT_EQ(even.velocities, given.velocities);
    EXPECT_EQ(even.accelerations, given.accelerations);
    EXPECT_EQ(even.jerks, given.jerks);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(planar[i].position, given[i].position) << i;
      ASSERT_EQ(planar[i].acceleration, given[i].acceleration) << i;
      ASSERT_EQ(planar[i].jerk, given[i].jerk) << i;
      ASSERT_EQ(any[count - 1 - i].position, given[i].position) << i;
      ASSERT_EQ(any[count - 1 - i].acceleration, given[i].acceleration) << i;
      ASSERT_EQ(any[count - 1 - i].jerk, given[i].jerk) << i;
    }
  }
}

TEST(BatchPositions, HoldTheEndsAtRestAndAnswerNaNByNaN) {
  const PoseCurve curve = make_pose_curve("timed-c2", keyframes(posed_walk(127, 9, Spacing::uneven))).value();
  const auto [start, end] = curve.orientation.domain();
  const std::vector<double> times{-infinity, start - 1.0, nan, end + 1.0, infinity};
  Poses<double> poses{times.size()};
  ASSERT_TRUE(sample<double>(curve, times, poses.spans()));
  for (const std::size_t i : {0U, 1U, 3U, 4U}) {
    EXPECT_EQ(poses[i].position, curve.position->linear_motion(i < 2 ? start : end).position) << i;
    EXPECT_EQ(poses[i].velocity, Eigen::Vector3d::Zero()) << i;
    EXPECT_EQ(poses[i].acceleration, Eigen::Vector3d::Zero()) << i;
    EXPECT_EQ(poses[i].jerk, Eigen::Vector3d::Zero()) << i;
  }
  EXPECT_TRUE(poses[2].position.array().isNaN().all() && poses[2].velocity.array().isNaN().all() &&
              poses[2].acceleration.array().isNaN().all() && poses[2].jerk.array().isNaN().all());
}

TEST(BatchPositions, OfOneKeyAreThatKey) {
  const KeyframeData data = posed_walk(129, 1, Spacing::even);
  const PoseCurve curve = make_pose_curve("squad", keyframes(data)).value();
  Poses<double> poses{3};
  ASSERT_TRUE(sample_uniform<double>(curve, data.times[0] - 1.0, 1.0, poses.spans()));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(poses[i].position, data.positions[0]);
    EXPECT_EQ(poses[i].velocity, Eigen::Vector3d::Zero());
  }
}

TEST(BatchPositions, MayBeWantedWithoutTheirRatesOrNotAtAll) {
  const PoseCurve curve = make_pose_curve("squad", keyframes(posed_walk(131, 9, Spacing::uneven))).value();
  Poses<double> all{50}, some{50}, none{50};
  ASSERT_TRUE(sample_uniform<double>(curve, 0.0, 0.05, all.spans()));
  ASSERT_TRUE(sample_uniform<double>(curve, 0.0, 0.05,
                                     Samples<double>{.orientations = some.orientations, .positions = some.positions}));
  EXPECT_EQ(some.positions, all.positions);
  EXPECT_EQ(some.velocities, std::vector<double>(150));
  ASSERT_TRUE(sample_uniform<double>(curve, 0.0, 0.05, Samples<double>{.orientations = none.orientations}));
  EXPECT_EQ(none.orientations, all.orientations);
  EXPECT_EQ(none.positions, std::vector<double>(150));
}

TEST(BatchPositions, ThatAreNotThereAreAnError) {
  Poses<double> poses{4};
  const AnyCurve curve = specimen_curve("timed-c2");
  expect_bad_argument(sample_uniform<double>(PoseCurve{curve}, 0.0, 0.1, poses.spans()),
                      "found room for positions, wanted none: the keys of the curve have no positions");
  const std::string none = "found room for positions, wanted none: the curve has orientations only";
  expect_bad_argument(sample_uniform<double>(curve, 0.0, 0.1, poses.spans()), none);
  expect_bad_argument(sample_uniform<double>(CompiledCurve<>(curve), 0.0, 0.1, poses.spans()), none);
  Samples<double> short_room = poses.spans();
  short_room.velocities = short_room.velocities.first(11);
  expect_bad_argument(sample_uniform<double>(curve, 0.0, 0.1, short_room),
                      "found room for 11 numbers of velocities, wanted 12 numbers for 4 samples");
}

}}  // namespace orispline
