// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/turn_filter.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

namespace columns = calibration_columns;
using elementary::exponential, elementary::natural_logarithm;

constexpr double cross_share = 0.1;  // of cross-talk, in what is expected of scale and mount

/// What the states are, three axes of each but for the clock.
struct States {
  bool drift = false, correlated = false, clock = false;  // beside the turn

  [[nodiscard]] constexpr int size() const { return 3 + (drift ? 3 : 0) + (correlated ? 3 : 0) + (clock ? 1 : 0); }
};

template <int Sides>
using Seen = Eigen::Matrix<double, 3, Sides>;

/// Of noise that correlates, after so long [s].
double decay(const GyroNoises& noises, double time) {
  return noises.correlated > 0.0 ? exponential(-time / noises.correlation_time) : 0.0;
}

/// Where the turn is open: the first orientation, of this variance beside what correlates, says what it is.
template <States Of, class Covariance>
void start(Covariance& covariance, const PathTurn& turn, double white, const GyroNoises& noises) {
  const double correlated = noises.correlated * noises.correlated;
  covariance.setZero();
  covariance.template topLeftCorner<3, 3>().diagonal().setConstant(white + (Of.correlated ? correlated : 0.0));
  if constexpr (Of.correlated) {
    covariance.template bottomRightCorner<3, 3>().diagonal().setConstant(correlated);
    covariance.template topRightCorner<3, 3>() = -correlated * turn.to_world;
    covariance.template bottomLeftCorner<3, 3>() = -correlated * turn.to_world.transpose();
  }
}

/// From the orientation before; returns what of the states an orientation sees.
template <States Of, class State, class Covariance>
Eigen::Matrix<double, 3, Of.size()> advance(State& state, Covariance& covariance, const PathTurn& turn,
                                            const GyroNoises& noises) {
  constexpr int n = Of.size();
  const double h = turn.interval;
  Eigen::Matrix<double, 3, n> sees = Eigen::Matrix<double, 3, n>::Zero();
  sees.template leftCols<3>().setIdentity();
  if constexpr (Of.drift) {
    const double drift = noises.drift * noises.drift;
    state.template topRows<3>() += turn.walked * state.template middleRows<3>(3);
    covariance.template topRows<3>() += turn.walked * covariance.template middleRows<3>(3);
    covariance.template leftCols<3>() += covariance.template middleCols<3>(3) * turn.walked.transpose();
    covariance.template topLeftCorner<3, 3>().diagonal().array() += drift * h * h * h / 3.0;
    covariance.template block<3, 3>(3, 3).diagonal().array() += drift * h;
  }
  if constexpr (Of.correlated) {
    const double kept = decay(noises, h);
    state.template bottomRows<3>() *= kept;
    covariance.template bottomRows<3>() *= kept;
    covariance.template rightCols<3>() *= kept;
    covariance.template bottomRightCorner<3, 3>().diagonal().array() +=
        noises.correlated * noises.correlated * (1.0 - kept * kept);
    sees.template rightCols<3>() = turn.to_world;
  }
  if constexpr (Of.clock) {
    covariance(n - 1, n - 1) += noises.clock * noises.clock * h;
    sees.template rightCols<1>() = turn.slopes.col(columns::offset);
  }
  covariance.template topLeftCorner<3, 3>().diagonal().array() += noises.rate * noises.rate * h;
  return sees;
}

// Products are lazy, since those of large matrices have other bits on other machines.

/// What an orientation tells: the turns that it sees less what was expected, their covariance, and by how much they
/// move the states.
template <int N, int Sides>
struct Correction {
  Eigen::LLT<Eigen::Matrix3d> spread;
  Eigen::Matrix<double, N, 3> gain;
  Seen<Sides> innovation;
};

/// Of the states, by an orientation whose white noise has this variance.
template <int N, int Sides>
Correction<N, Sides> correct(Eigen::Matrix<double, N, Sides>& state, Eigen::Matrix<double, N, N>& covariance,
                             const Eigen::Matrix<double, 3, N>& sees, const Seen<Sides>& seen, double white) {
  const Eigen::Matrix<double, N, 3> cross = covariance.lazyProduct(sees.transpose());
  Eigen::Matrix3d spread = sees.lazyProduct(cross);
  spread.diagonal().array() += white;
  Correction<N, Sides> made{
      .spread = Eigen::LLT<Eigen::Matrix3d>(spread), .gain = {}, .innovation = seen - sees.lazyProduct(state)};
  made.gain = made.spread.solve(cross.transpose()).transpose();
  state += made.gain.lazyProduct(made.innovation);
  covariance -= made.gain.lazyProduct(cross.transpose());
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
  return made;
}

/// A Kalman filter over turns, each seen with so many right-hand sides; calls `take(innovations, log_determinant)` with
/// every innovation in units of its σ.
template <States Of, int Sides, class See, class Take>
void filter(std::span<const PathTurn> turns, const GyroNoises& noises, See see, Take take) {
  constexpr int n = Of.size();
  using Covariance = Eigen::Matrix<double, n, n>;
  Eigen::Matrix<double, n, Sides> state = Eigen::Matrix<double, n, Sides>::Zero();
  Covariance covariance = Covariance::Zero();
  for (const PathTurn& turn : turns) {
    Seen<Sides> seen = see(turn);
    const double white = noises.white * noises.white / turn.share;
    if (turn.starts) {
      start<Of>(covariance, turn, white, noises);
      state.setZero();
      state.template topRows<3>() = seen;
      continue;
    }
    if constexpr (n == 3) {  // the same of all axes
      const double predicted = covariance(0, 0) + noises.rate * noises.rate * turn.interval, spread = predicted + white;
      seen -= state;
      state += predicted / spread * seen;
      covariance(0, 0) = predicted * white / spread;
      take(Seen<Sides>(seen / std::sqrt(spread)), 3.0 * natural_logarithm(spread));
    } else {
      const Eigen::Matrix<double, 3, n> sees = advance<Of>(state, covariance, turn, noises);
      const auto made = correct<n, Sides>(state, covariance, sees, seen, white);
      take(Seen<Sides>(made.spread.matrixL().solve(made.innovation)),
           2.0 * natural_logarithm(made.spread.matrixLLT().diagonal().prod()));
    }
  }
}

/// What an orientation leaves of the filter to those before it.
struct Step {
  static constexpr States of{.drift = true, .correlated = true};
  static constexpr int n = of.size();
  Eigen::Matrix<double, n, columns::count> state;
  Eigen::Matrix<double, 3, n> covariance, sees;  // of the turn with all states; of these by the orientation
  Eigen::Matrix<double, n, 3> gain;
  Eigen::Matrix<double, 3, columns::count> innovation;  // over its covariance
};

std::vector<Step> steps_of(std::span<const PathTurn> turns, const GyroNoises& noises) {
  constexpr int n = Step::n;
  std::vector<Step> steps;
  steps.reserve(turns.size());
  Eigen::Matrix<double, n, n> covariance;
  Eigen::Matrix<double, n, columns::count> state;
  for (const PathTurn& turn : turns) {
    Step& step = steps.emplace_back();
    const double white = noises.white * noises.white / turn.share;
    if (turn.starts) {
      start<Step::of>(covariance, turn, white, noises);
      state.setZero();
      state.template topRows<3>() = turn.slopes;
    } else {
      step.sees = advance<Step::of>(state, covariance, turn, noises);
      const auto made = correct<n, columns::count>(state, covariance, step.sees, turn.slopes, white);
      step.innovation = made.spread.solve(made.innovation);
      step.gain = made.gain;
    }
    step.state = state;
    step.covariance = covariance.template topRows<3>();
  }
  return steps;
}

template <int Sides, class See, class Take>
void filter_with(std::span<const PathTurn> turns, const GyroNoises& noises, See see, Take take) {
  const bool drifts = noises.drift > 0.0, correlates = noises.correlated > 0.0;
  if (noises.clock > 0.0) filter<States{.clock = true}, Sides>(turns, noises, see, take);
  else if (drifts && correlates) filter<States{.drift = true, .correlated = true}, Sides>(turns, noises, see, take);
  else if (drifts) filter<States{.drift = true}, Sides>(turns, noises, see, take);
  else if (correlates) filter<States{.correlated = true}, Sides>(turns, noises, see, take);
  else filter<States{}, Sides>(turns, noises, see, take);
}

}  // namespace

TurnInnovations filtered(std::span<const PathTurn> turns, const GyroNoises& noises) {
  constexpr int sides = TurnInnovations::sides;
  TurnInnovations result;
  filter_with<sides>(
      turns, noises,
      [](const PathTurn& turn) {
        Seen<sides> seen;
        seen << turn.turn, turn.slopes;
        return seen;
      },
      [&](const Seen<sides>& innovation, double log_determinant) {
        result.products += innovation.transpose().lazyProduct(innovation);
        result.log_determinant += log_determinant;
      });
  return result;
}

double likelihood(std::span<const PathTurn> turns, const GyroNoises& noises, const CalibrationUnknowns& change) {
  double sum = 0.0;
  filter_with<1>(
      turns, noises, [&](const PathTurn& turn) { return Seen<1>(turn.turn - turn.slopes * change); },
      [&](const Seen<1>& innovation, double log_determinant) { sum += innovation.squaredNorm() + log_determinant; });
  return sum;
}

// Source: Bryson and Frazier 1963, by what the orientations behind tell of the states.
CalibrationMatrix left_by_smoother(std::span<const PathTurn> turns, const GyroNoises& noises) {
  const std::vector<Step> steps = steps_of(turns, noises);
  CalibrationMatrix sum = CalibrationMatrix::Zero();
  Eigen::Matrix<double, Step::n, columns::count> behind = Eigen::Matrix<double, Step::n, columns::count>::Zero();
  for (std::size_t k = turns.size(); k-- > 0;) {
    const PathTurn& turn = turns[k];
    const Step& step = steps[k];
    const Eigen::Matrix<double, 3, columns::count> left =
        turn.slopes - step.state.topRows<3>() - step.covariance.lazyProduct(behind);
    sum += left.transpose().lazyProduct(left);
    if (turn.starts) {
      behind.setZero();
      continue;
    }
    const Eigen::Matrix<double, 3, columns::count> told = step.innovation - step.gain.transpose().lazyProduct(behind);
    behind += step.sees.transpose().lazyProduct(told);
    behind.middleRows<3>(3) += turn.walked.transpose() * behind.topRows<3>();
    behind.bottomRows<3>() *= decay(noises, turn.interval);
  }
  return sum;
}

double CalibrationPrior::width(int column) const {
  if (column < columns::scale) return 0.0;
  if (column < columns::mount) return scale;
  if (column < columns::cross) return mount;
  if (column < columns::trend) return cross_share * std::min(scale, mount);
  if (column < columns::offset) return trend;
  return column == columns::offset ? offset : clock_rate;
}

FoundCalibration solved(const TurnInnovations& innovations, const CalibrationUnknowns& present,
                        const CalibrationPrior& prior) {
  constexpr double least = 1e-9;  // of what nothing tells
  const auto& products = innovations.products;
  const Eigen::Matrix<double, columns::count, columns::count> normal =
      products.bottomRightCorner<columns::count, columns::count>();
  const CalibrationUnknowns by_turn = products.bottomLeftCorner<columns::count, 1>();
  const CalibrationUnknowns right = by_turn + normal * present;
  FoundCalibration found;
  found.evidence = innovations.log_determinant + products(0, 0) + present.dot(by_turn + right);
  std::vector<Eigen::Index> active;
  for (int column = 0; column < columns::count; ++column)
    if (prior.has(column)) active.push_back(column);
  Eigen::MatrixXd matrix = normal(active, active);
  const Eigen::VectorXd side = right(active);
  for (std::size_t i = 0; i < active.size(); ++i) {
    const double width = prior.width(static_cast<int>(active[i]));
    const auto k = static_cast<Eigen::Index>(i);
    matrix(k, k) += width > 0.0 ? 1.0 / (width * width) : least;
    if (width > 0.0) found.evidence += 2.0 * natural_logarithm(width);
  }
  const Eigen::VectorXd unit = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<Eigen::MatrixXd> factor(unit.asDiagonal() * matrix * unit.asDiagonal());
  const Eigen::VectorXd values = unit.cwiseProduct(factor.solve(unit.cwiseProduct(side)));
  Eigen::MatrixXd inverse(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < values.size(); ++i)  // one by one, as products are lazy
    inverse.col(i) = factor.solve(Eigen::VectorXd::Unit(values.size(), i));
  found.evidence -= side.dot(values);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Eigen::Index column = active[static_cast<std::size_t>(i)];
    found.evidence += natural_logarithm(factor.vectorD()[i]) - 2.0 * natural_logarithm(unit[i]);
    found.values[column] = values[i];
    found.sigmas[column] = unit[i] * std::sqrt(inverse(i, i));
  }
  found.covariance(active, active) = unit.asDiagonal() * inverse * unit.asDiagonal();
  return found;
}

}}  // namespace orispline
