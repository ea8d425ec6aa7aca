// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/banded_lu.hpp>

#include <algorithm>
#include <cmath>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Of what stands in the rows or columns of one place within the band.
struct Range {
  std::size_t begin, end;
};

Range within_band(const BandedMatrix& a, std::size_t place) {
  return {place - std::min(place, a.band()), std::min(place + a.band() + 1, a.size())};
}

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

}  // namespace

BandedMatrix normal_matrix(const BandedMatrix& a) {
  BandedMatrix normal(a.size(), 2 * a.band());
  for (std::size_t row = 0; row < a.size(); ++row) {
    const Range columns = within_band(a, row);
    for (std::size_t i = columns.begin; i < columns.end; ++i)
      for (std::size_t j = columns.begin; j < columns.end; ++j) normal(i, j) += a(row, i) * a(row, j);
  }
  return normal;
}

Eigen::VectorXd transposed_product(const BandedMatrix& a, const Eigen::VectorXd& x) {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(index(a.size()));
  for (std::size_t row = 0; row < a.size(); ++row) {
    const Range columns = within_band(a, row);
    for (std::size_t j = columns.begin; j < columns.end; ++j) product[index(j)] += a(row, j) * x[index(row)];
  }
  return product;
}

BandedLu::BandedLu(BandedMatrix matrix)
    : matrix_(std::move(matrix)), exchanged_with_(matrix_.size()), reach_(matrix_.band()) {
  for (std::size_t k = 0; k < matrix_.size(); ++k) {
    bring_up_pivot(k);
    double* const pivot = &matrix_(k, k);
    if (!(std::abs(*pivot) > 0.0)) {
      regular_ = false;
      return;
    }
    const std::size_t columns = end_column(k) - k, last = last_row(k);
    for (std::size_t i = k + 1; i <= last; ++i) {
      double* const row = &matrix_(i, k);
      if (*row == 0.0) continue;
      const double factor = *row /= *pivot;
      for (std::size_t j = 1; j < columns; ++j) row[j] -= factor * pivot[j];
    }
    for (std::size_t j = 1; j < columns; ++j) pivot[j] /= *pivot;
  }
}

Eigen::VectorXd BandedLu::solve(Eigen::VectorXd x) const {
  for (std::size_t k = 0; k < matrix_.size(); ++k) {
    std::swap(x[index(k)], x[index(exchanged_with_[k])]);
    const double known = x[index(k)];
    const std::size_t last = last_row(k);
    for (std::size_t i = k + 1; i <= last; ++i) x[index(i)] -= matrix_(i, k) * known;
  }
  for (std::size_t k = matrix_.size(); k-- > 0;) {
    const double* const row = &matrix_(k, k);
    double left = x[index(k)] / *row;
    for (std::size_t j = end_column(k) - k; --j > 0;) left -= row[j] * x[index(k + j)];  // the newest last: none waits
    x[index(k)] = left;
  }
  return x;
}

std::size_t BandedLu::last_row(std::size_t column) const noexcept {
  return std::min(column + matrix_.band(), matrix_.size() - 1);
}

std::size_t BandedLu::end_column(std::size_t row) const noexcept { return std::min(row + reach_ + 1, matrix_.size()); }

/// The largest entry of column k, of those not yet eliminated.
void BandedLu::bring_up_pivot(std::size_t k) {
  std::size_t pivot = k;
  for (std::size_t i = k + 1; i <= last_row(k); ++i)
    if (std::abs(matrix_(i, k)) > std::abs(matrix_(pivot, k))) pivot = i;
  exchanged_with_[k] = pivot;
  if (pivot == k) return;
  reach_ = 2 * matrix_.band();
  double* const row = &matrix_(k, k);
  std::swap_ranges(row, row + (end_column(k) - k), &matrix_(pivot, k));
}

}}  // namespace orispline
