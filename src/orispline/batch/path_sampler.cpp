// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/path_sampler.hpp>

#include <orispline/batch/interpolation.hpp>
#include <orispline/batch/kernel/dispatch.hpp>
#include <orispline/batch/sample_layout.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

namespace {

const auto& path_kernel(const PolynomialKernels& k, double) noexcept { return k.path; }
const auto& path_kernel(const PolynomialKernels& k, float) noexcept { return k.path_float; }

template <std::size_t Degree, class T>
std::optional<PathRecord<T>> record_of_degree(const AnyPath& path, std::size_t segment) noexcept {
  static const auto nodes = chebyshev_nodes<Degree + 1>();
  const KnotSpan span = path.knots().span(segment);
  const Subinterval subinterval{segment, span.start(), span.end()};
  PathRecord<T> record{.coefficients = {}, .middle = subinterval.middle(), .per_step = 2.0 / span.step()};
  const auto series =
      interpolated<3>(subinterval, nodes, record.per_step, [&](double t) { return path.position_on(segment, t); });
  if (series.count <= Degree) return std::nullopt;  // a segment of a few doubles
  for (std::size_t k = 0; k <= Degree; ++k)
    for (Eigen::Index axis = 0; axis < 3; ++axis) record.coefficients[axis][k] = static_cast<T>(series.powers[k][axis]);
  return record;
}

}  // namespace

template <class T>
std::optional<PathRecord<T>> record_of(const AnyPath& path, std::size_t segment) noexcept {
  switch (path.degree()) {
    case 1:
      return record_of_degree<1, T>(path, segment);
    case 2:
      return record_of_degree<2, T>(path, segment);
    case 3:
      return record_of_degree<3, T>(path, segment);
    case 4:
      return record_of_degree<4, T>(path, segment);
    case 5:
      return record_of_degree<5, T>(path, segment);
    case 6:
      return record_of_degree<6, T>(path, segment);
    case 7:
      return record_of_degree<7, T>(path, segment);
    default:
      return std::nullopt;
  }
}

template <class T>
PathTarget<T> PathSampler<T>::target_from(std::size_t at) const noexcept {
  return {.position = place_of(out_.positions, out_.layout, 3, at),
          .velocity = place_of(out_.velocities, out_.layout, 3, at),
          .acceleration = place_of(out_.accelerations, out_.layout, 3, at),
          .jerk = place_of(out_.linear_jerks, out_.layout, 3, at),
          .planes = plane_distance(out_)};
}

template <class T>
void PathSampler<T>::on_segment(std::size_t segment, const Clock& clock, std::size_t at, std::size_t count) noexcept {
  if (segment_ != segment) {
    record_ = record_of<T>(path_, segment);
    segment_ = segment;
  }
  if (record_) return path_kernel(*kernels().polynomials, T())(*record_, clock, count, target_from(at));
  for (std::size_t k = 0; k < count; ++k) put(out_, at + k, path_.linear_motion_on(segment, time_of(clock, k)));
}

template <class T>
void PathSampler<T>::hold(Held held, std::size_t at, std::size_t count) noexcept {
  LinearMotion linear_motion = no_motion<Eigen::Vector3d>();
  if (held != Held::nothing)
    linear_motion = {.position = path_.linear_motion(held == Held::first ? knots().front() : knots().back()).position};
  for (std::size_t k = 0; k < count; ++k) put(out_, at + k, linear_motion);
}

template std::optional<PathRecord<double>> record_of<double>(const AnyPath&, std::size_t) noexcept;
template std::optional<PathRecord<float>> record_of<float>(const AnyPath&, std::size_t) noexcept;
template class PathSampler<double>;
template class PathSampler<float>;

}}}  // namespace orispline::batch
