// SPDX-License-Identifier: Apache-2.0
// Many curves side by side: the same orientations as one by one, and an answer for curves that do not belong together.
#include <gtest/gtest.h>

#include <orispline/batch/curve_bundle.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

AnyCurve curve_of(std::string_view family, std::uint64_t seed, const std::vector<double>& times, double step = 1.4) {
  KeyframeData data = random_walk(seed, times.size(), Spacing::even, step);
  data.times = times;
  return make_curve(family, keyframes(std::move(data))).value();
}

const std::vector<double> uneven{0.0, 0.7, 1.9, 2.4, 3.9};

std::vector<AnyCurve> curves_of(std::string_view family, std::size_t count, double step = 1.4) {
  std::vector<AnyCurve> curves;
  for (std::size_t i = 0; i < count; ++i) curves.push_back(curve_of(family, 700 + i, uneven, step));
  return curves;
}

template <class T>
double largest_difference(const std::vector<AnyCurve>& curves, double t, Layout layout) {
  const auto bundle = CurveBundle<T>::make(curves).value();
  std::vector<T> q(4 * curves.size());
  EXPECT_TRUE(bundle.sample(t, Samples<T>{.orientations = q, .layout = layout}));
  double largest = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Eigen::Vector4d expected = curves[i](t).coeffs();
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t at = layout == Layout::planar ? k * curves.size() + i : 4 * i + k;
      largest = std::max(largest, std::abs(static_cast<double>(q[at]) - expected[static_cast<Eigen::Index>(k)]));
    }
  }
  return largest;
}

TEST(CurveBundle, GivesTheOrientationsOfItsCurves) {
  for (const char* family : {"slerp", "quintic", "sextic", "timed-c2", "timed-c3", "bspline"})
    for (const std::size_t count : {1U, 7U, 128U, 300U})
      for (const double t : {-1.0, 0.0, 0.3, 0.7, 2.0, 3.9, 5.0})
        for (const Layout layout : {Layout::interleaved, Layout::planar}) {
          EXPECT_LE(largest_difference<double>(curves_of(family, count), t, layout), 4e-15) << family << ", t = " << t;
          EXPECT_LE(largest_difference<float>(curves_of(family, count), t, layout), 1e-6) << family << ", t = " << t;
        }
}

TEST(CurveBundle, AnswersWideTurnsByTheCurvesThemselves) {
  const auto curves = curves_of("timed-c2", 5, 3.1);
  for (const double t : {0.3, 1.0, 3.0}) EXPECT_LE(largest_difference<double>(curves, t, Layout::interleaved), 4e-15);
}

TEST(CurveBundle, AnswersNotANumberToNotANumber) {
  const auto bundle = CurveBundle<double>::make(curves_of("timed-c2", 3)).value();
  std::vector<double> q(12);
  ASSERT_TRUE(bundle.sample(std::numeric_limits<double>::quiet_NaN(), Samples<double>{q}));
  for (const double x : q) EXPECT_TRUE(std::isnan(x));
}

TEST(CurveBundle, NamesTheCurveThatDoesNotBelong) {
  auto curves = curves_of("timed-c2", 3);
  EXPECT_EQ(CurveBundle<double>::make({}).error().code, ErrorCode::bad_argument);
  auto other_times = curves;
  other_times.push_back(curve_of("timed-c2", 1, {0.0, 0.7, 1.9, 2.4, 4.0}));
  EXPECT_EQ(CurveBundle<double>::make(other_times).error().where.curve, 3U);
  auto other_method = curves;
  other_method[1] = curve_of("timed-c3", 1, uneven);
  EXPECT_EQ(CurveBundle<double>::make(other_method).error().where.curve, 1U);
  auto other_kind = curves;
  other_kind[2] = curve_of("auto", 1, uneven);
  EXPECT_EQ(CurveBundle<double>::make(other_kind).error().where.curve, 2U);
}

TEST(CurveBundle, RefusesRoomForAnotherNumberAndRates) {
  const auto bundle = CurveBundle<double>::make(curves_of("timed-c2", 3)).value();
  std::vector<double> q(12), wrong(16), rates(9);
  EXPECT_EQ(bundle.sample(0.5, Samples<double>{wrong}).error().message,
            "found room for 16 numbers of orientations, wanted 12 numbers for 3 samples");
  EXPECT_FALSE(bundle.sample(0.5, Samples<double>{q, rates}));
}

}}  // namespace orispline
