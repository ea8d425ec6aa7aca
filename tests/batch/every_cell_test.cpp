// SPDX-License-Identifier: Apache-2.0
// Every kind of curve at every kind of times gives every output that it has, as the scalar evaluator does.
#include <array>

#include <gtest/gtest.h>

#include <batch/sampled.hpp>
#include <batch/specimen_curves.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// What can be asked for beside the orientation.
template <class T>
struct Output {
  const char* name;
  std::span<T> Samples<T>::*room;
  Eigen::Vector3d (*wanted)(const PoseCurve&, double t);
  std::size_t order;
  bool is_linear;
};

template <class T>
constexpr std::array<Output<T>, 7> outputs{{
    {"angular velocity", &Samples<T>::angular_velocities,
     [](const PoseCurve& c, double t) { return c.orientation.motion(t).angular_velocity; }, 1, false},
    {"angular acceleration", &Samples<T>::angular_accelerations,
     [](const PoseCurve& c, double t) { return c.orientation.motion(t).angular_acceleration; }, 2, false},
    {"angular jerk", &Samples<T>::angular_jerks,
     [](const PoseCurve& c, double t) { return c.orientation.motion(t).angular_jerk; }, 3, false},
    {"position", &Samples<T>::positions,
     [](const PoseCurve& c, double t) { return c.position->linear_motion(t).position; }, 0, true},
    {"velocity", &Samples<T>::velocities,
     [](const PoseCurve& c, double t) { return c.position->linear_motion(t).velocity; }, 1, true},
    {"acceleration", &Samples<T>::accelerations,
     [](const PoseCurve& c, double t) { return c.position->linear_motion(t).acceleration; }, 2, true},
    {"jerk", &Samples<T>::linear_jerks, [](const PoseCurve& c, double t) { return c.position->linear_motion(t).jerk; },
     3, true},
}};

/// Allowed differences from the scalar evaluator by order, as shares of the largest value, which is 1 at least.
using Shares = std::array<double, 4>;
template <class T>
constexpr Shares rounding = sizeof(T) == 8 ? Shares{1e-14, 1e-13, 1e-12, 1e-11} : Shares{1e-6, 1e-6, 2e-6, 4e-6};
template <class T>
constexpr Shares of_baked = sizeof(T) == 8 ? Shares{1e-12, 1e-9, 5e-7, 1e-4} : Shares{1e-6, 2e-4, 2e-2, 1.0};

// The sources.
struct Curve {
  static constexpr bool has_positions = false;
  template <class T>
  static constexpr Shares shares = rounding<T>;
  template <class T>
  static AnyCurve of(const PoseCurve& pose) {
    return pose.orientation;
  }
};
struct Compiled {
  static constexpr bool has_positions = false;
  template <class T>
  static constexpr Shares shares = rounding<T>;
  template <class T>
  static CompiledCurve<T> of(const PoseCurve& pose) {
    return CompiledCurve<T>(pose.orientation);
  }
};
struct Baked {
  static constexpr bool has_positions = false;
  template <class T>
  static constexpr Shares shares = of_baked<T>;
  template <class T>
  static BakedCurve<T> of(const PoseCurve& pose) {
    return bake<T>(pose.orientation, sizeof(T) == 8 ? 1e-12 : 1e-6).value();
  }
};
struct Pose {
  static constexpr bool has_positions = true;
  template <class T>
  static constexpr Shares shares = rounding<T>;
  template <class T>
  static PoseCurve of(const PoseCurve& pose) {
    return pose;
  }
};

constexpr std::size_t samples_of_a_cell = 207;

/// Even times, the ends of the curve among them and some beyond.
struct GridWithTheEnds {
  explicit GridWithTheEnds(const Domain& domain)
      : step((domain.end - domain.start) / 200.0), start(domain.start - 3.0 * step), domain_(domain) {
    for (std::size_t k = 0; k < samples_of_a_cell; ++k) times.push_back(static_cast<double>(k) * step + start);
  }
  [[nodiscard]] bool is_held(double t) const { return !domain_.contains(t); }

  double step, start;
  std::vector<double> times;

 private:
  Domain domain_;
};

// The queries. Each gives the samples in the order of the grid.
struct Evenly {
  template <class T, class C>
  static Expected<void> take(const C& curve, const GridWithTheEnds& grid, const Samples<T>& out) {
    return sample_uniform<T>(curve, grid.start, grid.step, out);
  }
};
struct Sorted {
  template <class T, class C>
  static Expected<void> take(const C& curve, const GridWithTheEnds& grid, const Samples<T>& out) {
    return sample<T>(curve, grid.times, out);
  }
};
struct InAnyOrder {
  static std::size_t place(std::size_t i) { return (i * 100) % samples_of_a_cell; }
  template <class T, class C>
  static Expected<void> take(const C& curve, const GridWithTheEnds& grid, const Samples<T>& out) {
    std::vector<double> times(samples_of_a_cell);
    for (std::size_t i = 0; i < samples_of_a_cell; ++i) times[i] = grid.times[place(i)];
    auto sampled = sample_at<T>(curve, times, out);
    sort(out.orientations, 4);
    for (const Output<T>& output : outputs<T>) sort(out.*output.room, 3);
    return sampled;
  }

 private:
  template <class T>
  static void sort(std::span<T> numbers, std::size_t components) {
    const std::vector<T> mixed(numbers.begin(), numbers.end());
    for (std::size_t i = 0; i < mixed.size(); ++i)
      numbers[components * place(i / components) + i % components] = mixed[i];
  }
};

template <class T, class Source, class Query>
struct Cell {
  using Number = T;
  using From = Source;
  using By = Query;
};
template <class T>
Eigen::Vector3d three_at(const std::vector<T>& numbers, std::size_t i) {
  return {static_cast<double>(numbers[3 * i]), static_cast<double>(numbers[3 * i + 1]),
          static_cast<double>(numbers[3 * i + 2])};
}

template <class T>
void expect_orientations(const std::vector<T>& found, const PoseCurve& pose, const GridWithTheEnds& grid,
                         double allowed) {
  for (std::size_t i = 0; i < samples_of_a_cell; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      ASSERT_NEAR(static_cast<double>(found[4 * i + k]),
                  pose.orientation(grid.times[i]).coeffs()[static_cast<Eigen::Index>(k)], allowed)
          << "component " << k << " at " << grid.times[i] << " s";
}

template <class T>
void expect_output(const Output<T>& output, const std::vector<T>& found, const PoseCurve& pose,
                   const GridWithTheEnds& grid, double share) {
  double largest = 1.0;
  for (const double t : grid.times) largest = std::max(largest, output.wanted(pose, t).norm());
  for (std::size_t i = 0; i < samples_of_a_cell; ++i) {
    const Eigen::Vector3d wanted = output.wanted(pose, grid.times[i]);
    const double allowed = grid.is_held(grid.times[i]) && output.order > 0 ? 0.0 : share * largest;
    ASSERT_LE((three_at(found, i) - wanted).norm(), allowed)
        << output.name << " at " << grid.times[i] << " s, wanted " << wanted.transpose();
  }
}

/// One output at a time beside the orientation, which is always given.
template <class Cell>
void expect_every_output(const PoseCurve& pose) {
  using T = typename Cell::Number;
  using Source = typename Cell::From;
  const auto curve = Source::template of<T>(pose);
  const GridWithTheEnds grid(pose.orientation.domain());
  const Shares shares = Source::template shares<T>;
  for (const Output<T>& output : outputs<T>) {
    std::vector<T> orientations(4 * samples_of_a_cell), numbers(3 * samples_of_a_cell);
    Samples<T> out{.orientations = orientations};
    out.*output.room = numbers;
    const auto sampled = Cell::By::template take<T>(curve, grid, out);
    if (output.is_linear && !Source::has_positions) {
      ASSERT_FALSE(sampled) << output.name;
      EXPECT_EQ(sampled.error().code, ErrorCode::bad_argument);
      continue;
    }
    ASSERT_TRUE(sampled) << output.name << ": " << describe(sampled.error());
    expect_orientations(orientations, pose, grid, shares[0]);
    expect_output(output, numbers, pose, grid, shares[output.order]);
  }
}

/// All outputs at once are, to rounding, those that are asked for alone.
template <class Cell>
void expect_all_outputs_at_once(const PoseCurve& pose) {
  using T = typename Cell::Number;
  using Source = typename Cell::From;
  const auto curve = Source::template of<T>(pose);
  const GridWithTheEnds grid(pose.orientation.domain());
  std::vector<T> orientations(4 * samples_of_a_cell);
  std::array<std::vector<T>, outputs<T>.size()> numbers;
  Samples<T> out{.orientations = orientations};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (outputs<T>[k].is_linear && !Source::has_positions) continue;
    numbers[k].resize(3 * samples_of_a_cell);
    out.*outputs<T>[k].room = numbers[k];
  }
  ASSERT_TRUE(Cell::By::template take<T>(curve, grid, out));
  const Shares shares = Source::template shares<T>;
  expect_orientations(orientations, pose, grid, shares[0]);
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (!numbers[k].empty()) expect_output(outputs<T>[k], numbers[k], pose, grid, shares[outputs<T>[k].order]);
}

template <class Cell>
class BatchTable : public testing::Test {
 public:
  static std::vector<PoseCurve> curves() {
    std::vector<PoseCurve> all;
    for (const char* kind : kinds_of_curves)
      all.push_back(make_pose_curve(kind, keyframes(posed_walk(161, 9, Spacing::even, 0.7))).value());
    return all;
  }
};

using Cells =
    testing::Types<Cell<double, Curve, Evenly>, Cell<double, Curve, Sorted>, Cell<double, Curve, InAnyOrder>,
                   Cell<double, Compiled, Evenly>, Cell<double, Compiled, Sorted>, Cell<double, Compiled, InAnyOrder>,
                   Cell<double, Baked, Evenly>, Cell<double, Baked, Sorted>, Cell<double, Baked, InAnyOrder>,
                   Cell<double, Pose, Evenly>, Cell<double, Pose, Sorted>, Cell<double, Pose, InAnyOrder>,
                   Cell<float, Curve, Evenly>, Cell<float, Curve, Sorted>, Cell<float, Curve, InAnyOrder>,
                   Cell<float, Compiled, Evenly>, Cell<float, Compiled, Sorted>, Cell<float, Compiled, InAnyOrder>,
                   Cell<float, Baked, Evenly>, Cell<float, Baked, Sorted>, Cell<float, Baked, InAnyOrder>,
                   Cell<float, Pose, Evenly>, Cell<float, Pose, Sorted>, Cell<float, Pose, InAnyOrder>>;
TYPED_TEST_SUITE(BatchTable, Cells);

TYPED_TEST(BatchTable, GivesEachOutputAloneAsTheScalarEvaluatorDoes) {
  for (const PoseCurve& pose : this->curves()) expect_every_output<TypeParam>(pose);
}

TYPED_TEST(BatchTable, GivesAllOutputsAtOnceAsTheScalarEvaluatorDoes) {
  for (const PoseCurve& pose : this->curves()) expect_all_outputs_at_once<TypeParam>(pose);
}

}}  // namespace orispline
