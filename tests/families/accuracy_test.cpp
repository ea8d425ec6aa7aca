// SPDX-License-Identifier: Apache-2.0
// Order of accuracy: how fast a curve through ever denser keys of a smooth motion approaches that motion.
#include <ostream>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// A smooth motion whose angular velocities at different times do not commute.
Eigen::Quaterniond smooth_motion(double t) {
  return exp<double>(Eigen::Vector3d(0.9 * std::sin(t), 0.5 * t, 0.3 * std::cos(1.3 * t))) *
         exp<double>(Eigen::Vector3d(0.2 * t * t, -0.4 * std::cos(t), 0.6 * std::sin(0.7 * t)));
}

enum class Knotting { even, graded };  // graded: the last step is four times the first
enum class Where { inside, first_segment };

double error_with(const std::string& family, std::size_t segments, Knotting knotting, const CurveOptions& options,
                  Where where) {
  KeyframeData data;
  for (std::size_t i = 0; i <= segments; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(segments);
    data.times.push_back(2.0 * (knotting == Knotting::even ? x : (std::pow(4.0, x) - 1.0) / 3.0));
    data.orientations.push_back(smooth_motion(data.times.back()));
  }
  const AnyCurve curve = make_curve({family, options}, keyframes(data, Signs::shortest)).value();
  double largest = 0.0;
  const auto compare = [&](double from, double to) {
    for (int k = 0; k <= 200; ++k) {
      const double t = from + (to - from) * k / 200.0;
      largest = std::max(largest, angular_distance(curve(t), smooth_motion(t)));
    }
  };
  if (where == Where::inside) compare(0.5, 1.5);
  else compare(data.times[0], data.times[1]);
  return largest;
}

double observed_order(const std::string& family, Knotting knotting, const CurveOptions& options = {},
                      Where where = Where::inside) {
  return std::log2(error_with(family, 64, knotting, options, where) /
                   error_with(family, 128, knotting, options, where));
}

struct StatedOrder {
  const char* family;
  Knotting knotting;
  double order;
};

void PrintTo(const StatedOrder& test, std::ostream* out) { *out << test.family; }

class Accuracy : public testing::TestWithParam<StatedOrder> {};

TEST_P(Accuracy, IsOfTheStatedOrder) {
  EXPECT_NEAR(observed_order(GetParam().family, GetParam().knotting), GetParam().order, 0.3);
}

INSTANTIATE_TEST_SUITE_P(
    OnASmoothMotion, Accuracy,
    testing::Values(StatedOrder{"slerp", Knotting::even, 2}, StatedOrder{"slerp", Knotting::graded, 2},
                    StatedOrder{"squad", Knotting::even, 3}, StatedOrder{"squad-timed", Knotting::graded, 3},
                    StatedOrder{"quintic", Knotting::even, 2}, StatedOrder{"sextic", Knotting::even, 2},
                    StatedOrder{"timed-c1", Knotting::graded, 3}, StatedOrder{"timed-c2", Knotting::graded, 3},
                    StatedOrder{"timed-c3", Knotting::graded, 3}, StatedOrder{"timed-sextic", Knotting::graded, 2},
                    StatedOrder{"timed-c2", Knotting::even, 3}),
    [](const auto& test) {
      std::string name = test.param.family;
      std::ranges::replace(name, '-', '_');
      return name + (test.param.knotting == Knotting::even ? "_even" : "_graded");
    });

TEST(AutoAccuracy, OfAutoIsSixthOrderInsideAndOfAuto5Fifth) {
  // At least: on even times, and where the step grows fourfold. The quintics between exact jets are of sixth order.
  for (const Knotting knotting : {Knotting::even, Knotting::graded}) {
    EXPECT_GE(observed_order("auto", knotting), 5.5);
    EXPECT_GE(observed_order("auto5", knotting), 4.5);
  }
}

TEST(EndAccuracy, OfTheFirstSegmentDependsOnTheEndRule) {
  const auto order = [](EndRule rule) {
    return observed_order("timed-c2", Knotting::even, {.start = {.rule = rule}}, Where::first_segment);
  };
  EXPECT_NEAR(order(EndRule::repeat), 1.0, 0.3);
  EXPECT_NEAR(order(EndRule::natural), 2.0, 0.3);
  EXPECT_NEAR(order(EndRule::quadratic), 3.0, 0.3);
  EXPECT_NEAR(order(EndRule::cubic), 3.0, 0.5);
}

}}  // namespace orispline
