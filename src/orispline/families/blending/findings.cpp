// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/blending/findings.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/families/blending/joint.hpp>
#include <orispline/families/blending/motion_condition.hpp>
#include <orispline/families/blending/rounded.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

namespace {

using Promise = BlendingFinding::Promise;

bool is_not_zero(const Modular& value) { return value != Modular(); }
bool is_not_zero(const Rounded& value) { return value.is_not_zero(); }

template <class Value>
bool all_zero(const std::vector<Value>& values) {
  return std::ranges::none_of(values, [](const Value& value) { return is_not_zero(value); });
}

/// Whether no coefficient divides by 0.
bool are_defined(const Rows& rows, const Surroundings<Modular>& around) {
  return std::ranges::all_of(rows.stated(SegmentField<Modular>{around, 0}),
                             [](const auto& row) { return std::ranges::all_of(row, &Modular::is_defined); });
}

/// Places in doubles: the defaults, and draws from the ranges of the parameters, every other one nearer to 0.
std::vector<Surroundings<Rounded>> places(const BlendingData& data, Times times, bool defaults_only) {
  constexpr int draws = 8;
  Sequence random;
  std::vector<Surroundings<Rounded>> found;
  for (int draw = 0; draw < draws; ++draw) {
    const double widest = draw % 2 == 0 ? 1.0 : 1e6;
    const auto parameter = [&](std::size_t p, int) {
      const auto& [name, initial, lowest, highest] = data.parameters[p];
      if (defaults_only || draw < 2) return Rounded(initial);
      return Rounded(
          std::clamp(std::lerp(std::max(lowest, -widest), std::min(highest, widest), random.share()), lowest, highest));
    };
    found.push_back(surroundings<Rounded>(data, times, parameter, [&] { return Rounded(0.5 + random.share()); }));
  }
  return found;
}

/// The largest k for which the derivatives by u on the right are those on the left after a change of the parameter:
/// R₁ = s L₁, R₂ = s² L₂ + c L₁, R₃ = s³ L₃ + 3 s c L₂ + d L₁ with the same s, c, d for all increments, and s > 0 where
/// it has a sign. Where no increment moves a place in doubles tells nothing.
template <class Value>
int order_of_shape(const Rows& rows, const Surroundings<Value>& around, bool ratio_is_of_lengths) {
  const JointJets<Value> jets = joint_jets(rows, around);
  const auto &l = jets.left, &r = jets.right;
  const int highest = static_cast<int>(std::min<std::size_t>(3, rows.degree()));
  const auto moves = [](const auto& jet) { return is_not_zero(jet[1]); };
  const auto moving = std::ranges::find_if(l, moves);
  if (moving == l.end() || std::ranges::none_of(r, moves)) return std::same_as<Value, Rounded> ? highest : 0;
  const auto m = static_cast<std::size_t>(moving - l.begin());
  const Value zero = SegmentField<Value>{around, 0}.constant(whole(0));
  Value s = zero, c = zero, d = zero;
  const auto times3 = [](const Value& value) { return value + value + value; };
  const auto carried = [&](std::size_t j, int order) {
    return order == 1   ? s * l[j][1]
           : order == 2 ? s * s * l[j][2] + c * l[j][1]
                        : s * s * s * l[j][3] + times3(s * c * l[j][2]) + d * l[j][1];
  };
  for (int order = 1; order <= highest; ++order) {
    const auto k = static_cast<std::size_t>(order);
    Value& free = order == 1 ? s : order == 2 ? c : d;
    free = (r[m][k] - carried(m, order)) / l[m][1];
    if constexpr (std::same_as<Value, Rounded>)
      if (order == 1 && ratio_is_of_lengths && s.is_not_zero() && s.value() < 0.0) return 0;
    for (std::size_t j = 0; j < l.size(); ++j)
      if (is_not_zero(r[j][k] - carried(j, order))) return order - 1;
  }
  return highest;
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
  return data.parameters.empty() ? "the values at the keys depend on the lengths of the intervals"
                                 : "the values at the keys depend on the parameters or the lengths of the intervals";
}

constexpr std::string_view divides_by_zero = "a coefficient divides by 0 where all lengths are the same";

std::string why_jumping(const BlendingData& data, const Rows& rows, std::size_t order, Times times) {
  using Unevenness = std::pair<int, std::string_view>;  // a longer interval, in words
  constexpr Unevenness even{0, ""}, behind{1, " where the interval behind a key is twice that before it"},
      farther{-1, " where the last but one interval before a key is twice the others"};
  std::vector<Unevenness> tried{even};
  if (times == Times::uneven) tried = {behind, farther};
  for (const auto& [place, where] : tried) {
    Surroundings<double> around = defaults(data);
    if (times == Times::uneven) around.lengths[place] = 2.0;
    const auto found = jumps(rows, around, order);
    const auto largest = std::ranges::max_element(found, [](double a, double b) { return std::abs(a) < std::abs(b); });
    if (!(std::abs(*largest) > visible)) continue;
    const auto j = static_cast<std::size_t>(largest - found.begin());
    const std::string before = j < rows.increments() ? function_name(j, order) + "(1)" : "0";
    const std::string after = j > 0 ? function_name(j - 1, order) + "(0)" : order == 0 ? "1" : "0";
    return formatted("{} and {} differ by {:.6g}{}", before, after, std::abs(*largest), where);
  }
  if (data.parameters.empty()) return formatted("order {} jumps at a key between uneven intervals", order);
  return formatted("order {} jumps at a key where parameters differ from key to key{}", order, tried.front().second);
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
  Examination(const BlendingData& data, const Rows& rows)
      : data_(data),
        rows_(rows),
        even_(places(data, Times::even, false)),
        uneven_(places(data, Times::uneven, false)) {}

  std::vector<BlendingFinding> findings() const {
    std::vector<BlendingFinding> found{interpolation()};
    if (rows_.is_bezier()) found.push_back(partition());
    found.push_back(continuity(Times::even));
    found.push_back(continuity(Times::uneven));
    found.push_back(shape());
    found.push_back(steadiness(Times::even));
    found.push_back(steadiness(Times::uneven));
    if (!data_.parameters.empty()) found.push_back({Promise::rests_at_zero, rests_at_zero(data_, rows_, 0) ? 1 : 0});
    return found;
  }

 private:
  /// Whether residuals vanish for all parameters and lengths: in fractions, and in doubles, where powers so high that
  /// fractions do not see them differ.
  template <class Residuals>
  bool vanish(const Residuals& residuals, Times times) const {
    return all_zero(residuals(generic(data_, times))) &&
           std::ranges::all_of(times == Times::even ? even_ : uneven_,
                               [&](const auto& around) { return all_zero(residuals(around)); });
  }

  /// Lengths for which there is no curve, or nothing.
  std::string where_defined() const {
    std::vector<std::string> parts;
    for (const std::string& divisor : rows_.doubtful_divisors()) parts.push_back(divisor + " ≠ 0");
    return joined(parts, " and ");
  }

  BlendingFinding interpolation() const {
    const auto misses_at = [&](const auto& around) { return misses(rows_, around); };
    if (vanish(misses_at, Times::uneven)) return {Promise::interpolates, 1};
    return {Promise::interpolates, 0, why_missed(data_, rows_),
            condition(data_, [&](const std::vector<Modular>& values) {
              return misses_at(same_everywhere(values, Times::uneven, data_));
            })};
  }

  BlendingFinding partition() const {
    const auto errors_at = [&](const auto& around) { return sum_errors(rows_, around); };
    if (vanish(errors_at, Times::uneven)) return {Promise::sums_to_one, 1};
    double largest = 0.0;
    for (const double error : errors_at(defaults(data_)))
      if (std::abs(error) > std::abs(largest)) largest = error;
    return {Promise::sums_to_one, 0,
            formatted("a coefficient of the sum of the functions is {:.6g}, wanted 1", 1.0 + largest),
            condition(data_, [&](const std::vector<Modular>& values) {
              return errors_at(same_everywhere(values, Times::uneven, data_));
            })};
  }

  BlendingFinding continuity(Times times) const {
    const Promise promise = times == Times::even ? Promise::continuity_even : Promise::continuity_uneven;
    if (!are_defined(rows_, generic(data_, times)))
      return {.promise = promise, .order = -1, .why = std::string(divides_by_zero), .is_undefined = true};
    const auto jumps_at = [&](std::size_t order) {
      return [this, order](const auto& around) { return jumps(rows_, around, order); };
    };
    std::size_t next = 0;
    while (next <= rows_.degree() && vanish(jumps_at(next), times)) ++next;
    BlendingFinding found{promise, static_cast<int>(next) - 1};
    if (times == Times::uneven) found.provided = where_defined();
    if (next > rows_.degree()) return found;
    found.why = why_jumping(data_, rows_, next, times);
    found.where = condition(data_, [&](const std::vector<Modular>& values) {
      return jumps_at(next)(same_everywhere(values, times, data_));
    });
    return found;
  }

  BlendingFinding shape() const {
    if (!vanish([&](const auto& around) { return jumps(rows_, around, 0); }, Times::uneven))
      return {Promise::shape, -1};
    const MotionCondition moves = motion_condition(data_, rows_);
    int order = order_of_shape(rows_, generic(data_, Times::uneven), moves.is_of_both_sides);
    for (const auto& around : uneven_) order = std::min(order, order_of_shape(rows_, around, moves.is_of_both_sides));
    BlendingFinding found{Promise::shape, order};
    if (order > 0) found.provided = moves.text;
    return found;
  }

  BlendingFinding steadiness(Times times) const {
    const Promise promise = times == Times::even ? Promise::steady_even : Promise::steady_uneven;
    const auto residuals = [&](const std::vector<Modular>& values) {
      return unsteadiness(rows_, same_everywhere(values, times, data_));
    };
    const auto exact = residuals(exact_defaults(data_));
    const bool is_steady = all_zero(exact) && std::ranges::all_of(places(data_, times, true), [&](const auto& around) {
                             return all_zero(unsteadiness(rows_, around));
                           });
    const std::string provided = times == Times::uneven ? where_defined() : "";
    if (is_steady) return {.promise = promise, .order = 1, .provided = provided};
    if (!are_defined(rows_, generic(data_, times))) return {promise, 0, std::string(divides_by_zero)};
    return {promise, 0, why_unsteady(data_, rows_, times), condition(data_, residuals)};
  }

  const BlendingData& data_;
  const Rows& rows_;
  std::vector<Surroundings<Rounded>> even_, uneven_;
};

}  // namespace

bool rests_at_zero(const BlendingData& data, const Rows& rows, std::size_t parameter) {
  auto around = generic(data, Times::uneven);
  around.at_keys[{static_cast<int>(parameter), 1}] = Modular();
  const auto jets = joint_jets(rows, around);
  const auto rests = [](const auto& jet) { return jet[1] == Modular(); };
  return std::ranges::all_of(jets.left, rests) && std::ranges::all_of(jets.right, rests);
}

std::vector<BlendingFinding> findings_of(const BlendingData& data, const Rows& rows) {
  return Examination(data, rows).findings();
}

}}}  // namespace orispline::blending
