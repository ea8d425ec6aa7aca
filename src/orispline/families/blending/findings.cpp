// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/blending/findings.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

namespace {

using Promise = BlendingFinding::Promise;

/// Values of all quantities around a joint. Segment 0 lies before key 1, segment 1 behind it.
template <class Value>
struct Surroundings {
  std::vector<Value> parameters;                 ///< the same at all keys
  std::map<std::pair<int, int>, Value> at_keys;  ///< by parameter and key, where they are not
  std::map<int, Value> lengths;                  ///< by interval, where they are not 1
};

/// The field of a segment.
template <class Value>
struct SegmentField {
  const Surroundings<Value>& around;
  int segment;

  [[nodiscard]] Value constant(const Literal& literal) const {
    if constexpr (std::same_as<Value, double>) return literal.real;
    else return literal.exact;
  }
  [[nodiscard]] Value quantity(const Quantity& q) const {
    const int place = q.offset + segment;
    if (q.kind == Quantity::Kind::length) {
      const auto found = around.lengths.find(place);
      return found == around.lengths.end() ? constant({1.0, Modular(1)}) : found->second;
    }
    const auto found = around.at_keys.find({q.parameter, place});
    return found == around.at_keys.end() ? around.parameters[static_cast<std::size_t>(q.parameter)] : found->second;
  }
  [[nodiscard]] Value length(int interval) const { return quantity({Quantity::Kind::length, 0, interval - segment}); }
};

constexpr int farthest_place = 18;  // a coefficient reaches 8 keys, and increments 4

/// Numbers as good as random, always the same.
class Sequence {
 public:
  Modular next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return Modular(state_ >> 2);
  }

 private:
  std::uint64_t state_ = 0x853c49e6748fea9bu;
};

enum class Times { even, uneven };

/// Parameters of their own at every key; lengths of their own, or all the same.
Surroundings<Modular> generic(const BlendingData& data, Times times) {
  Sequence random;
  Surroundings<Modular> around;
  const Modular step = random.next();
  for (int place = -farthest_place; place <= farthest_place; ++place) {
    for (std::size_t p = 0; p < data.parameters.size(); ++p)
      around.at_keys[{static_cast<int>(p), place}] = random.next();
    around.lengths[place] = times == Times::even ? step : random.next();
  }
  return around;
}

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
  Value factor = field.constant({1.0, Modular(1)});
  for (std::size_t m = 0; m <= n; ++m) {
    derivatives.push_back(factor * (at_end ? differences[n - m] : differences[0]));
    factor = factor * field.constant({static_cast<double>(n - m), Modular(n - m)});
    for (std::size_t i = 0; i + 1 < differences.size() - m; ++i) differences[i] = differences[i + 1] - differences[i];
  }
  return derivatives;
}

template <class Value>
JointJets<Value> joint_jets(const Rows& rows, const Surroundings<Value>& around) {
  const SegmentField<Value> before{around, 0}, behind{around, 1};
  const auto left_rows = rows.cumulative(before), right_rows = rows.cumulative(behind);
  const std::size_t orders = rows.degree() + 1;
  const auto constant = [&](double value) {
    std::vector<Value> jet(orders, before.constant({0.0, Modular(0)}));
    jet[0] = before.constant({value, Modular(static_cast<std::uint64_t>(value))});
    return jet;
  };
  JointJets<Value> jets;
  jets.right.push_back(constant(1.0));  // of the first increment, which is behind for good
  for (const auto& row : left_rows) jets.left.push_back(derivatives_at(row, true, before));
  for (const auto& row : right_rows) jets.right.push_back(derivatives_at(row, false, behind));
  jets.left.push_back(constant(0.0));  // of the last one, which has not begun
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
    const Value wanted = field.constant({is_whole ? 1.0 : 0.0, Modular(is_whole ? 1 : 0)});
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
    const auto whole = [&](std::size_t number) {
      return field.constant({static_cast<double>(number), Modular(number)});
    };
    Value sum = -(field.length(0) * whole(i) / whole(n));
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
  std::vector<Value> sums(rows.degree() + 1, -field.constant({1.0, Modular(1)}));
  for (const auto& row : rows.stated(field))
    for (std::size_t i = 0; i < row.size(); ++i) sums[i] = sums[i] + row[i];
  return sums;
}

bool all_zero(const std::vector<Modular>& values) {
  return std::ranges::all_of(values, [](Modular value) { return value == Modular(); });
}

template <class Residuals>
int order_of_continuity(const Residuals& jumps_of_order, std::size_t highest) {
  std::size_t next = 0;
  while (next <= highest && all_zero(jumps_of_order(next))) ++next;
  return static_cast<int>(next) - 1;
}

/// The largest k for which the derivatives by u on the right are those on the left after a change of the parameter:
/// R₁ = s L₁, R₂ = s² L₂ + c L₁, R₃ = s³ L₃ + 3 s c L₂ + d L₁ with the same s, c, d for all increments.
int order_of_shape(const Rows& rows, const Surroundings<Modular>& around) {
  const JointJets<Modular> jets = joint_jets(rows, around);
  const auto &l = jets.left, &r = jets.right;
  const auto moving = std::ranges::find_if(l, [](const auto& jet) { return jet[1] != Modular(); });
  if (moving == l.end()) return 0;
  const auto m = static_cast<std::size_t>(moving - l.begin());
  const std::size_t highest = std::min<std::size_t>(3, rows.degree());
  Modular s, c, d;
  const auto carried = [&](std::size_t j, std::size_t order) {
    return order == 1   ? s * l[j][1]
           : order == 2 ? s * s * l[j][2] + c * l[j][1]
                        : s * s * s * l[j][3] + Modular(3) * s * c * l[j][2] + d * l[j][1];
  };
  int found = 0;
  for (std::size_t order = 1; order <= highest; ++order) {
    Modular& free = order == 1 ? s : order == 2 ? c : d;
    free = (r[m][order] - carried(m, order)) / l[m][1];
    for (std::size_t j = 0; j < l.size(); ++j)
      if (r[j][order] != carried(j, order)) return found;
    found = static_cast<int>(order);
  }
  return found;
}

/// Values of the parameters, the same at all keys, for which residuals that are affine in them vanish, as text such as
/// `tension = 1/2`; nothing where there are none, or not just one.
template <class Residuals>
std::string condition(const BlendingData& data, const Residuals& residuals) {
  const std::size_t count = data.parameters.size();
  if (count == 0) return "";
  const auto at = [&](const std::vector<Modular>& values) { return residuals(values); };
  std::vector<Modular> place(count);
  const auto origin = at(place);
  Coefficients<Modular> system;  // a row an equation: the slopes, then the constant
  for (const Modular value : origin) {
    auto& row = system.emplace_back(count + 1);
    row[count] = value;
  }
  for (std::size_t p = 0; p < count; ++p) {
    place[p] = Modular(1);
    const auto moved = at(place);
    for (std::size_t e = 0; e < system.size(); ++e) system[e][p] = moved[e] - origin[e];
    place[p] = Modular();
  }
  // Gauss–Jordan.
  std::size_t rank = 0;
  for (std::size_t p = 0; p < count; ++p) {
    const auto pivot = std::find_if(system.begin() + static_cast<std::ptrdiff_t>(rank), system.end(),
                                    [&](const auto& row) { return row[p] != Modular(); });
    if (pivot == system.end()) return "";
    std::swap(*pivot, system[rank]);
    for (std::size_t k = count + 1; k-- > 0;) system[rank][k] = system[rank][k] / system[rank][p];
    for (std::size_t e = 0; e < system.size(); ++e)
      if (e != rank)
        for (const Modular factor = system[e][p]; Modular & cell : system[e]) {
          const auto k = static_cast<std::size_t>(&cell - system[e].data());
          cell = cell - factor * system[rank][k];
        }
    ++rank;
  }
  std::vector<std::string> values;
  for (std::size_t p = 0; p < count; ++p) {
    place[p] = -system[p][count];
    const auto text = fraction_text(place[p]);
    if (!text) return "";
    values.push_back(formatted("{} = {}", data.parameters[p].name, *text));
  }
  return all_zero(at(place)) ? joined(values, ", ") : "";
}

std::string primes(std::size_t order) {
  std::string text;
  for (std::size_t k = 0; k < order; ++k) text += "′";
  return text;
}

/// The row of a jet of a joint, in words; increments are counted from 1 as rows are.
std::string function_name(std::size_t row, std::size_t order) { return formatted("β̃{}{}", row + 1, primes(order)); }

Surroundings<double> defaults(const BlendingData& data) {
  Surroundings<double> around;
  for (const BlendingParameter& parameter : data.parameters) around.parameters.push_back(parameter.initial);
  return around;
}

Surroundings<Modular> same_everywhere(const std::vector<Modular>& values, Times times, const BlendingData& data) {
  Surroundings<Modular> around = generic(data, times);
  around.at_keys.clear();
  around.parameters = values;
  return around;
}

/// A default in the field: the fraction of small numbers that it is nearest to, such as 1/12, or else its decimal.
Modular exact_default(double value) {
  constexpr int largest_denominator = 1000;
  for (int q = 1; q <= largest_denominator; ++q) {
    const double p = std::round(value * q);
    if (p / q != value || std::abs(p) > 1e9) continue;
    const Modular numerator(static_cast<std::uint64_t>(std::abs(p)));
    return (p < 0.0 ? -numerator : numerator) / Modular(static_cast<std::uint64_t>(q));
  }
  return Expression::parse(formatted("{}", value), 0).value().over(SegmentField<Modular>{Surroundings<Modular>{}, 0});
}

std::vector<Modular> exact_defaults(const BlendingData& data) {
  std::vector<Modular> values;
  for (const BlendingParameter& parameter : data.parameters) values.push_back(exact_default(parameter.initial));
  return values;
}

constexpr double visible = 1e-12;

std::string why_missed(const BlendingData& data, const Rows& rows) {
  const auto jets = joint_jets(rows, defaults(data));
  for (std::size_t k = 0; k < rows.increments(); ++k) {
    const int increment = rows.first() + static_cast<int>(k);
    const double at_start = jets.right[k + 1][0], at_end = jets.left[k][0];
    const double wanted_at_start = increment < 0 ? 1.0 : 0.0, wanted_at_end = increment <= 0 ? 1.0 : 0.0;
    if (std::abs(at_start - wanted_at_start) > visible)
      return formatted("{}(0) = {:.6g}, wanted {}: the curve does not leave from its key", function_name(k, 0),
                       at_start, wanted_at_start);
    if (std::abs(at_end - wanted_at_end) > visible)
      return formatted("{}(1) = {:.6g}, wanted {}: the curve does not reach its key", function_name(k, 0), at_end,
                       wanted_at_end);
  }
  return "the values at the keys depend on the parameters";
}

std::string why_jumping(const BlendingData& data, const Rows& rows, std::size_t order, Times times) {
  Surroundings<double> around = defaults(data);
  if (times == Times::uneven) around.lengths[1] = 2.0;
  const auto found = jumps(rows, around, order);
  const auto largest = std::ranges::max_element(found, [](double a, double b) { return std::abs(a) < std::abs(b); });
  const std::string where = times == Times::even ? "" : " where the interval behind a key is twice that before it";
  if (std::abs(*largest) <= visible)
    return formatted("order {} jumps at a key where parameters differ from key to key{}", order, where);
  const auto j = static_cast<std::size_t>(largest - found.begin());
  const std::string before = j < rows.increments() ? function_name(j, order) + "(1)" : "0";
  const std::string behind = j > 0 ? function_name(j - 1, order) + "(0)" : order == 0 ? "1" : "0";
  return formatted("{} and {} differ by {:.6g}{}", before, behind, std::abs(*largest), where);
}

std::string why_unsteady(const BlendingData& data, const Rows& rows, Times times) {
  Surroundings<double> around = defaults(data);
  if (times == Times::uneven) around.lengths = {{-1, 0.5}, {1, 2.0}};
  double largest = 0.0;
  for (const double error : unsteadiness(rows, around)) largest = std::max(largest, std::abs(error));
  return formatted("the sum of the functions is up to {:.6g} of a step away from a constant rate", largest);
}

/// All about one set of rows.
class Examination {
 public:
  Examination(const BlendingData& data, const Rows& rows) : data_(data), rows_(rows) {}

  std::vector<BlendingFinding> findings() const {
    std::vector<BlendingFinding> found{interpolation()};
    if (rows_.is_bezier()) found.push_back(partition());
    found.push_back(continuity(Times::even));
    found.push_back(continuity(Times::uneven));
    found.push_back(shape());
    found.push_back(steadiness(Times::even));
    found.push_back(steadiness(Times::uneven));
    if (!data_.parameters.empty()) found.push_back(rest());
    return found;
  }

 private:
  BlendingFinding interpolation() const {
    const auto residuals = [&](const std::vector<Modular>& values) {
      return misses(rows_, same_everywhere(values, Times::uneven, data_));
    };
    if (all_zero(misses(rows_, generic(data_, Times::uneven)))) return {Promise::interpolates, 1};
    return {Promise::interpolates, 0, why_missed(data_, rows_), condition(data_, residuals)};
  }

  BlendingFinding partition() const {
    if (all_zero(sum_errors(rows_, generic(data_, Times::uneven)))) return {Promise::sums_to_one, 1};
    const auto residuals = [&](const std::vector<Modular>& values) {
      return sum_errors(rows_, same_everywhere(values, Times::uneven, data_));
    };
    double largest = 0.0;
    for (const double error : sum_errors(rows_, defaults(data_)))
      if (std::abs(error) > std::abs(largest)) largest = error;
    return {Promise::sums_to_one, 0,
            formatted("a coefficient of the sum of the functions is {:.6g}, wanted 1", 1.0 + largest),
            condition(data_, residuals)};
  }

  BlendingFinding continuity(Times times) const {
    const auto around = generic(data_, times);
    const int order = order_of_continuity([&](std::size_t k) { return jumps(rows_, around, k); }, rows_.degree());
    BlendingFinding found{times == Times::even ? Promise::continuity_even : Promise::continuity_uneven, order};
    if (order == static_cast<int>(rows_.degree())) return found;
    const std::size_t next = static_cast<std::size_t>(order) + 1;  // 0 behind order -1
    found.why = why_jumping(data_, rows_, next, times);
    found.where = condition(data_, [&](const std::vector<Modular>& values) {
      return jumps(rows_, same_everywhere(values, times, data_), next);
    });
    return found;
  }

  BlendingFinding shape() const {
    const auto around = generic(data_, Times::uneven);
    if (!all_zero(jumps(rows_, around, 0))) return {Promise::shape, -1};
    return {Promise::shape, order_of_shape(rows_, around)};
  }

  BlendingFinding steadiness(Times times) const {
    const Promise promise = times == Times::even ? Promise::steady_even : Promise::steady_uneven;
    const auto residuals = [&](const std::vector<Modular>& values) {
      return unsteadiness(rows_, same_everywhere(values, times, data_));
    };
    if (all_zero(residuals(exact_defaults(data_)))) return {promise, 1};
    return {promise, 0, why_unsteady(data_, rows_, times), condition(data_, residuals)};
  }

  BlendingFinding rest() const {
    auto around = generic(data_, Times::uneven);
    around.at_keys[{0, 1}] = Modular();
    const auto jets = joint_jets(rows_, around);
    const auto rests = [](const auto& jet) { return jet[1] == Modular(); };
    const bool is_rest = std::ranges::all_of(jets.left, rests) && std::ranges::all_of(jets.right, rests);
    return {Promise::rests_at_zero, is_rest ? 1 : 0};
  }

  const BlendingData& data_;
  const Rows& rows_;
};

}  // namespace

std::vector<BlendingFinding> findings_of(const BlendingData& data, const Rows& rows) {
  return Examination(data, rows).findings();
}

}}}  // namespace orispline::blending
