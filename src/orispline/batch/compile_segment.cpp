// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/compile_segment.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/math/so3.hpp>

namespace orispline::batch {
namespace {

using Powers = std::array<double, record_degree + 1>;

/// Row i: the coefficients of the Bernstein polynomial B_i of degree N in powers of s = u - 1/2, exact in double.
template <std::size_t N>
consteval std::array<Powers, N + 1> centred_table() {
  std::array<Powers, N + 1> table{};
  double binomial = 1.0;
  for (std::size_t i = 0; i <= N; ++i) {
    Powers p{binomial};
    std::size_t degree = 0;
    const auto times = [&](double slope) {  // by 1/2 + slope s
      for (std::size_t k = degree + 1; k-- > 0;) {
        p[k + 1] += slope * p[k];
        p[k] *= 0.5;
      }
      ++degree;
    };
    for (std::size_t k = 0; k < i; ++k) times(1.0);
    for (std::size_t k = i; k < N; ++k) times(-1.0);
    table[i] = p;
    binomial = binomial * static_cast<double>(N - i) / static_cast<double>(i + 1);
  }
  return table;
}

template <std::size_t N>
Powers centred_of(const std::array<double, form_degree + 1>& bernstein) noexcept {
  static constexpr auto table = centred_table<N>();
  Powers sum{};
  for (std::size_t i = 0; i <= N; ++i)
    for (std::size_t k = 0; k <= N; ++k) sum[k] += bernstein[i] * table[i][k];
  return sum;
}

Powers centred(std::size_t degree, const std::array<double, form_degree + 1>& bernstein) noexcept {
  switch (degree) {
    case 1:
      return centred_of<1>(bernstein);
    case 2:
      return centred_of<2>(bernstein);
    case 3:
      return centred_of<3>(bernstein);
    case 4:
      return centred_of<4>(bernstein);
    case 5:
      return centred_of<5>(bernstein);
    case 6:
      return centred_of<6>(bernstein);
    default:
      return centred_of<7>(bernstein);
  }
}

/// A factor's blending function without the multiple of ½ that it has in the middle, which goes into the constants.
struct Centred {
  double offset;
  double largest;  ///< of the rest, by its Bernstein coefficients
  Powers powers;
};

Centred without_offset(std::size_t degree, const BernsteinForm& form) noexcept {
  Centred c{.offset = 0.0, .largest = 0.0, .powers = centred(degree, form.coefficients)};
  c.offset = 0.5 * std::round(2.0 * c.powers[0]);
  c.powers[0] -= c.offset;
  for (std::size_t i = 0; i <= degree; ++i) c.largest = std::max(c.largest, std::abs(form.coefficients[i] - c.offset));
  return c;
}

struct Place {
  double middle, per_step;
};
Place place_of(const KnotSpan& span) noexcept { return {span.start() + 0.5 * span.step(), 1.0 / span.step()}; }

/// Powers of s about the double nearest to the middle, which at large times is not the middle itself.
void shift_to(double middle, const KnotSpan& span, Powers& p) noexcept {
  const double off = ((middle - span.start()) - 0.5 * span.step()) / span.step();
  if (off == 0.0) return;
  for (std::size_t r = 0; r < record_degree; ++r)
    for (std::size_t k = record_degree; k-- > r;) p[k] += off * p[k + 1];
}

/// Column `lane` of the rows that the kernel reads.
template <class T>
void store(const Powers& from, double scale, std::size_t lane, T (&to)[record_degree + 1][4]) noexcept {
  for (std::size_t k = 0; k < from.size(); ++k) to[k][lane] = static_cast<T>(scale * from[k]);
}

template <class T>
void store(const Eigen::Vector3d& from, T (&to)[3]) noexcept {
  for (Eigen::Index k = 0; k < 3; ++k) to[k] = static_cast<T>(from[k]);
}

Eigen::Quaterniond pure(const Eigen::Vector3d& v) { return {0.0, v.x(), v.y(), v.z()}; }

/// M {1,a} {1,b} {1,c}: bit k of the index takes the axis of factor k.
template <class T>
void store_products(const Eigen::Quaterniond& middle, const std::array<Eigen::Vector3d, 3>& axes,
                    T (&to)[8][4]) noexcept {
  std::array<Eigen::Quaterniond, 8> all{middle};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t low = 0; low < (1U << k); ++low) all[low | (1U << k)] = all[low] * pure(axes[k]);
  for (std::size_t i = 0; i < 8; ++i)
    for (Eigen::Index k = 0; k < 4; ++k) to[i][k] = static_cast<T>(all[i].coeffs()[k]);
}

AngleRange range_of(const std::array<double, 3>& largest) noexcept {
  const double outer = std::max(largest[0], largest[2]);
  if (outer <= 0.25 && largest[1] <= 1.0) return AngleRange::narrow;
  return outer <= 1.0 && largest[1] <= 1.0 ? AngleRange::wide : AngleRange::any;
}

}  // namespace

FactoredSegment factored(const CumulativeForm& form, const KnotSpan& span) noexcept {
  const auto [middle, per_step] = place_of(span);
  FactoredSegment segment{
      .middle = form.base, .vectors = {}, .factors = {}, .largest = {}, .middle_time = middle, .per_step = per_step};
  Eigen::Quaterniond after = Eigen::Quaterniond::Identity();
  for (std::size_t k = 3; k-- > 0;) {  // from the last: each vector is carried by the constant parts after it
    Centred factor = without_offset(form.degree, form.blending[k]);
    segment.vectors[k] = to_body<double>(after, 0.5 * form.increments[k]);
    segment.largest[k] = factor.largest;
    shift_to(middle, span, factor.powers);
    segment.factors[k] = factor.powers;
    if (factor.offset != 0.0) after = exp<double>(factor.offset * form.increments[k]) * after;
  }
  segment.middle = form.base * after;
  return segment;
}

template <class T>
CumulativeRecord<T> compile_segment(const CumulativeForm& form, const KnotSpan& span) noexcept {
  const FactoredSegment segment = factored(form, span);
  CumulativeRecord<T> record{};
  record.middle = segment.middle_time;
  record.per_step = segment.per_step;
  record.short_degree = form.degree <= 5;
  std::array<Eigen::Vector3d, 3> axes;
  std::array<double, 3> largest;
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = norm_of<double>(segment.vectors[k]);
    axes[k] = angle > 0.0 ? Eigen::Vector3d(segment.vectors[k] / angle) : Eigen::Vector3d::UnitX();
    largest[k] = angle * segment.largest[k];
    store(segment.factors[k], angle, k, record.angles);
  }
  store_products<T>(segment.middle, axes, record.products);
  const Eigen::Vector3d along = axes[1].dot(axes[0]) * axes[1];
  store<T>(along, record.carried[0]);
  store<T>(axes[0] - along, record.carried[1]);
  store<T>(axes[0].cross(axes[1]), record.carried[2]);
  store<T>(axes[1], record.axis_b);
  store<T>(axes[2], record.axis_c);
  record.range = range_of(largest);
  return record;
}

template <class T>
CompiledChart<T> compile_segment(const ChartForm& form, const KnotSpan& span) noexcept {
  const auto [middle, per_step] = place_of(span);
  CompiledChart<T> compiled{};
  compiled.record.middle = middle;
  compiled.record.per_step = per_step;
  compiled.record.short_degree = form.degree <= 5;
  for (Eigen::Index k = 0; k < 4; ++k) compiled.record.base[k] = static_cast<T>(form.base.coeffs()[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    Powers powers = centred(form.degree, form.rotation_vector[k].coefficients);
    shift_to(middle, span, powers);
    store(powers, 1.0, k, compiled.record.rotation_vector);
  }
  for (std::size_t i = 0; i <= form.degree; ++i) {
    const auto& v = form.rotation_vector;
    const double bound = Eigen::Vector3d(v[0].coefficients[i], v[1].coefficients[i], v[2].coefficients[i]).norm();
    compiled.half_angle = std::max(compiled.half_angle, 0.5 * bound);
  }
  return compiled;
}

template CumulativeRecord<double> compile_segment<double>(const CumulativeForm&, const KnotSpan&) noexcept;
template CumulativeRecord<float> compile_segment<float>(const CumulativeForm&, const KnotSpan&) noexcept;
template CompiledChart<double> compile_segment<double>(const ChartForm&, const KnotSpan&) noexcept;
template CompiledChart<float> compile_segment<float>(const ChartForm&, const KnotSpan&) noexcept;

}  // namespace orispline::batch
