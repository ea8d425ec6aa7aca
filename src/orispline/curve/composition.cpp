// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/composition.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numeric>
#include <utility>
#include <variant>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/stretched_curve.hpp>
#include <orispline/curve/taylor.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Points of a curve that states its motion.
template <class C>
class ByMotion {
 public:
  [[nodiscard]] Eigen::Quaterniond point(double t, std::size_t segment) const noexcept {
    return itself().orientation(t, segment);
  }
  /// By the Taylor polynomial of the motion.
  [[nodiscard]] Quaternion<Jet<double, 3>> point(const Jet<double, 3>& t, std::size_t segment) const noexcept {
    return taylor(itself().motion(t.c[0], segment), t - t.c[0]);
  }

 private:
  [[nodiscard]] const C& itself() const noexcept { return static_cast<const C&>(*this); }
};

/// (base ∏ exp(β φ))⁻¹ = base⁻¹ ∏ exp(-β base φ), the factors from the last to the first.
CumulativeForm inverse_form(const CumulativeForm& form) {
  CumulativeForm inverse{form.degree, form.base.conjugate(), {}, {}};
  for (std::size_t k = 0; k < form.increments.size(); ++k) {
    const std::size_t from = form.increments.size() - 1 - k;
    inverse.increments[k] = -to_world<double>(form.base, form.increments[from]);
    inverse.blending[k] = form.blending[from];
  }
  return inverse;
}

ChartForm inverse_form(const ChartForm& form) {
  ChartForm inverse{form.degree, form.base.conjugate(), {}};
  for (std::size_t i = 0; i <= form_degree; ++i) {
    const auto coefficient = [i](auto& vector, std::size_t k) -> auto& { return vector[k].coefficients[i]; };
    const Eigen::Vector3d turned =
        to_world<double>(form.base, {coefficient(form.rotation_vector, 0), coefficient(form.rotation_vector, 1),
                                     coefficient(form.rotation_vector, 2)});
    for (std::size_t k = 0; k < 3; ++k) coefficient(inverse.rotation_vector, k) = -turned[static_cast<Eigen::Index>(k)];
  }
  return inverse;
}

RationalForm inverse_form(RationalForm form) {
  for (std::size_t k = 0; k < 3; ++k)
    for (double& coefficient : form.components[k].coefficients) coefficient = -coefficient;
  return form;
}

SquadForm inverse_form(const SquadForm& form) {
  return {.outer = form.outer.conjugate(),
          .inner = form.inner.conjugate(),
          .outer_increment = -to_world<double>(form.outer, form.outer_increment),
          .inner_increment = -to_world<double>(form.inner, form.inner_increment)};
}

/// An aggregate: whether it is an AnyCurve itself cannot depend on a constructor that takes one.
struct InverseCurve : ByMotion<InverseCurve> {
  AnyCurve curve;

  [[nodiscard]] const Knots& knots() const noexcept { return curve.knots(); }
  [[nodiscard]] Eigen::Quaterniond orientation(double t, std::size_t segment) const noexcept {
    return curve.orientation_on(segment, t).conjugate();
  }
  [[nodiscard]] Motion motion(double t, std::size_t segment) const noexcept {
    return inverse(curve.motion_on(segment, t));
  }
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept {
    const auto inverted = [](const auto& form) -> SegmentForm {
      if constexpr (std::same_as<decltype(form), const std::monostate&>) return form;
      else return inverse_form(form);
    };
    return std::visit(inverted, curve.form(segment));
  }
};

/// The ends of gaps, and where the motion jumps.
std::vector<double> breaks_of(const AnyCurve& curve) {
  constexpr double least_jump = 1e-9;  // [rad], above all rounding
  std::vector<double> breaks;
  const auto knots = curve.knots().times();
  bool was_gap = knots.size() > 1 && is_gap(curve, 0);
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    const double t = knots[i];
    const bool is_one = is_gap(curve, i);
    if (is_one != was_gap || angular_distance(curve.orientation_on(i - 1, t), curve.orientation_on(i, t)) > least_jump)
      breaks.push_back(t);
    was_gap = is_one;
  }
  return breaks;
}

/// What rounding may move a time by where it goes from one clock to the other [s].
double rounding_of_times(double largest) { return 4.0 * std::numeric_limits<double>::epsilon() * largest; }

/// A curve on another clock.
struct Factor {
  AnyCurve curve;
  double offset;  ///< the time on its own clock at 0 of the other's [s]
  ShiftedClock clock{curve, offset};

  [[nodiscard]] std::size_t segment_at(double t) const noexcept { return curve.knots().segment_at(t + offset); }
  [[nodiscard]] Domain domain() const noexcept { return {curve.domain().start - offset, curve.domain().end - offset}; }
};

class ProductCurve : public ByMotion<ProductCurve> {
 public:
  ProductCurve(Factor a, Factor b, Knots knots) : a_(std::move(a)), b_(std::move(b)), knots_(std::move(knots)) {
    for (std::size_t i = 0; i < std::max<std::size_t>(knots_.segments(), 1); ++i) {
      const double middle = std::midpoint(knots_.times()[i], knots_.times()[std::min(i + 1, knots_.segments())]);
      segments_.emplace_back(a_.segment_at(middle), b_.segment_at(middle));
    }
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  [[nodiscard]] Eigen::Quaterniond orientation(double t, std::size_t segment) const noexcept {
    const auto [of_a, of_b] = segments_[segment];
    return a_.curve.orientation_on(of_a, a_.clock(t)) * b_.curve.orientation_on(of_b, b_.clock(t));
  }
  [[nodiscard]] Motion motion(double t, std::size_t segment) const noexcept {
    const auto [of_a, of_b] = segments_[segment];
    return product(a_.curve.motion_on(of_a, a_.clock(t)), b_.curve.motion_on(of_b, b_.clock(t)));
  }

 private:
  Factor a_, b_;
  Knots knots_;
  std::vector<std::pair<std::size_t, std::size_t>> segments_;  // of a and of b, for each of its own
};

/// The knots of both in a closed interval, with its ends; such as rounding alone tells apart are one.
std::vector<double> common_knots(const Factor& a, const Factor& b, const Domain& domain) {
  std::vector<double> all{domain.start, domain.end};
  double largest = std::max(std::abs(domain.start), std::abs(domain.end));
  for (const Factor* const factor : {&a, &b}) {
    largest += std::abs(factor->offset);
    for (const double own : factor->curve.knots().times())
      if (const double t = own - factor->offset; domain.start < t && t < domain.end) all.push_back(t);
  }
  std::ranges::sort(all);
  const double rounding = rounding_of_times(largest);
  std::vector<double> knots;
  for (const double t : all)
    if (knots.empty() || t - knots.back() > rounding) knots.push_back(t);
  knots.back() = domain.end;
  return knots;
}

}  // namespace

ShiftedClock::ShiftedClock(const AnyCurve& curve, double offset)
    : offset_(offset),
      rounding_(rounding_of_times(std::max(std::abs(curve.domain().start), std::abs(curve.domain().end)) +
                                  std::abs(offset))) {
  if (offset != 0.0) breaks_ = breaks_of(curve);
}

double ShiftedClock::operator()(double t) const noexcept {
  const double own = t + offset_;
  const auto next = std::ranges::lower_bound(breaks_, own - rounding_);
  return next != breaks_.end() && *next <= own + rounding_ ? *next : own;
}

AnyCurve inverse_of(const AnyCurve& curve) { return InverseCurve{{}, curve}; }

Expected<AnyCurve> product_of(const AnyCurve& a, const AnyCurve& b, ClockOffsets offsets) {
  const Factor left{a, offsets.a}, right{b, offsets.b};
  const Domain of_a = left.domain(), of_b = right.domain();
  const Domain common{std::max(of_a.start, of_b.start), std::min(of_a.end, of_b.end)};
  if (!(common.start <= common.end))
    return failure(
        ErrorCode::bad_argument,
        formatted("found a curve from {:.9g} to {:.9g} s and one from {:.9g} to {:.9g} s, wanted two curves with a "
                  "time in common",
                  of_a.start, of_a.end, of_b.start, of_b.end));
  return AnyCurve(ProductCurve(left, right, Knots(common_knots(left, right, common))));
}

}}  // namespace orispline
