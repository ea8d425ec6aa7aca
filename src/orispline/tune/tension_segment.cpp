// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/geodesic.hpp>
#include <orispline/tune/tension_model.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

BernsteinForm elevated(BernsteinForm form, std::size_t degree) {
  auto& c = form.coefficients;
  for (std::size_t n = degree + 1; n <= form_degree; ++n)
    for (std::size_t j = n; j > 0; --j) {
      const double share = static_cast<double>(j) / static_cast<double>(n);
      c[j] = share * c[j - 1] + (1.0 - share) * c[j];
    }
  return form;
}

TensionSegment handle_segment(TensionSegment::Product product, double start, double step,
                              const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                              const Eigen::Vector3d& leaving, const Eigen::Vector3d& arriving) {
  // In the tangent space the cubic's control points are 0, the first handle, the increment less the second one, and the
  // increment.
  return {.product = product,
          .start = start,
          .step = step,
          .from = from,
          .to = to,
          .increments = {leaving, increment<double>(from, to), arriving},
          .constant = {elevated(BernsteinForm{{0.0, 1.0}}, 3), elevated(BernsteinForm{{0.0, 0.0, 1.0, 1.0}}, 3),
                       elevated(BernsteinForm{{0.0, 0.0, -1.0}}, 3)}};
}

TensionSegment cumulative_segment(double start, double step, const Eigen::Quaterniond& from,
                                  const Increments& increments) {
  return {
      .product = TensionSegment::Product::cumulative,
      .start = start,
      .step = step,
      .from = from,
      .to = displaced_in_turn(from, increments),
      .increments = increments,
      .constant = {elevated(BernsteinForm{{0.0, 1.0, 1.0, 1.0}}, 3), elevated(BernsteinForm{{0.0, 0.0, 1.0, 1.0}}, 3),
                   elevated(BernsteinForm{{0.0, 0.0, 0.0, 1.0}}, 3)}};
}

BernsteinForm correction_form() { return elevated(BernsteinForm{{0.0, 0.0, 0.05}}, 5); }  // u² (1-u)³ / 2

}}  // namespace orispline
