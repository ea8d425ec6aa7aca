// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/segment_hull.hpp>

#include <algorithm>
#include <cmath>
#include <span>

#include <orispline/math/eigensystem.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Orders = std::array<double, 6>;  // of order 0 to 5

using Three = HullVector;

/// Σ weight polynomial, the three of one degree.
HullPolynomial sum_of(const Three& p, const std::array<double, 3>& weights) {
  HullPolynomial sum{.form = {}, .degree = p[0].degree};
  for (std::size_t k = 0; k < p.size(); ++k)
    for (std::size_t i = 0; i <= sum.degree; ++i) sum.form.coefficients[i] += weights[k] * p[k].form.coefficients[i];
  return sum;
}

using Parts = std::array<HullDerivatives, 4>;

Three restricted(const Parts& parts, std::size_t order, double start, double end) {
  return {restricted(parts[0][order], start, end), restricted(parts[1][order], start, end),
          restricted(parts[2][order], start, end)};
}

/// Of a product of exponentials whose exponents, halved, have derivatives below these: |q^(n)| ≤ Q_n, complete Bell
/// polynomials of them, and by the rule of Leibniz the derivatives of ω = 2 q̄ q'.
HullBounds bounds_of(double rate, double acceleration, const Orders& a) {
  const double a1 = a[1], square = a1 * a1;
  const double q1 = a1, q2 = a[2] + square, q3 = a[3] + 3.0 * a1 * a[2] + square * a1;
  const double q4 = a[4] + 4.0 * a1 * a[3] + 3.0 * a[2] * a[2] + 6.0 * square * a[2] + square * square;
  const double q5 = a[5] + 5.0 * a1 * a[4] + 10.0 * a[2] * a[3] + 10.0 * square * a[3] + 15.0 * a1 * a[2] * a[2] +
                    10.0 * square * a1 * a[2] + square * square * a1;
  return {.rate = rate,
          .acceleration = acceleration,
          .jerk = 2.0 * (q3 + 3.0 * q1 * q2),
          .snap = 2.0 * (q4 + 4.0 * q1 * q3 + 3.0 * q2 * q2),
          .crackle = 2.0 * (q5 + 5.0 * q1 * q4 + 10.0 * q2 * q3)};
}

/// √(a² + b²). Not std::hypot, whose version of glibc 2.35 would keep programs from older systems.
double hypotenuse(double a, double b) { return norm_of(Eigen::Vector3d(a, b, 0.0)); }

/// A bound of the n-th derivative of a product, by bounds of the derivatives of its factors.
double product(const Orders& a, const Orders& b, std::size_t n) {
  double sum = 0.0, ways = 1.0;  // in which n derivatives fall on the two
  for (std::size_t k = 0; k <= n; ++k) {
    sum += ways * a[k] * b[n - k];
    ways *= static_cast<double>(n - k) / static_cast<double>(k + 1);
  }
  return sum;
}

/// Bounds of x' + y z and its derivatives, one order fewer than those of x, y and z.
Orders derivative_and_product(const Orders& x, const Orders& y, const Orders& z) {
  Orders sum{};
  for (std::size_t n = 0; n + 1 < sum.size(); ++n) sum[n] = x[n + 1] + product(y, z, n);
  return sum;
}

Orders sum_of(const Orders& a, const Orders& b) {
  Orders sum{};
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] = a[n] + b[n];
  return sum;
}

/// The derivatives of what these are bounds of.
Orders derivatives(Orders orders) {
  std::shift_left(orders.begin(), orders.end(), 1);
  orders.back() = 0.0;
  return orders;
}

/// Of a vector of this length in a plane that turns at this rate.
Orders turning(Orders length, const Orders& rate) {
  Orders turned{};
  for (std::size_t n = 0; n < turned.size(); ++n) {
    turned[n] = length[0];
    length = derivative_and_product(length, rate, length);
  }
  return turned;
}

/// Rates of the three factors, and what is nowhere above their derivatives.
struct FactorRates {
  Orders all, before_last, after_first;  ///< along the axis of the second
  Orders second, first_across;           ///< across the axis the others have parts of their own
  Orders last_along, last_across;
};

/// What ω and its derivatives are nowhere above, of a product of three turns. Before the last turn, which leaves its
/// own rate v as it is, ω is u + v, and its n-th derivative Dⁿu + v⁽ⁿ⁾ with D u = u' - v × u. What these products add
/// along the axis of the second turn is `along`.
Orders derivatives_of_rate(const FactorRates& r) {
  Orders sizes{}, along{}, across = turning(r.first_across, r.second), before = r.before_last;
  for (std::size_t n = 0; n < sizes.size(); ++n) {
    sizes[n] = hypotenuse(r.all[n] + along[0], across[0] + r.last_across[n]);
    const Orders next = derivative_and_product(along, r.last_across, across);
    across = sum_of(derivative_and_product(across, r.last_along, across),
                    derivative_and_product({}, r.last_across, sum_of(before, along)));
    along = next;
    before = derivatives(before);
  }
  return sizes;
}

/// What ω = θ' n + sin θ n' + (1 - cos θ) n' × n and its derivatives are nowhere above for a rotation vector θ n that
/// is nowhere shorter than this; of its derivatives the lengths, and how far they reach across n. With θ' = n · p' the
/// derivatives of n are those of p / θ.
Orders derivatives_of_winding(const Orders& lengths, const Orders& across, double shortest) {
  Orders axis{}, angle{};
  for (std::size_t n = 1; n < axis.size(); ++n) {
    const double tilted = product(axis, derivatives(lengths), n - 1);
    angle[n] = lengths[n] + tilted;
    axis[n] = (across[n] + tilted + product(axis, angle, n)) / shortest;
  }
  const Orders rate = derivatives(angle), bend = derivatives(axis);
  axis[0] = 1.0;
  Orders crossed{}, about{};  // n' × n, and it with n' in the plane that turns by θ
  for (std::size_t n = 0; n + 1 < crossed.size(); ++n) {
    crossed[n] = product(axis, bend, n);
    about[n] = bend[n] + (n == 0 ? 0.0 : crossed[n]);
  }
  Orders sizes = turning(about, rate);
  for (std::size_t n = 0; n + 1 < sizes.size(); ++n) sizes[n] += product(rate, axis, n) + crossed[n];
  return sizes;
}

/// The lower of two bounds of the jerk and its derivatives; `rate`: of ω and its derivatives.
HullBounds lesser(HullBounds bounds, const Orders& rate) {
  bounds.jerk = std::min(bounds.jerk, rate[2]);
  bounds.snap = std::min(bounds.snap, rate[3]);
  bounds.crackle = std::min(bounds.crackle, rate[4]);
  return bounds;
}

/// The length across a unit vector that no vector of these components exceeds.
double longest_across(const HullVector& components, const Eigen::Vector3d& axis) {
  double length = 0.0;
  for (std::size_t i = 0; i <= components[0].degree; ++i)
    length = std::max(length, coefficient(components, i).cross(axis).norm());
  return length;
}

Eigen::Vector4d control(const std::array<HullPolynomial, 4>& s, std::size_t i) {
  return {s[0].form.coefficients[i], s[1].form.coefficients[i], s[2].form.coefficients[i], s[3].form.coefficients[i]};
}

std::array<HullPolynomial, 4> restricted_in_space(const Parts& parts, std::size_t order, double start, double end) {
  return {restricted(parts[0][order], start, end), restricted(parts[1][order], start, end),
          restricted(parts[2][order], start, end), restricted(parts[3][order], start, end)};
}

/// The length that no point of a curve of R⁴ exceeds.
double longest_in_space(const std::array<HullPolynomial, 4>& s) {
  double length = 0.0;
  for (std::size_t i = 0; i <= s[0].degree; ++i) length = std::max(length, control(s, i).norm());
  return length;
}

/// The length that no point of it falls below, by the direction in which all control points lie, on parts where they do
/// not; 0 where none is found.
double shortest_in_space(const Parts& parts, double start, double end, int cuts = 8) {
  const auto s = restricted_in_space(parts, 0, start, end);
  Eigen::Vector4d direction = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i <= s[0].degree; ++i) direction += control(s, i);
  direction.stableNormalize();
  double length = control(s, 0).dot(direction);
  for (std::size_t i = 1; i <= s[0].degree; ++i) length = std::min(length, control(s, i).dot(direction));
  if (length > 0.0 || cuts == 0) return std::max(length, 0.0);
  const double middle = 0.5 * (start + end);
  return std::min(shortest_in_space(parts, start, middle, cuts - 1), shortest_in_space(parts, middle, end, cuts - 1));
}

constexpr double rounded_up = 1.0 + 1e-12, rounded_down = 1.0 - 1e-12;
constexpr double rounding_of_moments = 1e-12;  // of the largest
constexpr double rounding_share = 1e-14;       // of evaluation, of the size of what is added up

/// Of s/|s| with derivatives of s of these lengths, which is nowhere shorter than this.
HullBounds bounds_of_rational(const Orders& d, double shortest) {
  // With n = |s|² and w = 2 vec(s̄ s'), n ω = w and its derivatives: n α = w' - n' ω, n j = w'' - 2 n' α - n'' ω and on.
  const double n = shortest * shortest;
  const double n1 = 2.0 * d[0] * d[1], n2 = 2.0 * (d[1] * d[1] + d[0] * d[2]);
  const double n3 = 2.0 * (3.0 * d[1] * d[2] + d[0] * d[3]), n4 = 2.0 * (3.0 * d[2] * d[2] + 4.0 * d[1] * d[3]);
  const double rate = 2.0 * d[1] / shortest;
  const double acceleration = (2.0 * d[0] * d[2] + n1 * rate) / n;
  const double jerk = (2.0 * (d[0] * d[3] + d[1] * d[2]) + 2.0 * n1 * acceleration + n2 * rate) / n;
  const double snap = (4.0 * d[1] * d[3] + 3.0 * n1 * jerk + 3.0 * n2 * acceleration + n3 * rate) / n;
  const double crackle =
      (4.0 * d[2] * d[3] + 4.0 * n1 * snap + 6.0 * n2 * jerk + 4.0 * n3 * acceleration + n4 * rate) / n;
  return {rate, acceleration, jerk, snap, crackle};
}

/// By so much evaluated rates may be off: `size` of the coefficients, `products` of exponents in the jerk.
HullBounds rounding_of(double size, std::size_t degree, double duration, const HullBounds& whole, double products) {
  const double per_time = 2.0 * static_cast<double>(degree) / duration;
  return {rounding_share * (size * per_time + whole.rate),
          rounding_share * (size * per_time * per_time + whole.acceleration),
          rounding_share * (size * per_time * per_time * per_time + whole.jerk + products), 0.0, 0.0};
}

/// Adds what the derivatives of a vector of these components, `scale` times, are nowhere longer than.
template <std::size_t N>
void add_lengths(Orders& lengths, std::span<const BernsteinForm, N> components, double scale, std::size_t degree,
                 double duration) {
  constexpr std::size_t most = form_degree + 1;
  std::array<std::array<double, most>, 4> c{};
  for (std::size_t axis = 0; axis < components.size(); ++axis) c[axis] = components[axis].coefficients;
  double factor = scale;
  for (std::size_t order = 0; order < lengths.size() && order <= degree; ++order) {
    const std::size_t last = degree - order;
    double square = 0.0;
    for (std::size_t i = 0; i <= last; ++i)
      square = std::max(square, c[0][i] * c[0][i] + c[1][i] * c[1][i] + c[2][i] * c[2][i] + c[3][i] * c[3][i]);
    lengths[order] += factor * std::sqrt(square);
    for (auto& axis : c)
      for (std::size_t i = 0; i < last; ++i) axis[i] = axis[i + 1] - axis[i];
    factor *= static_cast<double>(last) / duration;
  }
}

CoarseBounds coarse_bounds_of(const RationalForm& form, double duration) {
  constexpr std::size_t degree = RationalForm::degree;
  Orders lengths{};
  add_lengths(lengths, std::span(form.components), 1.0, degree, duration);
  std::array<Eigen::Vector4d, degree + 1> points;
  for (std::size_t i = 0; i <= degree; ++i)
    for (std::size_t k = 0; k < 4; ++k) points[i][static_cast<Eigen::Index>(k)] = form.components[k].coefficients[i];
  const Eigen::Vector4d direction = (points[0] + points[1] + points[2] + points[3]).stableNormalized();
  double shortest = points[0].dot(direction);
  for (const Eigen::Vector4d& point : points) shortest = std::min(shortest, point.dot(direction));
  const HullBounds bounds = bounds_of_rational(lengths, rounded_down * std::max(shortest, 0.0));
  Orders halves = lengths;
  for (double& half : halves) half *= 1.5;  // of three components
  return {bounds, rounding_of(4.0 * lengths[0], degree, duration, bounds, bounds_of(0.0, 0.0, halves).jerk)};
}

}  // namespace

HullDerivatives derivatives_of(const BernsteinForm& form, std::size_t degree, double duration) {
  HullDerivatives all{HullPolynomial{form, degree}};
  for (std::size_t order = 1; order < all.size(); ++order) {
    const HullPolynomial& before = all[order - 1];
    HullPolynomial& next = all[order];
    next.degree = before.degree > 0 ? before.degree - 1 : 0;
    const double factor = static_cast<double>(before.degree) / duration;
    for (std::size_t i = 0; i < before.degree; ++i)
      next.form.coefficients[i] = factor * (before.form.coefficients[i + 1] - before.form.coefficients[i]);
  }
  return all;
}

HullPolynomial restricted(HullPolynomial p, double start, double end) {
  if (start == 0.0 && end == 1.0) return p;
  auto& c = p.form.coefficients;
  for (std::size_t r = 1; r <= p.degree; ++r)
    for (std::size_t i = p.degree; i >= r; --i) c[i] = (1.0 - end) * c[i - 1] + end * c[i];
  const double place = end > 0.0 ? start / end : 0.0;
  for (std::size_t r = 1; r <= p.degree; ++r)
    for (std::size_t i = 0; i + r <= p.degree; ++i) c[i] = (1.0 - place) * c[i] + place * c[i + 1];
  return p;
}

double largest(const HullPolynomial& p) {
  double value = 0.0;
  for (std::size_t i = 0; i <= p.degree; ++i) value = std::max(value, std::abs(p.form.coefficients[i]));
  return value;
}

Eigen::Vector3d coefficient(const HullVector& components, std::size_t i) {
  return {components[0].form.coefficients[i], components[1].form.coefficients[i], components[2].form.coefficients[i]};
}

double longest(const HullVector& components) {
  double length = 0.0;
  for (std::size_t i = 0; i <= components[0].degree; ++i) length = std::max(length, coefficient(components, i).norm());
  return length;
}

MomentBounds::MomentBounds(const Eigen::Matrix3d& inertia) : weight_(inertia.norm()) {
  const Eigen::Vector3d moments = eigensystem<3>(inertia).values;
  moment_ = (1.0 + rounding_of_moments) * moments[2];
  spread_ = 0.5 * (moments[2] - moments[0]) + rounding_of_moments * moments[2];
}

std::optional<SegmentHull> SegmentHull::of(const SegmentForm& form, double duration) {
  SegmentHull hull;
  hull.duration_ = duration;
  if (const auto* chart = std::get_if<ChartForm>(&form)) {
    hull.kind_ = Kind::chart;
    for (std::size_t axis = 0; axis < 3; ++axis)
      hull.parts_[axis] = derivatives_of(chart->rotation_vector[axis], chart->degree, duration);
    return hull;
  }
  if (const auto* rational = std::get_if<RationalForm>(&form)) {
    hull.kind_ = Kind::rational;
    for (std::size_t k = 0; k < hull.parts_.size(); ++k)
      hull.parts_[k] = derivatives_of(rational->components[k], RationalForm::degree, duration);
    return hull;
  }
  const auto* product = std::get_if<CumulativeForm>(&form);
  if (!product) return std::nullopt;
  const auto& phi = product->increments;
  const Eigen::Vector3d axis = (phi[1].isZero(0.0) ? phi[0] : phi[1]).stableNormalized();
  for (std::size_t k = 0; k < phi.size(); ++k) {
    hull.parts_[k] = derivatives_of(product->blending[k], product->degree, duration);
    hull.lengths_[k] = phi[k].stableNorm();
    hull.along_[k] = phi[k].dot(axis);
    hull.across_[k] = (phi[k] - hull.along_[k] * axis).stableNorm();
  }
  return hull;
}

HullBounds SegmentHull::on(double start, double end) const {
  const HullBounds b = kind_ == Kind::product ? product_on(start, end)
                       : kind_ == Kind::chart ? chart_on(start, end)
                                              : rational_on(start, end);
  return {b.rate * rounded_up, b.acceleration * rounded_up, b.jerk * rounded_up, b.snap * rounded_up,
          b.crackle * rounded_up};
}

HullBounds SegmentHull::rounding(const HullBounds& whole) const {
  double size = 0.0;  // of coefficients, which are not differences yet
  Orders halves{};    // of exponents: of their products, what cancels is rounded as well
  for (std::size_t k = 0; k < lengths_.size(); ++k) {
    const double length = kind_ == Kind::product ? lengths_[k] : 1.0;
    size += length * largest(parts_[k][0]);
    for (std::size_t order = 1; order < halves.size(); ++order)
      halves[order] += 0.5 * length * largest(parts_[k][order]);
  }
  if (kind_ == Kind::rational) size += largest(parts_[3][0]);
  return rounding_of(size, parts_[0][0].degree, duration_, whole, bounds_of(0.0, 0.0, halves).jerk);
}

std::optional<CoarseBounds> coarse_bounds(const SegmentForm& form, double duration) {
  Orders lengths{};  // of the derivatives of the exponents, added up
  std::size_t degree = 0, turns = 3;
  if (const auto* chart = std::get_if<ChartForm>(&form)) {
    degree = chart->degree;
    add_lengths(lengths, std::span(chart->rotation_vector), 1.0, degree, duration);
  } else if (const auto* product = std::get_if<CumulativeForm>(&form)) {
    degree = product->degree;
    turns = static_cast<std::size_t>(
        std::ranges::count_if(product->increments, [](const auto& x) { return !x.isZero(0.0); }));
    for (std::size_t k = 0; k < product->increments.size(); ++k)
      add_lengths(lengths, std::span(product->blending).subspan(k, 1), product->increments[k].stableNorm(), degree,
                  duration);
  } else if (const auto* rational = std::get_if<RationalForm>(&form)) {
    return coarse_bounds_of(*rational, duration);
  } else {
    return std::nullopt;
  }
  Orders halves = lengths;
  for (double& half : halves) half *= 0.5;
  // Of exponents of norms below these α is at most the sum of their second derivatives and of half the square of ω.
  const double rate = lengths[1], acceleration = lengths[2] + 0.5 * rate * rate;
  HullBounds bounds = bounds_of(rate * rounded_up, acceleration * rounded_up, halves);
  if (turns < 2) bounds = {lengths[1], lengths[2], lengths[3], lengths[4], lengths[5]};  // about an axis that stands
  return CoarseBounds{bounds, rounding_of(2.0 * lengths[0], degree, duration, bounds, bounds.jerk)};
}

HullBounds SegmentHull::product_on(double start, double end) const {
  // |ω| is that of R ω₁ + β₃' φ₃, ω₁ = β₁' φ₁ + β₂' φ₂, R a turn about φ₂; the bounds are those of all such turns.
  Orders halves{};
  FactorRates rates{};
  for (std::size_t order = 1; order < halves.size(); ++order) {
    const std::size_t n = order - 1;  // of the derivative of a rate
    const Three p = restricted(parts_, order, start, end);
    const std::array<double, 3> b{largest(p[0]), largest(p[1]), largest(p[2])};
    halves[order] = 0.5 * (lengths_[0] * b[0] + lengths_[1] * b[1] + lengths_[2] * b[2]);
    rates.all[n] = largest(sum_of(p, along_));
    rates.before_last[n] = largest(sum_of(p, {along_[0], along_[1], 0.0}));
    rates.after_first[n] = largest(sum_of(p, {0.0, along_[1], along_[2]}));
    rates.second[n] = std::abs(along_[1]) * b[1];
    rates.first_across[n] = across_[0] * b[0];
    rates.last_along[n] = std::abs(along_[2]) * b[2];
    rates.last_across[n] = across_[2] * b[2];
  }
  const double rate = hypotenuse(rates.all[0], rates.first_across[0] + rates.last_across[0]);
  const double acceleration =
      hypotenuse(rates.all[1] + rates.first_across[0] * rates.last_across[0],
                 hypotenuse(rates.first_across[1], rates.first_across[0] * rates.after_first[0]) +
                     hypotenuse(rates.last_across[1], rates.last_across[0] * rates.before_last[0]));
  return lesser(bounds_of(rate, acceleration, halves), derivatives_of_rate(rates));
}

HullBounds SegmentHull::rational_on(double start, double end) const {
  Orders d{};
  for (std::size_t order = 0; order <= RationalForm::degree; ++order)
    d[order] = longest_in_space(restricted_in_space(parts_, order, start, end));
  return bounds_of_rational(d, shortest_in_space(parts_, start, end));
}

HullBounds SegmentHull::chart_on(double start, double end) const {
  const double middle = 0.5 * (start + end), radius = 0.5 * (end - start) * duration_;
  const Eigen::Vector3d p = coefficient(restricted(parts_, 0, middle, middle), 0), axis = p.stableNormalized();
  const Eigen::Vector3d velocity = coefficient(restricted(parts_, 1, middle, middle), 0);
  Orders lengths{}, halves{}, across{};
  for (std::size_t order = 0; order < lengths.size(); ++order) {
    const HullVector part = restricted(parts_, order, start, end);
    lengths[order] = longest(part);
    halves[order] = 0.5 * lengths[order];
    across[order] = longest_across(part, axis);
  }
  // α = J p'' + N(p, p'), |J| ≤ 1 and |N| ≤ |p'| min(|p'|/2, |p'⊥| 5.2/|p|), p'⊥ what p' has across p.
  const double speed = lengths[1], change = lengths[2], shortest = p.norm() - radius * speed;
  if (!(shortest > 0.0)) return bounds_of(speed, change + 0.5 * speed * speed, halves);
  const double area = p.cross(velocity).norm() + radius * lengths[0] * change;
  const double turns = std::min(0.5 * speed, area * std::min(1.0, 5.2 / shortest) / shortest);
  for (std::size_t order = 1; order < across.size(); ++order) across[order] += across[0] / shortest * lengths[order];
  return lesser(bounds_of(speed, change + speed * turns, halves), derivatives_of_winding(lengths, across, shortest));
}

double shortest_step_near(const Knots& knots, std::size_t segment) {
  constexpr std::size_t segments_near = 3;
  double shortest = knots.span(segment).step();
  const std::size_t end = std::min(segment + segments_near + 1, knots.segments());
  for (std::size_t i = segment - std::min(segment, segments_near); i < end; ++i)
    shortest = std::min(shortest, knots.span(i).step());
  return shortest;
}

}}  // namespace orispline
