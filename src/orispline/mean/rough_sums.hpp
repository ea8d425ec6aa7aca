// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <orispline/mean/mean.hpp>
#include <orispline/mean/weighted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace mean_of {

/// The sums that a mean or a median makes least, to about 1e-6 of them but at a small part of their cost: enough to
/// choose where to begin. The bits are the same on every processor.
class RoughSums {
 public:
  RoughSums(MeanKind kind, const Weighted<Eigen::Quaterniond>& given) : kind_(kind), rows_((given.size() + 3) / 4) {
    for (std::size_t k = 0; k < given.size(); ++k) {
      Rows& rows = rows_[k / 4];
      const auto lane = static_cast<Eigen::Index>(k % 4);
      for (std::size_t i = 0; i < 4; ++i)
        rows.components[i][lane] = static_cast<float>(given.points[k].coeffs()[static_cast<Eigen::Index>(i)]);
      rows.weights[lane] = static_cast<float>(given.weights[k]);
    }
  }

  /// Infinite where it is clear on the way that the sum is above `most`.
  [[nodiscard]] double at(const Eigen::Quaterniond& point, double most) const {
    constexpr std::size_t at_a_time = 32;
    const Eigen::Vector4f q = point.coeffs().cast<float>();
    Four sums = Four::Zero();
    for (std::size_t begin = 0; begin < rows_.size(); begin += at_a_time) {
      const std::size_t end = std::min(begin + at_a_time, rows_.size());
      for (std::size_t i = begin; i < end; ++i) sums += terms(q, rows_[i]);
      if (sum_of(sums) > most) return std::numeric_limits<double>::infinity();
    }
    return sum_of(sums);
  }

 private:
  using Four = Eigen::Array4f;
  struct Rows {
    std::array<Four, 4> components{Four::Zero(), Four::Zero(), Four::Zero(), Four::Zero()};
    Four weights = Four::Zero();
  };

  [[nodiscard]] Four terms(const Eigen::Vector4f& q, const Rows& rows) const {
    // arccos x = √(1 − x) times this, to 2e-8. Source: Abramowitz, Stegun 1964, 4.4.46.
    constexpr std::array a{1.5707963050f, -0.2145988016f, 0.0889789874f, -0.0501743046f,
                           0.0308918810f, -0.0170881256f, 0.0066700901f, -0.0012624911f};
    const auto& [x, y, z, w] = rows.components;
    const Four cosine = (q[0] * x + q[1] * y + q[2] * z + q[3] * w).abs().min(1.0f);
    Four series = Four::Constant(a.back());
    for (std::size_t i = a.size() - 1; i-- > 0;) series = series * cosine + a[i];
    const Four versine = 1.0f - cosine;
    if (kind_ != MeanKind::median) return rows.weights * versine * series * series;
    return rows.weights * series * versine.unaryExpr([](float v) { return std::sqrt(v); });
  }
  [[nodiscard]] static double sum_of(const Four& lanes) {
    return 2.0 * static_cast<double>((lanes[0] + lanes[1]) + (lanes[2] + lanes[3]));
  }

  MeanKind kind_;
  std::vector<Rows> rows_;
};

}}}  // namespace orispline::mean_of
