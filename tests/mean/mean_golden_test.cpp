// SPDX-License-Identifier: Apache-2.0
// Means and medians against golden/mean_cases.csv, made by tools/make_golden.py mean with 120 digits.
#include <gtest/gtest.h>

#include <support/data_table.hpp>
#include <support/near.hpp>

#include "mean/set_of.hpp"

namespace orispline { namespace {

using testing_support::DataTable;
using testing_support::near;
using testing_support::SetOf;

SetOf samples_of(const DataTable& table, const std::string& name) {
  SetOf set;
  for (const auto& row : table.rows_where("case", name)) {
    set.orientations.push_back(row.quaternion("qw", "qx", "qy", "qz"));
    set.weights.push_back(row.number("weight"));
    set.positions.push_back(row.vector("px", "py", "pz"));
  }
  return set;
}

/// Relative to its largest element.
void expect_matrix(const std::optional<Eigen::Matrix3d>& found, const std::vector<double>& six) {
  ASSERT_TRUE(found);
  Eigen::Matrix3d wanted;
  wanted << six[0], six[3], six[4], six[3], six[1], six[5], six[4], six[5], six[2];
  EXPECT_LT((*found - wanted).cwiseAbs().maxCoeff(), 1e-9 * wanted.cwiseAbs().maxCoeff()) << *found << "\n" << wanted;
}

TEST(GoldenMeans, AreThoseOf120Digits) {
  const DataTable samples("golden/mean_samples.csv"), cases("golden/mean_cases.csv");
  for (const auto& row : cases.rows()) {
    SCOPED_TRACE(row.text("case") + " " + row.text("kind"));
    const SetOf set = samples_of(samples, row.text("case"));
    const auto found = row.text("kind") == "mean" ? set.mean() : set.median();
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_LT(angular_distance(found->orientation, row.quaternion("qw", "qx", "qy", "qz")), 1e-15);
    EXPECT_TRUE(near(found->orientation, row.quaternion("qw", "qx", "qy", "qz"), 1e-15));
    EXPECT_NEAR(found->rms_distance / row.number("rms_distance"), 1.0, 1e-9);
    EXPECT_NEAR(found->largest_distance / row.number("largest_distance"), 1.0, 1e-9);
    expect_matrix(found->spread, row.numbers("spread"));
    expect_matrix(found->covariance, row.numbers("covariance"));
    EXPECT_TRUE(near(*found->position, row.vector("px", "py", "pz"), 1e-15));
    expect_matrix(found->position_spread, row.numbers("position_spread"));
    expect_matrix(found->position_covariance, row.numbers("position_covariance"));
    EXPECT_TRUE(found->certified);
    EXPECT_LT(found->residual, 1e-15);
    EXPECT_TRUE(found->warnings.empty());
  }
  EXPECT_EQ(cases.rows().size(), 8u);
}

}}  // namespace orispline
