// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/blending/blending_family.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/four_key_curve.hpp>
#include <orispline/families/blending/basis.hpp>
#include <orispline/families/blending/findings.hpp>
#include <orispline/families/blending/rounded.hpp>
#include <orispline/families/blending/rows.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using blending::Rows;
using Promise = BlendingFinding::Promise;

constexpr std::size_t longest_name = 40, longest_title = 200, most_parameters = 8;
constexpr double largest_coefficient = 1e12;

tl::unexpected<Error> refused(std::string message) { return failure(ErrorCode::bad_argument, std::move(message)); }

/// Small letters, digits and `-`, beginning with a letter; of parameters no `-`, so that settings can be told apart.
bool is_name(std::string_view name, std::string_view marks) {
  const auto is_letter = [](char c) { return 'a' <= c && c <= 'z'; };
  return !name.empty() && name.size() <= longest_name && is_letter(name.front()) &&
         std::ranges::all_of(
             name, [&](char c) { return is_letter(c) || ('0' <= c && c <= '9') || marks.find(c) != marks.npos; });
}

Expected<void> check_names(const BlendingData& data) {
  if (!is_name(data.name, "-"))
    return refused(formatted("name: found {}, wanted small letters, digits and '-', a letter first, {} at most",
                             in_quotes(data.name), longest_name));
  if (find_family(data.name))
    return refused(formatted("name: found '{}', which is a method already, wanted another name", data.name));
  if (data.title.size() > longest_title || printable(data.title) != data.title)
    return refused(
        formatted("title: found {}, wanted one line of {} characters at most", in_quotes(data.title), longest_title));
  return {};
}

Expected<void> check_parameters(const BlendingData& data) {
  if (data.parameters.size() > most_parameters)
    return refused(formatted("parameters: found {}, wanted {} at most", data.parameters.size(), most_parameters));
  static constexpr std::array taken{"closed", "period", "ends", "start_rate", "end_rate"};
  for (auto p = data.parameters.begin(); p != data.parameters.end(); ++p) {
    const auto is_same = [&](const BlendingParameter& other) { return other.name == p->name; };
    if (!is_name(p->name, "_") || std::ranges::find(taken, p->name) != taken.end())
      return refused(
          formatted("parameters: found the name {}, wanted small letters, digits and '_', a letter first, and "
                    "none of {}",
                    in_quotes(p->name), joined(taken, ", ")));
    if (std::any_of(data.parameters.begin(), p, is_same))
      return refused(formatted("parameters: found '{}' twice, wanted it once", p->name));
    if (!(-1e6 <= p->lowest && p->lowest < p->highest && p->highest <= 1e6))
      return refused(formatted("parameters: '{}' is from {} to {}, wanted a range within -1e6 to 1e6", p->name,
                               p->lowest, p->highest));
    if (!(p->lowest <= p->initial && p->initial <= p->highest))
      return refused(formatted("parameters: '{}' is {}, wanted {} to {}", p->name, p->initial, p->lowest, p->highest));
    if (p->initial != 0.0 && std::abs(p->initial) < blending::Expression::smallest_number)
      return refused(formatted("parameters: '{}' is {}, wanted 0 or a size of {:g} at least", p->name, p->initial,
                               blending::Expression::smallest_number));
  }
  return {};
}

/// The stated end rule first, then the others of four keys; none where no increment goes beyond an end.
Expected<std::vector<EndRule>> ends_of(const BlendingData& data, const Rows& rows) {
  if (rows.reach() == 0) return std::vector<EndRule>{};
  FamilyInfo known;
  known.name = data.name;
  known.ends = four_key_ends_repeat;
  return end_rule_by_name(known, data.ends)
      .map([](EndRule stated) {
        std::vector<EndRule> ends{stated};
        for (const EndRule rule : four_key_ends_repeat)
          if (rule != stated) ends.push_back(rule);
        return ends;
      })
      .map_error([](Error error) {
        error.message = "ends: " + error.message;
        return error;
      });
}

/// The field of a segment of a curve.
template <class Value>
class CurveField {
 public:
  CurveField(const FamilySettings& settings, const std::vector<PerKey>& parameters, const Knots& knots,
             std::size_t segment)
      : parameters_(parameters),
        times_(knots.times()),
        is_closed_(settings.closure.has_value()),
        segment_(static_cast<std::ptrdiff_t>(segment)) {}

  [[nodiscard]] Value constant(const blending::Literal& literal) const { return literal.in<Value>(); }
  [[nodiscard]] Value quantity(const blending::Quantity& q) const {
    const std::ptrdiff_t place = segment_ + q.offset;
    if (q.kind == blending::Quantity::Kind::length) return Value(length(place));
    return Value(parameters_[static_cast<std::size_t>(q.parameter)][key(place)]);
  }

 private:
  [[nodiscard]] std::ptrdiff_t segments() const { return static_cast<std::ptrdiff_t>(times_.size()) - 1; }
  /// Beyond an end the end's, around a loop those of the other side.
  [[nodiscard]] std::size_t key(std::ptrdiff_t place) const {
    if (is_closed_) return wrapped(place);
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, segments()));
  }
  /// Beyond an end mirrored, around a loop those of the other side.
  [[nodiscard]] double length(std::ptrdiff_t place) const {
    if (!is_closed_ && place < 0) place = std::min(-place - 1, segments() - 1);
    if (!is_closed_ && place >= segments()) place = std::max<std::ptrdiff_t>(2 * segments() - 1 - place, 0);
    const std::size_t i = wrapped(place);
    return times_[i + 1] - times_[i];
  }
  [[nodiscard]] std::size_t wrapped(std::ptrdiff_t place) const {
    return static_cast<std::size_t>(((place % segments()) + segments()) % segments());
  }

  const std::vector<PerKey>& parameters_;
  std::span<const double> times_;
  bool is_closed_;
  std::ptrdiff_t segment_;
};

std::vector<PerKey> values_of_parameters(const BlendingData& data, const FamilySettings& settings) {
  std::vector<PerKey> parameters;
  for (const BlendingParameter& parameter : data.parameters) parameters.push_back(settings.per_key(parameter.name));
  return parameters;
}

Expected<blending::SegmentCoefficients> coefficients_of(const BlendingData& data, const Rows& rows,
                                                        const FamilySettings& settings, const Knots& knots) {
  const std::vector<PerKey> parameters = values_of_parameters(data, settings);
  auto values = std::make_shared<std::vector<double>>();
  values->reserve(knots.segments() * rows.increments() * (rows.degree() + 1));
  for (std::size_t i = 0; i < knots.segments(); ++i)
    for (const auto& row : rows.cumulative(CurveField<double>(settings, parameters, knots, i)))
      for (const double value : row) {
        if (!(std::abs(value) <= largest_coefficient))
          return failure(ErrorCode::bad_data,
                         formatted("{}: a coefficient is {:g} on the segment behind this key, wanted {:g} at most",
                                   data.name, value, largest_coefficient),
                         {.key = i});
        values->push_back(value);
      }
  return blending::SegmentCoefficients{rows.degree(), std::move(values)};
}

/// Increments one by one, also beyond the ends, where each end rule goes on as it began.
template <CurvePoint P>
class IncrementsAround {
 public:
  IncrementsAround(const ControlPolygon<P>& four_key, const FamilySettings& settings)
      : increments_(four_key.increments), settings_(settings) {}

  /// From key i to the next one.
  [[nodiscard]] Displacement<P> operator()(std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(increments_.size()) - 2;
    if (settings_.closure) {
      const std::ptrdiff_t segments = last;
      return at(((i % segments) + segments) % segments);
    }
    if (i < -1) return beyond(settings_.start, -1);
    return i > last ? beyond(settings_.end, last) : at(i);
  }

 private:
  [[nodiscard]] Displacement<P> at(std::ptrdiff_t i) const { return increments_[static_cast<std::size_t>(i + 1)]; }
  [[nodiscard]] Displacement<P> beyond(const End& end, std::ptrdiff_t ghost) const {
    return end.rule == EndRule::repeat ? Displacement<P>(Displacement<P>::Zero()) : at(ghost);
  }

  const std::vector<Displacement<P>>& increments_;
  const FamilySettings& settings_;
};

/// The polygon with increments `first` … `last` around each segment, from that with the increment before, its own and
/// the one behind.
template <CurvePoint P>
ControlPolygon<P> widened(const ControlPolygon<P>& four_key, const Keyframes& keys, const FamilySettings& settings,
                          const Rows& rows, std::size_t segments) {
  const auto points = keys.points<P>();
  const IncrementsAround<P> around(four_key, settings);
  ControlPolygon<P> polygon;
  const auto count = static_cast<std::ptrdiff_t>(segments);
  for (std::ptrdiff_t i = rows.first(); i < count + rows.last(); ++i) polygon.increments.push_back(around(i));
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    P base = rows.first() == 0 ? points[static_cast<std::size_t>(i)] : four_key.bases[static_cast<std::size_t>(i)];
    for (std::ptrdiff_t k = -2; k >= rows.first(); --k) base = displaced(base, Displacement<P>(-around(i + k)));
    polygon.bases.push_back(std::move(base));
  }
  return polygon;
}

/// How the increments before and after a knot make up its rate, of rows as of four keys.
template <std::size_t M>
RateWeights rate_weights(const blending::StoredBasis<M>& basis, KnotSpan span, double t, int first, int knot) {
  const auto b = basis(span, Jet<double, 1>::variable(t));
  const auto weight = [&](int increment) {
    const int row = increment - first;
    return 0 <= row && row < static_cast<int>(M) ? b[static_cast<std::size_t>(row)].c[1] : 0.0;
  };
  return {.before = weight(knot - 1), .after = weight(knot)};
}

template <CurvePoint P, std::size_t M>
Expected<AnyCurveThrough<P>> curve_of_rows(const Keyframes& keys, const FamilySettings& settings, const Rows& rows,
                                           Knots knots, blending::SegmentCoefficients coefficients) {
  blending::StoredBasis<M> basis{std::move(coefficients)};
  const std::size_t last = knots.segments() - 1;
  auto four_key =
      settings.closure
          ? Expected<ControlPolygon<P>>(closed_polygon<P>(keys, *settings.closure))
          : ghosted_polygon<P>(keys, settings, rate_weights(basis, knots.span(0), knots.front(), rows.first(), 0),
                               rate_weights(basis, knots.span(last), knots.back(), rows.first(), 1));
  return std::move(four_key).map([&](const ControlPolygon<P>& polygon) {
    ControlPolygon<P> own = widened<P>(polygon, keys, settings, rows, last + 1);
    return AnyCurveThrough<P>(
        CumulativeCurve<blending::StoredBasis<M>, P>(std::move(knots), std::move(basis), std::move(own)));
  });
}

template <CurvePoint P>
Expected<AnyCurveThrough<P>> curve_of(const BlendingFamily& family, const Rows& rows, const Keyframes& keys,
                                      const FamilySettings& settings) {
  Knots knots = four_key_knots(keys, settings);
  auto coefficients = coefficients_of(family.data(), rows, settings, knots);
  if (!coefficients) return tl::unexpected(std::move(coefficients.error()));
  const auto made = [&]<std::size_t M>() {
    return curve_of_rows<P, M>(keys, settings, rows, std::move(knots), std::move(*coefficients));
  };
  switch (rows.increments()) {
    case 1:
      return made.template operator()<1>();
    case 2:
      return made.template operator()<2>();
    case 3:
      return made.template operator()<3>();
    case 4:
      return made.template operator()<4>();
    default:
      return made.template operator()<5>();
  }
}

/// A field to find out what rows depend on.
struct ProbeField {
  std::size_t parameter;
  blending::Modular at_start, at_end;

  [[nodiscard]] blending::Modular constant(const blending::Literal& literal) const { return literal.exact; }
  [[nodiscard]] blending::Modular quantity(const blending::Quantity& q) const {
    const auto fixed = static_cast<std::uint64_t>(std::int64_t{q.offset} * 31 + std::int64_t{q.parameter} * 7 + 1000);
    if (q.kind == blending::Quantity::Kind::length || q.parameter != static_cast<int>(parameter))
      return blending::Modular(fixed).power(5);
    return q.offset == 0 ? at_start : at_end;
  }
};

/// Whether tuning can vary a parameter: the rows are affine in it at the keys of the segment and depend on it nowhere
/// else, they are three at most, and of degree 7 at most.
bool is_tunable(const Rows& rows, std::size_t parameter) {
  constexpr std::size_t most_increments = 3;
  if (rows.increments() > most_increments || rows.degree() > form_degree) return false;
  if (rows.parameters_reach_out()) return false;
  using blending::Modular;
  const auto at = [&](std::uint64_t start, std::uint64_t end) {
    return rows.cumulative(ProbeField{parameter, Modular(start), Modular(end)});
  };
  // An affine function of both is known from three values.
  const auto origin = at(0, 0), by_start = at(1, 0), by_end = at(0, 1), elsewhere = at(3571, 77003);
  bool depends = false;
  for (std::size_t k = 0; k < origin.size(); ++k)
    for (std::size_t i = 0; i < origin[k].size(); ++i) {
      const Modular start = by_start[k][i] - origin[k][i], end = by_end[k][i] - origin[k][i];
      if (origin[k][i] + Modular(3571) * start + Modular(77003) * end != elsewhere[k][i]) return false;
      depends |= start != Modular() || end != Modular();
    }
  return depends;
}

int order_of(const std::vector<BlendingFinding>& findings, Promise promise) {
  const auto found = std::ranges::find(findings, promise, &BlendingFinding::promise);
  return found == findings.end() ? 0 : found->order;
}

}  // namespace

BlendingFamily::BlendingFamily(BlendingData data, std::unique_ptr<const Rows> rows, std::vector<EndRule> ends)
    : data_(std::move(data)),
      rows_(std::move(rows)),
      findings_(blending::findings_of(data_, *rows_)),
      ends_(std::move(ends)) {
  for (std::size_t p = 0; p < data_.parameters.size(); ++p) {
    const auto& [name, initial, lowest, highest] = data_.parameters[p];
    parameters_.push_back({.name = name,
                           .initial = initial,
                           .lowest = lowest,
                           .highest = highest,
                           .tunable = is_tunable(*rows_, p),
                           .rests_at_zero = blending::rests_at_zero(data_, *rows_, p)});
  }
  const int reach = rows_->reach(), farther = std::max(0, rows_->coefficient_reach() - reach);
  info_ = {.name = data_.name,
           .title = data_.title,
           .source = "blending functions of your own",
           .interpolates = order_of(findings_, Promise::interpolates) > 0,
           .continuity_uniform = order_of(findings_, Promise::continuity_even),
           .continuity_uneven = order_of(findings_, Promise::continuity_uneven),
           .continuity_of_shape = order_of(findings_, Promise::shape),
           .keeps_constant_rate_uniform = order_of(findings_, Promise::steady_even) > 0,
           .keeps_constant_rate_uneven = order_of(findings_, Promise::steady_uneven) > 0,
           .support_keys = 2 * reach + 2,
           .parameters = parameters_,
           .ends = ends_,
           .closes = true,
           .key_use = {.further_times = static_cast<std::size_t>(farther),
                       .parameters_reach_far = rows_->parameters_reach_out()},
           .own = this};
}

BlendingFamily::~BlendingFamily() = default;

Expected<std::shared_ptr<const BlendingFamily>> BlendingFamily::make(BlendingData data) {
  if (auto checked = check_names(data); !checked) return tl::unexpected(std::move(checked.error()));
  if (auto checked = check_parameters(data); !checked) return tl::unexpected(std::move(checked.error()));
  if (data.title.empty()) data.title = "Blending functions of your own";
  auto rows = Rows::parse(data);
  if (!rows) return tl::unexpected(std::move(rows.error()));
  auto ends = ends_of(data, *rows);
  if (!ends) return tl::unexpected(std::move(ends.error()));
  return std::shared_ptr<const BlendingFamily>(
      new BlendingFamily(std::move(data), std::make_unique<const Rows>(std::move(*rows)), std::move(*ends)));
}

Expected<AnyCurve> BlendingFamily::curve(const Keyframes& keys, const FamilySettings& settings) const {
  const auto even = std::ranges::find(findings_, Promise::continuity_even, &BlendingFinding::promise);
  if (even->order < 0 && !even->is_undefined)
    return failure(ErrorCode::bad_argument,
                   formatted("{}: the curve jumps at its keys: {}", data_.name, findings_.front().why));
  return curve_of<Eigen::Quaterniond>(*this, *rows_, keys, settings);
}

Expected<AnyPath> BlendingFamily::path(const Keyframes& keys, const FamilySettings& settings) const {
  return curve_of<Eigen::Vector3d>(*this, *rows_, keys, settings);
}

std::vector<std::size_t> possible_corners(const BlendingFamily& family, const Keyframes& keys,
                                          const FamilySettings& settings) {
  const auto shape = std::ranges::find(family.findings(), Promise::shape, &BlendingFinding::promise);
  if (shape->provided.empty()) return {};
  const Knots knots = four_key_knots(keys, settings);
  const std::vector<PerKey> parameters = values_of_parameters(family.data(), settings);
  // By increment, from the first one of either segment on, the rates by u at its start and its end.
  using blending::Rounded;
  const auto rates = [&](std::size_t segment, bool at_end) {
    std::vector<Rounded> found;
    for (const auto& row : family.rows().cumulative(CurveField<Rounded>(settings, parameters, knots, segment)))
      found.push_back(at_end ? row[row.size() - 1] - row[row.size() - 2] : row[1] - row[0]);
    return found;
  };
  const auto moves_on = [](const std::vector<Rounded>& before, const std::vector<Rounded>& behind) {
    Rounded product;  // a segment's increment k is increment k - 1 of the next one
    for (std::size_t k = 1; k < before.size(); ++k) product = product + before[k] * behind[k - 1];
    return product.is_not_zero() && product.value() > 0.0;
  };
  std::vector<std::size_t> corners;
  const std::size_t segments = knots.segments();
  for (std::size_t i = settings.closure ? 0 : 1; i < segments; ++i)
    if (!moves_on(rates((i + segments - 1) % segments, true), rates(i, false))) corners.push_back(i);
  return corners;
}

std::span<const BlendingFinding> findings_of(const FamilyInfo& family) noexcept {
  const auto* const blending = dynamic_cast<const BlendingFamily*>(family.own);
  return blending ? blending->findings() : std::span<const BlendingFinding>();
}

const BlendingData* blending_of(const Method& method) noexcept {
  const auto* const family = dynamic_cast<const BlendingFamily*>(method.own.get());
  return family ? &family->data() : nullptr;
}

}}  // namespace orispline
