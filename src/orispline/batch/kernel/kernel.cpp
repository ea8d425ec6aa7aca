// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: ORISPLINE_KERNELS names what this one defines. Everything else stands in an
// anonymous namespace, so that the linker cannot mix them. Without contraction into fused multiply-adds all of them
// give the same bits.
#include <orispline/batch/kernel/chart_kernel.hpp>
#include <orispline/batch/kernel/cumulative_kernel.hpp>
#include <orispline/batch/kernel/squad_kernel.hpp>
#include <orispline/batch/kernel/times_kernel.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

namespace {

template <class T>
struct TurnPlanes {
  alignas(64) Plane<T> w, x, y, z;
};

template <class T>
[[gnu::always_inline]] inline void turns(const T* from, std::size_t plane, T factor, int padded, TurnPlanes<T>& to) {
  for (int i = 0; i < padded; ++i) {
    const Turn<T> t = turn(from + i, plane, factor);
    to.w[i] = t.w;
    to.x[i] = t.x;
    to.y[i] = t.y;
    to.z[i] = t.z;
  }
}

template <class T>
void bundle(const BundleSegment<T>& segment, std::size_t count, const Target<T>& target) {
  const std::size_t plane = segment.plane;
  TurnPlanes<T> turned[3];
  alignas(64) Plane<T> q[4];
  in_blocks(
      count, [&](std::size_t at, int here, int padded) __attribute__((always_inline)) {
        const T* from = segment.planes + at;
        for (std::size_t k = 0; k < 3; ++k)
          turns(from + (4 + 3 * k) * plane, plane, segment.factors[k], padded, turned[k]);
        for (int i = 0; i < padded; ++i) {
          const auto factor = [&](int k) __attribute__((always_inline)) {
            return Turn<T>{turned[k].w[i], turned[k].x[i], turned[k].y[i], turned[k].z[i]};
          };
          const T* m = from + i;
          const Turn<T> product =
              ((Turn<T>{m[3 * plane], m[0], m[plane], m[2 * plane]} * factor(0)) * factor(1)) * factor(2);
          q[0][i] = product.x;
          q[1][i] = product.y;
          q[2][i] = product.z;
          q[3][i] = product.w;
        }
        lay_out(q, here, target.orientation, at, target.planes);
      });
}

}  // namespace

#define ORISPLINE_TEXT_OF(name) #name
#define ORISPLINE_TEXT(name) ORISPLINE_TEXT_OF(name)

extern const PolynomialKernels ORISPLINE_POLYNOMIAL_KERNELS;
extern const Kernels ORISPLINE_KERNELS;
const Kernels ORISPLINE_KERNELS{ORISPLINE_TEXT(ORISPLINE_KERNELS),
                                &cumulative<double>,
                                &cumulative<float>,
                                &chart<double>,
                                &chart<float>,
                                &squad<double>,
                                &squad<float>,
                                &bundle<double>,
                                &bundle<float>,
                                &are_in_order,
                                &write_even_times,
                                &write_decimal_times,
                                &ORISPLINE_POLYNOMIAL_KERNELS};

}}}  // namespace orispline::batch
