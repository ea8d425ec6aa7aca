// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/blending/motion_condition.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/families/blending/joint.hpp>
#include <orispline/families/blending/polynomial.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

namespace {

constexpr int key_of_joint = 1;

/// The end derivatives of one side of a joint that are not 0: each once, up to a factor, which lengths may change.
using Derivatives = std::vector<Polynomial>;

Derivatives derivatives_of(const Coefficients<Polynomial>& jets) {
  Derivatives found;
  for (const auto& jet : jets)
    if (const Polynomial one = jet[1].normal(); !one.is_zero() && std::ranges::find(found, one) == found.end())
      found.push_back(one);
  return found;
}

struct Sides {
  Derivatives left, right;
  std::string left_name{}, right_name{};  ///< of the first increment that moves

  bool operator==(const Sides&) const = default;
};

Sides sides_of(const BlendingData& data, const Rows& rows, Sequence& random) {
  const auto around = surroundings<Polynomial>(
      data, Times::uneven,
      [](std::size_t p, int place) {
        return Polynomial(Polynomial::Variable{static_cast<int>(p), place});
      },
      [&] { return Polynomial(random.next()); });
  const auto jets = joint_jets(rows, around);
  Sides sides{derivatives_of(jets.left), derivatives_of(jets.right)};
  for (std::size_t j = 1; j + 1 < jets.left.size() && sides.left_name.empty(); ++j)
    if (!jets.left[j][1].is_zero() && !jets.right[j][1].is_zero())
      sides.left_name = function_name(j, 1) + "(1)", sides.right_name = function_name(j - 1, 1) + "(0)";
  return sides;
}

/// `a ≠ 0 or 1 − b ≠ 0`, or nothing where one of them is a number.
std::optional<std::string> not_all_zero(const Derivatives& derivatives) {
  std::vector<std::string> parts;
  for (const Polynomial& one : derivatives) {
    const auto text = one.text(key_of_joint);
    if (!text) return std::nullopt;
    parts.push_back(*text + " ≠ 0");
  }
  return joined(parts, " or ");
}

bool always_move(const Derivatives& derivatives) { return std::ranges::any_of(derivatives, &Polynomial::is_number); }

}  // namespace

std::string function_name(std::size_t row, std::size_t order) {
  std::string text = formatted("β̃{}", row + 1);
  for (std::size_t k = 0; k < order; ++k) text += "′";
  return text;
}

MotionCondition motion_condition(const BlendingData& data, const Rows& rows) {
  Sequence random;
  const Sides sides = sides_of(data, rows, random);
  const bool depend_on_lengths = !(sides_of(data, rows, random) == sides);
  const auto is_known = [](const Polynomial& one) { return one.is_known(); };
  const bool are_known =
      std::ranges::all_of(sides.left, is_known) && std::ranges::all_of(sides.right, is_known) && !depend_on_lengths;
  const bool are_alike = are_known && std::ranges::is_permutation(sides.left, sides.right);
  if (are_alike && always_move(sides.left)) return {"", true};
  if (are_alike)
    if (const auto text = not_all_zero(sides.left)) return {*text, true};
  if (sides.left_name.empty()) return {"", are_alike};
  return {formatted("{} and {} have the same sign", sides.left_name, sides.right_name), are_alike};
}

}}}  // namespace orispline::blending
