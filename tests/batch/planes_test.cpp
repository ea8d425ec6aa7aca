// SPDX-License-Identifier: Apache-2.0
// Planar samples as some table_rows of a larger table: its table_columns are the planes, its other numbers stay as they
// are.
#include <gtest/gtest.h>

#include <batch/refused_samples.hpp>
#include <batch/sampled.hpp>
#include <batch/specimen_curves.hpp>
#include <orispline/batch/curve_bundle.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr std::size_t table_rows = 400, first_row = 61, sample_count = 201, table_columns = 25;

/// Columns of `table_rows` numbers each, of which the samples take the middle ones from `first_row` on.
template <class T>
class Table {
 public:
  Table() : numbers_(table_rows * table_columns, untouched) {}

  /// Room for samples in the components from a column on.
  [[nodiscard]] std::span<T> room(std::size_t column, std::size_t components) {
    return std::span(numbers_).subspan(column * table_rows + first_row, (components - 1) * table_rows + sample_count);
  }
  [[nodiscard]] Samples<T> angular() {
    return {.orientations = room(0, 4),
            .angular_velocities = room(4, 3),
            .angular_accelerations = room(7, 3),
            .angular_jerks = room(10, 3),
            .layout = Layout::planar,
            .plane = table_rows};
  }
  [[nodiscard]] Samples<T> all() {
    Samples<T> spans = angular();
    spans.positions = room(13, 3);
    spans.velocities = room(16, 3);
    spans.accelerations = room(19, 3);
    spans.linear_jerks = room(22, 3);
    return spans;
  }

  /// The table_rows of the samples hold what the planes of their own hold, the other table_rows and table_columns
  /// nothing.
  void expect(std::size_t column, std::size_t components, const std::vector<T>& planes) {
    for (std::size_t k = 0; k < components; ++k)
      for (std::size_t row = 0; row < table_rows; ++row) {
        const bool inside = row >= first_row && row < first_row + sample_count;
        const T wanted = inside ? planes[k * sample_count + row - first_row] : untouched;
        ASSERT_EQ(numbers_[(column + k) * table_rows + row], wanted) << "column " << column + k << ", row " << row;
      }
  }
  void expect_untouched_from(std::size_t column) {
    for (std::size_t i = column * table_rows; i < numbers_.size(); ++i) ASSERT_EQ(numbers_[i], untouched);
  }

 private:
  static constexpr T untouched = T(12345);
  std::vector<T> numbers_;
};

/// Planes of the samples alone.
template <class T>
struct Planes {
  std::vector<T> orientations = std::vector<T>(4 * sample_count), angular_velocities = std::vector<T>(3 * sample_count),
                 angular_accelerations = angular_velocities, angular_jerks = angular_velocities,
                 positions = angular_velocities, velocities = angular_velocities, accelerations = angular_velocities,
                 linear_jerks = angular_velocities;

  [[nodiscard]] Samples<T> angular() {
    return {.orientations = orientations,
            .angular_velocities = angular_velocities,
            .angular_accelerations = angular_accelerations,
            .angular_jerks = angular_jerks,
            .layout = Layout::planar};
  }
  [[nodiscard]] Samples<T> all() {
    Samples<T> spans = angular();
    spans.positions = positions;
    spans.velocities = velocities;
    spans.accelerations = accelerations;
    spans.linear_jerks = linear_jerks;
    return spans;
  }
};

/// Times over the whole domain and beyond, where the ends are held.
struct GridBeyondTheEnds {
  explicit GridBeyondTheEnds(const Domain& domain)
      : step(1.1 * (domain.end - domain.start) / sample_count), start(domain.start - 9.0 * step) {
    for (std::size_t k = 0; k < sample_count; ++k) times.push_back(static_cast<double>(k) * step + start);
  }
  double step, start;
  std::vector<double> times;
};

template <class T>
void expect_rows_of_a_table(const PoseCurve& curve) {
  const GridBeyondTheEnds grid(curve.orientation.domain());
  Planes<T> planes;
  ASSERT_TRUE(sample<T>(curve, grid.times, planes.all()));
  const auto expect_in = [&](Table<T>& table) {
    table.expect(0, 4, planes.orientations);
    table.expect(4, 3, planes.angular_velocities);
    table.expect(7, 3, planes.angular_accelerations);
    table.expect(10, 3, planes.angular_jerks);
  };
  Table<T> poses, evenly, compiled, of_baked;
  ASSERT_TRUE(sample_at<T>(curve, grid.times, poses.all()));
  expect_in(poses);
  poses.expect(13, 3, planes.positions);
  poses.expect(16, 3, planes.velocities);
  poses.expect(19, 3, planes.accelerations);
  poses.expect(22, 3, planes.linear_jerks);
  ASSERT_TRUE(sample_uniform<T>(curve.orientation, grid.start, grid.step, evenly.angular()));
  expect_in(evenly);
  evenly.expect_untouched_from(13);
  ASSERT_TRUE(sample<T>(CompiledCurve<T>(curve.orientation), grid.times, compiled.angular()));
  expect_in(compiled);
  compiled.expect_untouched_from(13);
  const BakedCurve<T> baked = bake<T>(curve.orientation, 1e-6).value();
  ASSERT_TRUE(sample<T>(baked, grid.times, planes.angular()));
  ASSERT_TRUE(sample<T>(baked, grid.times, of_baked.angular()));
  expect_in(of_baked);
  of_baked.expect_untouched_from(13);
}

TEST(BatchPlanes, MayBeTheColumnsOfALargerTable) {
  for (const char* kind : kinds_of_curves) {
    SCOPED_TRACE(kind);
    const PoseCurve curve = make_pose_curve(kind, keyframes(posed_walk(151, 9, Spacing::uneven, 0.7))).value();
    expect_rows_of_a_table<double>(curve);
    expect_rows_of_a_table<float>(curve);
  }
}

TEST(BatchPlanes, OfABundleMayBeTheColumnsOfALargerTable) {
  std::vector<AnyCurve> curves(sample_count, specimen_curve("timed-c2"));
  const auto bundle = CurveBundle<double>::make(curves).value();
  for (const double t : {0.4, curves.front().domain().end + 1.0}) {
    Planes<double> planes;
    Table<double> table;
    ASSERT_TRUE(bundle.sample(t, {.orientations = planes.orientations, .layout = Layout::planar}));
    ASSERT_TRUE(bundle.sample(t, {.orientations = table.room(0, 4), .layout = Layout::planar, .plane = table_rows}));
    table.expect(0, 4, planes.orientations);
    table.expect_untouched_from(4);
  }
}

Expected<void> sampled_into(const Samples<double>& out) {
  return sample_uniform<double>(specimen_curve("timed-c2"), 0.0, 0.01, out);
}

TEST(BatchPlanes, ThatDoNotBelongTogetherAreAnError) {
  std::vector<double> q(35), v(26);
  expect_bad_argument(sampled_into({.orientations = q, .layout = Layout::interleaved, .plane = 10}),
                      "found a distance between planes for samples that are interleaved, wanted a planar layout");
  expect_bad_argument(sampled_into({.orientations = q, .layout = Layout::planar, .plane = 4}),
                      "found planes 4 numbers apart, wanted 23 or more for as many samples");
  expect_bad_argument(sampled_into({.orientations = q, .angular_velocities = v, .layout = Layout::planar, .plane = 10}),
                      "found room for 26 numbers of angular velocities, wanted 25 numbers for 5 samples");
  const AnyCurve curve = specimen_curve("timed-c2");
  EXPECT_TRUE(sample<double>(curve, std::vector(5, 0.0), {.orientations = q, .layout = Layout::planar, .plane = 10}));
  EXPECT_FALSE(sample<double>(curve, std::vector(6, 0.0), {.orientations = q, .layout = Layout::planar, .plane = 10}));
  EXPECT_TRUE(sample<double>(curve, {}, {.orientations = {}, .layout = Layout::planar, .plane = 10}));
}

}}  // namespace orispline
