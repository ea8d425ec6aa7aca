// SPDX-License-Identifier: Apache-2.0
// The entire functions of the squared angle, values and derivatives on both sides of their thresholds.
#include <orispline/math/series.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include <orispline/math/jet.hpp>
#include <support/data_table.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::DataTable;
using Jet3 = Jet<double, 3>;

struct SeriesFunction {
  const char* name;
  double (*value)(const double&);
  Jet3 (*jet)(const Jet3&);
};

void PrintTo(const SeriesFunction& test, std::ostream* out) { *out << test.name; }

class Series : public testing::TestWithParam<SeriesFunction> {};

TEST_P(Series, ValuesLoseAtMostFourBits) {
  const DataTable table("so3_series.csv");
  const auto rows = table.rows_where("function", GetParam().name);
  ASSERT_GT(rows.size(), 15u);
  for (const auto& row : rows) {
    const double wanted = row.number("c0");
    // cos and sinc pass through zero: there only an absolute error makes sense
    const double scale = std::max(std::abs(wanted), 0.25 * std::abs(GetParam().value(0.0)));
    EXPECT_LE(std::abs(GetParam().value(row.number("x")) - wanted), tolerance::four_bits * scale)
        << "x = " << row.number("x");
  }
}

TEST_P(Series, DerivativesHoldOnBothSidesOfTheThreshold) {
  const DataTable table("so3_series.csv");
  for (const auto& row : table.rows_where("function", GetParam().name)) {
    const double x = row.number("x");
    const Jet3 found = GetParam().jet(Jet3::variable(x));
    for (std::size_t k = 0; k < 4; ++k) {
      const double wanted = row.number("c" + std::to_string(k));
      // a coefficient counts as c_k x^k beside the value: just above the threshold the tiny ones lose digits of their
      // own
      const double beside_the_value = std::abs(GetParam().value(0.0)) / std::pow(std::max(1.0, x), k);
      EXPECT_NEAR(found.c[k], wanted, tolerance::algebra * std::max(std::abs(wanted), beside_the_value))
          << "order " << k << " at x = " << x;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    OfTheSquaredAngle, Series,
    testing::Values(SeriesFunction{"cos_sqrt", series::cos_sqrt<double>, series::cos_sqrt<Jet3>},
                    SeriesFunction{"sinc_sqrt", series::sinc_sqrt<double>, series::sinc_sqrt<Jet3>},
                    SeriesFunction{"versine_ratio", series::versine_ratio<double>, series::versine_ratio<Jet3>},
                    SeriesFunction{"sine_defect_ratio", series::sine_defect_ratio<double>,
                                   series::sine_defect_ratio<Jet3>},
                    SeriesFunction{"cotangent_defect_ratio", series::cotangent_defect_ratio<double>,
                                   series::cotangent_defect_ratio<Jet3>}),
    [](const auto& test) { return std::string(test.param.name); });

}}  // namespace orispline
