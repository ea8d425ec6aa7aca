// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: ORISPLINE_KERNELS names what this one defines. Everything else stands in an
// anonymous namespace, so that the linker cannot mix them. Without contraction into fused multiply-adds all of them
// give the same bits.
#include <orispline/batch/chart_kernel.hpp>
#include <orispline/batch/cumulative_kernel.hpp>

namespace orispline::batch {
namespace {

template <class T>
void bundle(const BundleSegment<T>& segment, std::size_t count, const Target<T>& target) {
  const std::size_t plane = segment.plane;
  const T a = segment.factors[0], b = segment.factors[1], c = segment.factors[2];
  alignas(64) Plane<T> q[4];
  in_blocks(
      count, [&](std::size_t at, int here, int padded) __attribute__((always_inline)) {
        const T* from = segment.planes + at;
        for (int i = 0; i < padded; ++i) {
          const T* m = from + i;
          const Turn<T> product =
              ((Turn<T>{m[3 * plane], m[0], m[plane], m[2 * plane]} * turn(m + 4 * plane, plane, a)) *
               turn(m + 7 * plane, plane, b)) *
              turn(m + 10 * plane, plane, c);
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

extern const Kernels ORISPLINE_KERNELS;
const Kernels ORISPLINE_KERNELS{ORISPLINE_TEXT(ORISPLINE_KERNELS),
                                &cumulative<double>,
                                &cumulative<float>,
                                &chart<double>,
                                &chart<float>,
                                &bundle<double>,
                                &bundle<float>};

}  // namespace orispline::batch
