// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/compile_segment.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

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
Powers centred(const BernsteinForm& bernstein) noexcept {
  static constexpr auto table = centred_table<N>();
  Powers sum{};
  for (std::size_t i = 0; i <= N; ++i)
    for (std::size_t k = 0; k <= N; ++k) sum[k] += bernstein.coefficients[i] * table[i][k];
  return sum;
}

/// Calls `run.operator()<N>()` for the degree N of a form, so that its loops have no more turns than they need.
template <class Run>
auto by_degree(std::size_t degree, Run run) noexcept {
  switch (degree) {
    case 1:
      return run.template operator()<1>();
    case 2:
      return run.template operator()<2>();
    case 3:
      return run.template operator()<3>();
    case 4:
      return run.template operator()<4>();
    case 5:
      return run.template operator()<5>();
    case 6:
      return run.template operator()<6>();
    default:
      return run.template operator()<7>();
  }
}

/// How far a blending function gets from a number, by its Bernstein coefficients.
template <std::size_t N>
double largest_difference(const BernsteinForm& form, double from) noexcept {
  double largest = 0.0;
  for (std::size_t i = 0; i <= N; ++i) largest = std::max(largest, std::abs(form.coefficients[i] - from));
  return largest;
}

/// The double nearest to a segment's middle; at large times it is not the middle itself.
struct Place {
  double middle, per_step;
  double off;  ///< from the middle, in steps
};
Place place_of(const KnotSpan& span) noexcept {
  const double middle = span.start() + 0.5 * span.step();
  return {middle, 1.0 / span.step(), ((middle - span.start()) - 0.5 * span.step()) / span.step()};
}

/// Powers of s about the middle become those about its double.
template <std::size_t N>
void shift_to(const Place& place, Powers& p) noexcept {
  if (place.off == 0.0) return;
  for (std::size_t r = 0; r < N; ++r)
    for (std::size_t k = N; k-- > r;) p[k] += place.off * p[k + 1];
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
void store_products(const Eigen::Quaterniond& middle, const std::array<Eigen::Quaterniond, 3>& axes,
                    T (&to)[8][4]) noexcept {
  std::array<Eigen::Quaterniond, 8> all{middle};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t low = 0; low < (1U << k); ++low) all[low | (1U << k)] = all[low] * axes[k];
  for (std::size_t i = 0; i < 8; ++i)
    for (Eigen::Index k = 0; k < 4; ++k) to[i][k] = static_cast<T>(all[i].coeffs()[k]);
}

AngleRange range_of(const std::array<double, 3>& largest) noexcept {
  const double outer = std::max(largest[0], largest[2]);
  if (outer <= 0.25 && largest[1] <= 1.0) return AngleRange::narrow;
  return outer <= 1.0 && largest[1] <= 1.0 ? AngleRange::wide : AngleRange::any;
}

/// The factors wait for each other only where their constant parts meet. Without calls: a vector that is handed
/// over in memory is loaded in other pieces than it was stored in, for which the processor waits.
template <std::size_t N>
[[gnu::flatten]] FactoredSegment factored_of_degree(const CumulativeForm& form, const KnotSpan& span) noexcept {
  const Place place = place_of(span);
  FactoredSegment segment;  // filled below: to clear it first takes time
  segment.middle_time = place.middle;
  segment.per_step = place.per_step;
  std::array<double, 3>
      offsets;  // the multiple of ½ that a blending function has in the middle goes into the constants
  for (std::size_t k = 0; k < 3; ++k) {
    Powers& factor = segment.factors[k];
    factor = centred<N>(form.blending[k]);
    offsets[k] = 0.5 * std::round(2.0 * factor[0]);
    factor[0] -= offsets[k];
    segment.largest[k] = largest_difference<N>(form.blending[k], offsets[k]);
    shift_to<N>(place, factor);
  }
  const auto constant_part = [&](std::size_t k) -> Eigen::Vector3d { return offsets[k] * form.increments[k]; };
  const auto constants = exp_of_each<3, double>({constant_part(0), constant_part(1), constant_part(2)});
  Eigen::Quaterniond after = Eigen::Quaterniond::Identity();
  for (std::size_t k = 3; k-- > 0;) {  // from the last: each vector is carried by the constant parts after it
    segment.vectors[k] = to_body<double>(after, 0.5 * form.increments[k]);
    if (offsets[k] != 0.0) after = constants[k] * after;
  }
  segment.middle = form.base * after;
  return segment;
}

}  // namespace

FactoredSegment factored(const CumulativeForm& form, const KnotSpan& span) noexcept {
  return by_degree(form.degree, [&]<std::size_t N>() { return factored_of_degree<N>(form, span); });
}

template <class T>
CompiledSegment<CumulativeRecord<T>> compile_segment(const CumulativeForm& form, const KnotSpan& span) noexcept {
  const FactoredSegment segment = factored(form, span);
  CompiledSegment<CumulativeRecord<T>> compiled;  // filled below: to clear it first takes time
  CumulativeRecord<T>& record = compiled.record;
  record.middle = segment.middle_time;
  record.per_step = segment.per_step;
  record.short_degree = form.degree <= 5;
  std::array<Eigen::Quaterniond, 3> axes;  // pure, and made well before the products, which load them two by two
  std::array<double, 3> largest;
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = norm_of<double>(segment.vectors[k]);
    axes[k] = pure(angle > 0.0 ? Eigen::Vector3d(segment.vectors[k] / angle) : Eigen::Vector3d::UnitX());
    largest[k] = angle * segment.largest[k];
    store(segment.factors[k], angle, k, record.angles);
  }
  for (auto& row : record.angles) row[3] = T(0);
  const Eigen::Vector3d a = axes[0].vec(), b = axes[1].vec(), along = b.dot(a) * b;
  store<T>(along, record.carried[0]);
  store<T>(a - along, record.carried[1]);
  store<T>(a.cross(b), record.carried[2]);
  store<T>(b, record.axis_b);
  store<T>(axes[2].vec(), record.axis_c);
  store_products<T>(segment.middle, axes, record.products);
  record.range = range_of(largest);
  compiled.half_angle = std::ranges::max(largest);
  return compiled;
}

template <class T>
CompiledSegment<ChartRecord<T>> compile_segment(const ChartForm& form, const KnotSpan& span) noexcept {
  const Place place = place_of(span);
  CompiledSegment<ChartRecord<T>> compiled;
  compiled.record.middle = place.middle;
  compiled.record.per_step = place.per_step;
  compiled.record.short_degree = form.degree <= 5;
  for (Eigen::Index k = 0; k < 4; ++k) compiled.record.base[k] = static_cast<T>(form.base.coeffs()[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Powers powers = by_degree(form.degree, [&]<std::size_t N>() {
      Powers p = centred<N>(form.rotation_vector[k]);
      shift_to<N>(place, p);
      return p;
    });
    store(powers, 1.0, k, compiled.record.rotation_vector);
  }
  for (auto& row : compiled.record.rotation_vector) row[3] = T(0);
  double longest = 0.0;
  for (std::size_t i = 0; i <= form.degree; ++i) {
    const auto& v = form.rotation_vector;
    const Eigen::Vector3d control(v[0].coefficients[i], v[1].coefficients[i], v[2].coefficients[i]);
    longest = std::max(longest, control.squaredNorm());
  }
  compiled.half_angle = 0.5 * std::sqrt(longest);
  return compiled;
}

template <class T>
CompiledRational<T> compile_segment(const RationalForm& form, const KnotSpan& span) noexcept {
  constexpr std::size_t degree = RationalForm::degree;
  const Place place = place_of(span);
  CompiledRational<T> compiled{};
  compiled.record.middle = place.middle;
  compiled.record.per_step = place.per_step;
  std::array<Eigen::Vector4d, degree + 1> controls;
  for (std::size_t k = 0; k < form.components.size(); ++k) {
    Powers powers = centred<degree>(form.components[k]);
    shift_to<degree>(place, powers);
    for (std::size_t i = 0; i <= degree; ++i) {
      compiled.record.coefficients[k][i] = static_cast<T>(powers[i]);
      controls[i][static_cast<Eigen::Index>(k)] = form.components[k].coefficients[i];
    }
  }
  double longest = 0.0, shortest = std::numeric_limits<double>::infinity();
  const Eigen::Vector4d along = (controls.front() + controls.back()).stableNormalized();
  for (const Eigen::Vector4d& c : controls) {
    longest = std::max(longest, c.stableNorm());
    shortest = std::min(shortest, c.dot(along));
  }
  compiled.spread = shortest > 0.0 ? longest / shortest : std::numeric_limits<double>::infinity();
  return compiled;
}

namespace {

template <class T>
ArcRecord<T> arc_of(const Eigen::Quaterniond& start, const Eigen::Vector3d& increment, double half_angle) noexcept {
  const double angle = 2.0 * half_angle;
  const Eigen::Vector3d axis = angle > 0.0 ? Eigen::Vector3d(increment / angle) : Eigen::Vector3d::UnitX();
  const Eigen::Quaterniond across = start * pure(axis);
  ArcRecord<T> arc;
  for (Eigen::Index k = 0; k < 4; ++k) {
    arc.start[k] = static_cast<T>(start.coeffs()[k]);
    arc.across[k] = static_cast<T>(across.coeffs()[k]);
  }
  arc.half_angle = static_cast<T>(half_angle);
  return arc;
}

}  // namespace

template <class T>
CompiledSegment<SquadRecord<T>> compile_segment(const SquadForm& form, const KnotSpan& span) noexcept {
  const double outer = 0.5 * norm_of<double>(form.outer_increment), inner = 0.5 * norm_of<double>(form.inner_increment);
  CompiledSegment<SquadRecord<T>> compiled;
  compiled.record.outer = arc_of<T>(form.outer, form.outer_increment, outer);
  compiled.record.inner = arc_of<T>(form.inner, form.inner_increment, inner);
  compiled.record.middle = span.start();
  compiled.record.per_step = 1.0 / span.step();
  // From either end the arcs part by no more than they turn.
  const double at_start = 0.5 * norm_of<double>(increment<double>(form.outer, form.inner));
  const double at_end = 0.5 * norm_of<double>(increment<double>(form.outer * exp<double>(form.outer_increment),
                                                                form.inner * exp<double>(form.inner_increment)));
  compiled.half_angle = std::max({outer, inner, 0.5 * (at_start + at_end + outer + inner)});
  return compiled;
}

template CompiledSegment<SquadRecord<double>> compile_segment<double>(const SquadForm&, const KnotSpan&) noexcept;
template CompiledSegment<SquadRecord<float>> compile_segment<float>(const SquadForm&, const KnotSpan&) noexcept;
template CompiledRational<double> compile_segment<double>(const RationalForm&, const KnotSpan&) noexcept;
template CompiledRational<float> compile_segment<float>(const RationalForm&, const KnotSpan&) noexcept;
template CompiledSegment<CumulativeRecord<double>> compile_segment<double>(const CumulativeForm&,
                                                                           const KnotSpan&) noexcept;
template CompiledSegment<CumulativeRecord<float>> compile_segment<float>(const CumulativeForm&,
                                                                         const KnotSpan&) noexcept;
template CompiledSegment<ChartRecord<double>> compile_segment<double>(const ChartForm&, const KnotSpan&) noexcept;
template CompiledSegment<ChartRecord<float>> compile_segment<float>(const ChartForm&, const KnotSpan&) noexcept;

}}}  // namespace orispline::batch
