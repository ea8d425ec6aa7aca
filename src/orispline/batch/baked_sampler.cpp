// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/baked_sampler.hpp>

#include <limits>

#include <orispline/batch/kernel/dispatch.hpp>
#include <orispline/batch/sample_layout.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

namespace {

const auto& baked_kernel(const PolynomialKernels& k, double) noexcept { return k.baked; }
const auto& baked_kernel(const PolynomialKernels& k, float) noexcept { return k.baked_float; }

}  // namespace

template <class T>
void sample_piece(const BakedRecord<T>& piece, const Clock& clock, std::size_t count,
                  const Target<T>& target) noexcept {
  baked_kernel(*kernels().polynomials, T())(piece, clock, count, target);
}

template <class T>
void BakedSampler<T>::on_segment(std::size_t piece, const Clock& clock, std::size_t at, std::size_t count) noexcept {
  sample_piece<T>(curve_.piece(piece), clock, count, target_of(out_, at));
}

template <class T>
void BakedSampler<T>::hold(Held held, std::size_t at, std::size_t count) noexcept {
  Eigen::Matrix<T, 4, 1> q = Eigen::Matrix<T, 4, 1>::Constant(std::numeric_limits<T>::quiet_NaN());
  if (held != Held::nothing) {
    const bool first = held == Held::first || knots().segments() == 0;
    const double end = first ? knots().front() : knots().back();
    sample_piece<T>(curve_.piece(first ? 0 : knots().segments() - 1),
                    {.times = &end, .start = 0.0, .step = 0.0, .first = 0.0}, 1, {.orientation = q.data()});
  }
  put_held(out_, at, count, Eigen::Quaterniond(q.template cast<double>()));
}

template void sample_piece(const BakedRecord<double>&, const Clock&, std::size_t, const Target<double>&) noexcept;
template void sample_piece(const BakedRecord<float>&, const Clock&, std::size_t, const Target<float>&) noexcept;
template class BakedSampler<double>;
template class BakedSampler<float>;

}}}  // namespace orispline::batch
