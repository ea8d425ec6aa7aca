// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <orispline/families/blending/rows.hpp>
#include <orispline/families/blending/surroundings.hpp>

// How rows of expressions meet at a joint of two segments, over any field.

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// The derivatives by u, of orders 0 to n, of all increments on both sides of a joint: [increment][order].
template <class Value>
struct JointJets {
  Coefficients<Value> left, right;
};

/// At u = 0: n!/(n-m)! Δᵐc₀; at u = 1 the same of the last coefficients.
template <class Value>
std::vector<Value> derivatives_at(const std::vector<Value>& row, bool at_end, const SegmentField<Value>& field) {
  std::vector<Value> differences = row, derivatives;
  const std::size_t n = row.size() - 1;
  Value factor = field.constant(whole(1));
  for (std::size_t m = 0; m <= n; ++m) {
    derivatives.push_back(factor * (at_end ? differences[n - m] : differences[0]));
    factor = factor * field.constant(whole(n - m));
    for (std::size_t i = 0; i + 1 < differences.size() - m; ++i) differences[i] = differences[i + 1] - differences[i];
  }
  return derivatives;
}

template <class Value>
JointJets<Value> joint_jets(const Rows& rows, const Surroundings<Value>& around) {
  const SegmentField<Value> before{around, 0}, behind{around, 1};
  const auto left_rows = rows.cumulative(before), right_rows = rows.cumulative(behind);
  const std::size_t orders = rows.degree() + 1;
  const auto constant = [&](std::uint64_t value) {
    std::vector<Value> jet(orders, before.constant(whole(0)));
    jet[0] = before.constant(whole(value));
    return jet;
  };
  JointJets<Value> jets;
  jets.right.push_back(constant(1));  // of the first increment, which is behind for good
  for (const auto& row : left_rows) jets.left.push_back(derivatives_at(row, true, before));
  for (const auto& row : right_rows) jets.right.push_back(derivatives_at(row, false, behind));
  jets.left.push_back(constant(0));  // of the last one, which has not begun
  return jets;
}

/// What keeps a derivative of order m from going on through the joint, increment by increment: 0 where it does.
template <class Value>
std::vector<Value> jumps(const Rows& rows, const Surroundings<Value>& around, std::size_t order) {
  const JointJets<Value> jets = joint_jets(rows, around);
  const SegmentField<Value> field{around, 0};
  std::vector<Value> found;
  for (std::size_t j = 0; j < jets.left.size(); ++j) {
    Value left = jets.left[j][order], right = jets.right[j][order];
    for (std::size_t m = 0; m < order; ++m) {
      left = left / field.length(0);
      right = right / field.length(1);
    }
    found.push_back(right - left);
  }
  return found;
}

/// What keeps the curve from its keys: increments up to the key are whole there, those behind have not begun.
template <class Value>
std::vector<Value> misses(const Rows& rows, const Surroundings<Value>& around) {
  const JointJets<Value> jets = joint_jets(rows, around);
  const SegmentField<Value> field{around, 0};
  std::vector<Value> found;
  for (std::size_t j = 0; j < jets.left.size(); ++j) {
    const bool is_whole = rows.first() + static_cast<int>(j) <= 0;
    const Value wanted = field.constant(whole(is_whole ? 1 : 0));
    found.push_back(jets.left[j][0] - wanted);
    found.push_back(jets.right[j][0] - wanted);
  }
  return found;
}

/// What keeps a constant rate from staying constant: Σ h_k β̃_k(u) is to be u h_0, from the first increment's start.
template <class Value>
std::vector<Value> unsteadiness(const Rows& rows, const Surroundings<Value>& around) {
  const SegmentField<Value> field{around, 0};
  const auto cumulative = rows.cumulative(field);
  const std::size_t n = rows.degree();
  std::vector<Value> found;
  for (std::size_t i = 0; i <= n; ++i) {
    Value sum = -(field.length(0) * field.constant(whole(i)) / field.constant(whole(n)));
    for (std::size_t k = 0; k < cumulative.size(); ++k) {
      const int interval = rows.first() + static_cast<int>(k);
      sum = sum + field.length(interval) * cumulative[k][i];
      if (interval < 0) sum = sum - field.length(interval);
    }
    found.push_back(sum);
  }
  return found;
}

/// Of blending functions of the control points: their sum less 1.
template <class Value>
std::vector<Value> sum_errors(const Rows& rows, const Surroundings<Value>& around) {
  const SegmentField<Value> field{around, 0};
  std::vector<Value> sums(rows.degree() + 1, -field.constant(whole(1)));
  for (const auto& row : rows.stated(field))
    for (std::size_t i = 0; i < row.size(); ++i) sums[i] = sums[i] + row[i];
  return sums;
}

}}}  // namespace orispline::blending
