// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Linear least squares along a chain: rows about one node, and rows that link it to the next, by Householder QR from
/// node to node. Linear time; the normal matrix RᵀR is never formed, so its condition number is square-rooted.
///
/// M unknowns per node, `Data` rows about each node alone, `Sides` right-hand sides, `Link` rows from node to node.
template <int M, int Data, int Sides, int Link = M>
class ChainElimination {
 public:
  static constexpr int unknowns = M;                        ///< of each node
  static constexpr int columns = 2 * M + Sides;             ///< this node, the next one, right-hand sides
  using Row = Eigen::Matrix<double, M, columns>;            ///< of the triangular factor; its lower triangle is unused
  using Low = Eigen::Matrix<double, Data + Link, columns>;  ///< the data rows, then the link rows
  using Remainder = Eigen::Matrix<double, Data + Link, Sides>;  ///< rows of right-hand sides that no unknown can meet

  /// Forgets the nodes of a chain before.
  void start(std::size_t nodes) {
    rows_.clear();
    rows_.reserve(nodes);
    carried_.setZero();
  }

  /// An unknown of the node that comes next is zero. The columns of it must be.
  void fix(int unknown) { carried_(unknown, unknown) = 1.0; }

  /// Eliminates the next node. At the last one the link rows are zero.
  Remainder add(Low low) {
    Row& row = rows_.emplace_back(carried_);
    annihilate(row, low, 0);
    carried_.setZero();
    Row next = Row::Zero();
    annihilate(next, low, M);
    carried_.template leftCols<M>() = next.template middleCols<M>(M);
    carried_.template rightCols<Sides>() = next.template rightCols<Sides>();
    return low.template rightCols<Sides>();
  }

  [[nodiscard]] const std::vector<Row>& rows() const noexcept { return rows_; }

  /// log det RᵀR
  [[nodiscard]] double log_determinant() const {
    double sum = 0.0;
    for (const Row& row : rows_) {
      int exponent = 0;
      const double mantissa = std::frexp(std::abs(row.template leftCols<M>().diagonal().prod()), &exponent);
      sum += elementary::natural_logarithm(mantissa) + std::numbers::ln2 * exponent;
    }
    return 2.0 * sum;
  }

  /// The unknowns of each node for a combination of the right-hand sides, from the last node to the first: calls
  /// `take(node, values)`.
  template <class Take>
  void solve(const Eigen::Matrix<double, Sides, 1>& combination, Take take) const {
    Eigen::Matrix<double, M, 1> next = Eigen::Matrix<double, M, 1>::Zero();
    for (std::size_t i = rows_.size(); i-- > 0;) {
      const Row& row = rows_[i];
      Eigen::Matrix<double, M, 1> x = row.template rightCols<Sides>() * combination;
      x.noalias() -= row.template middleCols<M>(M) * next;
      row.template leftCols<M>().template triangularView<Eigen::Upper>().solveInPlace(x);
      take(i, x);
      next = x;
    }
  }

 private:
  /// Makes the columns first … first + M-1 of `low` zero by reflections, each with one row of `top`.
  static void annihilate(Row& top, Low& low, int first) {
    for (int k = 0; k < M; ++k) {
      const int column = first + k;
      const double square = low.col(column).squaredNorm();
      if (square == 0.0) continue;
      const double pivot = top(k, column), norm = std::sqrt(pivot * pivot + square);
      const double diagonal = pivot > 0.0 ? -norm : norm, head = pivot - diagonal;
      const Eigen::Matrix<double, Data + Link, 1> v = low.col(column) / head;
      const double factor = -head / diagonal;
      top(k, column) = diagonal;
      for (int j = column + 1; j < columns; ++j) {
        const double t = factor * (top(k, j) + v.dot(low.col(j)));
        top(k, j) -= t;
        low.col(j) -= t * v;
      }
    }
  }

  std::vector<Row> rows_;
  Row carried_ = Row::Zero();  // what the nodes before say about the next one
};

}}  // namespace orispline
