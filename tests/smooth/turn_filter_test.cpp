// SPDX-License-Identifier: Apache-2.0
// The Kalman filter over turns beside the Gaussian that its noises define, as a dense matrix.
#include <orispline/smooth/turn_filter.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <orispline/math/so3.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

namespace columns = calibration_columns;
using testing_support::Dice;

/// Three pieces of a path; nothing in them fits together, which neither the filter nor the Gaussian asks for.
std::vector<PathTurn> any_turns() {
  Dice dice(5);
  std::vector<PathTurn> turns;
  for (int k = 0; k < 15; ++k) {
    PathTurn& turn = turns.emplace_back();
    turn.starts = k == 0 || k == 6 || k == 7;
    turn.interval = turn.starts ? 0.0 : dice.between(0.05, 0.3);
    turn.turn = 0.02 * dice.vector();
    turn.to_world = exp<double>(Eigen::Vector3d(2.0 * dice.vector())).toRotationMatrix();
    turn.walked = turn.interval * exp<double>(dice.vector()).toRotationMatrix();
    for (int column = 0; column < columns::count; ++column) turn.slopes.col(column) = dice.vector();
    turn.share = dice.between(0.3, 2.0);
  }
  return turns;
}

/// What independent units of noise do to the turns of one piece, but for a constant.
Eigen::MatrixXd effects(std::span<const PathTurn> piece, const GyroNoises& noises) {
  constexpr Eigen::Index sources = 16;
  const auto count = static_cast<Eigen::Index>(piece.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * count, sources * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double h = piece[static_cast<std::size_t>(k)].interval;
    const auto decay = [&](double time) {
      return noises.correlated > 0.0 ? std::exp(-time / noises.correlation_time) : 0.0;
    };
    double since = 0.0;
    Eigen::Matrix3d walked = Eigen::Matrix3d::Zero();
    for (Eigen::Index j = k; j < count; ++j) {
      const PathTurn& turn = piece[static_cast<std::size_t>(j)];
      if (j > k) {
        since += turn.interval;
        walked += turn.walked;
      }
      const auto effect = [&](Eigen::Index source) { return all.block<3, 3>(3 * j, sources * k + source); };
      effect(0) = noises.rate * std::sqrt(h) * Eigen::Matrix3d::Identity();
      effect(3) = noises.drift * std::sqrt(h * h * h / 3.0) * Eigen::Matrix3d::Identity();
      effect(6) = noises.drift * std::sqrt(h) * walked;
      const double fresh = k == 0 ? 1.0 : std::sqrt(1.0 - decay(h) * decay(h));
      effect(9) = noises.correlated * fresh * decay(since) * turn.to_world;
      if (j == k) effect(12) = noises.white / std::sqrt(turn.share) * Eigen::Matrix3d::Identity();
      all.block<3, 1>(3 * j, sources * k + 15) = noises.clock * std::sqrt(h) * turn.slopes.col(columns::offset);
    }
  }
  return all;
}

/// Turns, or their slopes, less those of the first one of their piece, in units of their noise.
struct Dense {
  Dense(std::span<const PathTurn> turns, const GyroNoises& noises) {
    for (std::size_t first = 0, last = 0; first < turns.size(); first = last) {
      for (last = first + 1; last < turns.size() && !turns[last].starts;) ++last;
      const auto piece = turns.subspan(first, last - first);
      const auto rows = static_cast<Eigen::Index>(3 * (piece.size() - 1));
      Eigen::MatrixXd seen(rows + 3, TurnInnovations::sides);
      for (std::size_t k = 0; k < piece.size(); ++k)
        seen.middleRows<3>(3 * static_cast<Eigen::Index>(k)) << piece[k].turn, piece[k].slopes;
      const auto less_first = [rows](const Eigen::MatrixXd& all) {
        return Eigen::MatrixXd(all.bottomRows(rows) - all.topRows<3>().replicate(rows / 3, 1));
      };
      const Eigen::MatrixXd noise = less_first(effects(piece, noises));
      const Eigen::LLT<Eigen::MatrixXd> factor(noise * noise.transpose());
      log_determinant += 2.0 * factor.matrixLLT().diagonal().array().log().sum();
      const Eigen::Index before = whitened.rows();
      whitened.conservativeResize(before + rows, TurnInnovations::sides);
      whitened.bottomRows(rows) = factor.matrixL().solve(less_first(seen));
    }
  }
  Eigen::MatrixXd whitened{0, TurnInnovations::sides};
  double log_determinant = 0.0;
};

class TurnFilter : public testing::TestWithParam<GyroNoises> {
 protected:
  const std::vector<PathTurn> turns = any_turns();
  const Dense dense{turns, GetParam()};
};

TEST_P(TurnFilter, HasTheLikelihoodOfTheGaussian) {
  Dice dice(6);
  CalibrationUnknowns change;
  for (double& x : change) x = dice.between(-0.1, 0.1);
  const double wanted = (dense.whitened.col(0) - dense.whitened.rightCols<columns::count>() * change).squaredNorm() +
                        dense.log_determinant;
  EXPECT_NEAR(likelihood(turns, GetParam(), change), wanted, 1e-9 * std::abs(wanted));
  const TurnInnovations innovations = filtered(turns, GetParam());
  EXPECT_NEAR(innovations.log_determinant, dense.log_determinant, 1e-9 * std::abs(dense.log_determinant));
  const Eigen::MatrixXd products = dense.whitened.transpose() * dense.whitened;
  EXPECT_LT((innovations.products - products).norm(), 1e-9 * products.norm());
}

TEST_P(TurnFilter, LeavesWhatTheBestEstimateOfTheGaussianLeaves) {
  if (GetParam().clock > 0.0) GTEST_SKIP() << "the clock keeps";
  CalibrationMatrix wanted = CalibrationMatrix::Zero();
  for (std::size_t first = 0, last = 0; first < turns.size(); first = last) {
    for (last = first + 1; last < turns.size() && !turns[last].starts;) ++last;
    const auto piece = std::span(turns).subspan(first, last - first);
    const auto count = static_cast<Eigen::Index>(piece.size());
    Eigen::MatrixXd slopes(3 * count, columns::count);
    for (Eigen::Index k = 0; k < count; ++k) slopes.middleRows<3>(3 * k) = piece[static_cast<std::size_t>(k)].slopes;
    const Eigen::MatrixXd all = effects(piece, GetParam()), constant = Eigen::Matrix3d::Identity().replicate(count, 1);
    const Eigen::LLT<Eigen::MatrixXd> factor(all * all.transpose());
    const Eigen::MatrixXd level =
        (constant.transpose() * factor.solve(constant)).inverse() * constant.transpose() * factor.solve(slopes);
    const Eigen::MatrixXd sources = all.transpose() * factor.solve(slopes - constant * level);
    Eigen::MatrixXd estimate = constant * level;
    for (Eigen::Index k = 0; k < count; ++k)  // noise of the rates and of the bias
      estimate += all.middleCols(16 * k, 9) * sources.middleRows(16 * k, 9);
    wanted += (slopes - estimate).transpose() * (slopes - estimate);
  }
  const CalibrationMatrix found = left_by_smoother(turns, GetParam());
  EXPECT_LT((found - wanted).norm(), 1e-8 * wanted.norm());
}

/// Generalised least squares, what is expected being rows of their own.
TEST_P(TurnFilter, HasTheEvidenceOfTheGaussian) {
  CalibrationUnknowns present;
  present.setLinSpaced(-0.01, 0.02);
  for (const CalibrationPrior& prior :
       {CalibrationPrior{},
        {.scale = 0.05, .mount = 0.02},
        {.scale = 0.01, .mount = 0.05, .trend = 0.03, .offset = 0.1, .clock_rate = 0.2}}) {
    std::vector<Eigen::Index> active;
    std::vector<double> roots;  // of the precision that is expected of each
    double wanted = dense.log_determinant;
    for (int column = 0; column < columns::count; ++column) {
      if (!prior.has(column)) continue;
      active.push_back(column);
      const double width = prior.width(column);
      roots.push_back(width > 0.0 ? 1.0 / width : 0.0);
      if (width > 0.0) wanted += 2.0 * std::log(width);
    }
    const Eigen::Index rows = dense.whitened.rows(), count = std::ssize(active);
    const Eigen::MatrixXd slopes = dense.whitened.rightCols<columns::count>();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows + count, count);
    matrix.topRows(rows) = slopes(Eigen::all, active);
    matrix.bottomRows(count).diagonal() = Eigen::Map<const Eigen::VectorXd>(roots.data(), count);
    Eigen::VectorXd side = Eigen::VectorXd::Zero(rows + count);
    side.head(rows) = dense.whitened.col(0) + slopes * present;
    const Eigen::HouseholderQR<Eigen::MatrixXd> factor(matrix);
    const Eigen::VectorXd values = factor.solve(side);
    const Eigen::MatrixXd upper = factor.matrixQR().topRows(count).triangularView<Eigen::Upper>();
    wanted += (side - matrix * values).squaredNorm() + 2.0 * upper.diagonal().cwiseAbs().array().log().sum();

    const FoundCalibration found = solved(filtered(turns, GetParam()), present, prior);
    EXPECT_NEAR(found.evidence, wanted, 1e-7 * std::abs(wanted));
    EXPECT_LT((found.values(active) - values).norm(), 1e-7 * values.norm());
    const Eigen::VectorXd sigmas = upper.inverse().rowwise().norm();
    EXPECT_LT((found.sigmas(active) - sigmas).norm(), 1e-7 * sigmas.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(
    EveryStates, TurnFilter,
    testing::Values(GyroNoises{.rate = 0.02, .white = 0.01}, GyroNoises{.rate = 0.02, .drift = 0.1, .white = 0.01},
                    GyroNoises{.rate = 0.02, .white = 0.01, .correlated = 0.03, .correlation_time = 0.4},
                    GyroNoises{.rate = 0.02, .drift = 0.1, .white = 0.01, .correlated = 0.03, .correlation_time = 0.4},
                    GyroNoises{.rate = 0.02, .clock = 0.05, .white = 0.01}));

}}  // namespace orispline
