// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_model.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <orispline/math/median.hpp>
#include <orispline/math/number.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using elementary::exponential, elementary::natural_logarithm;

// The columns of what moves the turn linearly.
constexpr int bias_column = 0, scale_column = 3, mount_column = 6, cross_column = 9, offset_column = 12,
              clock_column = 13, unknowns = 14, sides = 1 + unknowns;
using Unknowns = Eigen::Matrix<double, unknowns, 1>;
using Columns = Eigen::Matrix<double, 3, unknowns>;
using Moments = Eigen::Matrix<double, sides, sides>;

// Standard deviations that are expected of scale, mount [rad] and clock rate: of a good sensor, and of one that was
// put on by hand. That of cross-talk goes with the scale.
constexpr std::array scale_widths{0.0, 0.005, 0.05}, mount_widths{0.0, 0.005, 0.05}, clock_widths{0.0, 3e-5, 5e-4};
constexpr double cross_share = 0.1;
constexpr double offset_width = 0.02;  // [s], beside the one that is near
constexpr int reference_reach = 8;  // orientations on either side whose mean the turn is seen from

/// One orientation: what the turn of the path into the world did since the one before.
struct DriftRow {
  bool starts = false;     // a piece of the path
  double interval = 0.0;   // [s]
  Eigen::Vector3d turn;    // from a fixed one, in the world [rad]
  Eigen::Matrix3d walked;  // by a unit of bias since the row before
  Eigen::Matrix3d to_world;
  Columns columns;
  double share = 1.0;
};

/// The matrix by which scale, mount and cross-talk change a rate.
Eigen::Matrix<double, 3, 9> by_shape(const Eigen::Vector3d& g) {
  Eigen::Matrix<double, 3, 9> m = Eigen::Matrix<double, 3, 9>::Zero();
  m.block<3, 3>(0, 0).diagonal() = g;
  for (int k = 0; k < 3; ++k) m.block<3, 1>(0, 3 + k) = Eigen::Vector3d::Unit(k).cross(g);
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    m(i, 6 + k) = g[j];
    m(j, 6 + k) = g[i];
  }
  return m;
}

Eigen::Matrix3d shape_of(const Unknowns& p) {
  Eigen::Matrix3d shape = Eigen::Matrix3d::Identity();
  for (int k = 0; k < 3; ++k) shape.col(k) += by_shape(Eigen::Vector3d::Unit(k)) * p.segment<9>(scale_column);
  return shape;
}

/// Integrals along the path of a gyro, of its own frame: of a unit of bias and of the shape.
class PathIntegrals {
 public:
  using Integral = Eigen::Matrix<double, 3, 12>;

  PathIntegrals(const GyroPath& path, const Eigen::Vector3d& correction) : path_(path), correction_(correction) {}

  /// From an earlier time to this one, both on one piece; times must not decrease.
  [[nodiscard]] Integral to(double t) {
    Integral sum = Integral::Zero();
    const auto& times = path_.times();
    while (next_ < times.size() && times[next_] < t) {
      if (times[next_] > at_) advance(sum, times[next_]);
      ++next_;
    }
    if (t > at_) advance(sum, t);
    return sum;
  }
  void start_at(double t) {
    at_ = t;
    const auto& times = path_.times();
    while (next_ < times.size() && times[next_] <= t) ++next_;
    from_ = path_.at(t);
  }

 private:
  void advance(Integral& sum, double t) {
    const auto to = path_.at(t);
    if (from_ && to && from_->piece == to->piece) {
      const Eigen::Matrix3d turn = from_->orientation.slerp(0.5, to->orientation).toRotationMatrix();
      const double h = t - at_;
      sum.leftCols<3>() += h * turn;
      sum.rightCols<9>() += h * turn * by_shape(0.5 * (from_->rate + to->rate) - correction_);
    }
    from_ = to;
    at_ = t;
  }

  const GyroPath& path_;
  Eigen::Vector3d correction_;
  std::optional<GyroPath::Point> from_;
  double at_ = 0.0;
  std::size_t next_ = 0;
};

/// The turn x in the world [rad] with to = exp(x) from.
Eigen::Vector3d world_increment(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  return shortest_increment(to.conjugate(), from.conjugate());
}

struct Turn {
  double time;
  Eigen::Quaterniond turn;
  GyroPath::Point point;
  double share;
};

std::vector<Turn> turns_of(const SeenPoses& poses, const GyroPath& path, double offset) {
  std::vector<Turn> turns;
  for (std::size_t i = 0; i < poses.times.size(); ++i) {
    if (!poses.counts[i]) continue;
    const auto point = path.at(poses.times[i] + offset);
    if (!point) continue;
    turns.push_back({poses.times[i], poses.orientations[i] * point->orientation.conjugate(), *point,
                     poses.shares.empty() ? 1.0 : poses.shares[i]});
    if (turns.size() > 1) {
      Eigen::Quaterniond& q = turns.back().turn;
      if (q.dot(turns[turns.size() - 2].turn) < 0.0) q.coeffs() = -q.coeffs();
    }
  }
  return turns;
}

/// The mean of those about each.
std::vector<Eigen::Quaterniond> references_of(const std::vector<Turn>& turns) {
  std::vector<Eigen::Quaterniond> references;
  const auto n = static_cast<std::ptrdiff_t>(turns.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t reach = std::min<std::ptrdiff_t>({reference_reach, i, n - 1 - i});
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (std::ptrdiff_t k = i - reach; k <= i + reach; ++k) {
      const Turn& other = turns[static_cast<std::size_t>(k)];
      if (other.point.piece == turns[static_cast<std::size_t>(i)].point.piece) sum += other.turn.coeffs();
    }
    Eigen::Quaterniond mean;
    mean.coeffs() = sum.normalized();
    references.push_back(mean);
  }
  return references;
}

std::vector<DriftRow> rows_of(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                              const GyroCalibration& calibration) {
  const GyroRates rates = calibrated(gyro, calibration);
  const GyroPath path(rates, counts, calibration.correction);
  const std::vector<Turn> turns = turns_of(poses, path, calibration.offset);
  const std::vector<Eigen::Quaterniond> references = references_of(turns);
  PathIntegrals integrals(path, calibration.correction);
  std::vector<DriftRow> rows;
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 12> sums = Eigen::Matrix<double, 3, 12>::Zero();
  for (std::size_t i = 0; i < turns.size(); ++i) {
    DriftRow& row = rows.emplace_back();
    row.starts = i == 0 || turns[i].point.piece != turns[i - 1].point.piece;
    row.share = turns[i].share;
    row.walked.setZero();
    const double at = turns[i].time + calibration.offset;
    if (row.starts) {
      integrals.start_at(at);
    } else {
      row.interval = turns[i].time - turns[i - 1].time;
      way += world_increment(references[i - 1], references[i]);
      const Eigen::Matrix<double, 3, 12> step = references[i].toRotationMatrix() * integrals.to(at);
      row.walked = step.leftCols<3>();
      sums += step;
    }
    row.turn = way + world_increment(references[i], turns[i].turn);
    row.to_world = (references[i] * turns[i].point.orientation).toRotationMatrix();
    row.columns.leftCols<12>() = sums;
    row.columns.col(offset_column) = row.to_world * turns[i].point.rate;
    row.columns.col(clock_column) = (turns[i].time - calibration.clock_origin) * row.columns.col(offset_column);
  }
  return rows;
}

/// What a filter over all rows leaves: the moments of its innovations in their units, of the turns and of the columns.
struct Innovations {
  Moments moments = Moments::Zero();
  double log_determinant = 0.0;
};

/// States: the turn [, a change of the bias] [, the noise that keeps], of three axes each; or the turn and a change of
/// the offset of the clock.
template <bool Walks, bool Keeps, bool Wanders = false>
Innovations filtered_with(const std::vector<DriftRow>& rows, const GyroNoises& noises) {
  constexpr int n = 3 + (Walks ? 3 : 0) + (Keeps ? 3 : 0) + (Wanders ? 1 : 0);
  using State = Eigen::Matrix<double, n, sides>;
  using Covariance = Eigen::Matrix<double, n, n>;
  Innovations result;
  State state = State::Zero();
  Covariance covariance = Covariance::Zero();
  const double keeps = noises.correlated * noises.correlated, walks = noises.drift * noises.drift;
  for (const DriftRow& row : rows) {
    Eigen::Matrix<double, 3, sides> innovation;
    innovation << row.turn, row.columns;
    const double white = noises.white * noises.white / row.share;
    if (row.starts) {  // the turn is open: the first orientation says what it is
      covariance.setZero();
      covariance.template topLeftCorner<3, 3>().diagonal().setConstant(white + (Keeps ? keeps : 0.0));
      if constexpr (Keeps) {
        covariance.template bottomRightCorner<3, 3>().diagonal().setConstant(keeps);
        covariance.template topRightCorner<3, 3>() = -keeps * row.to_world;
        covariance.template bottomLeftCorner<3, 3>() = -keeps * row.to_world.transpose();
      }
      state.setZero();
      state.template topRows<3>() = innovation;
      continue;
    }
    const double h = row.interval, fresh = noises.rate * noises.rate * h;
    if constexpr (n == 3) {  // the same of all axes
      const double predicted = covariance(0, 0) + fresh, spread = predicted + white;
      innovation -= state;
      result.moments.noalias() += innovation.transpose() * innovation / spread;
      result.log_determinant += 3.0 * natural_logarithm(spread);
      state += predicted / spread * innovation;
      covariance(0, 0) = predicted * white / spread;
      continue;
    }
    const double decay = Keeps ? exponential(-h / noises.time) : 0.0;
    Covariance f = Covariance::Identity();
    Eigen::Matrix<double, 3, n> sees = Eigen::Matrix<double, 3, n>::Zero();
    sees.template leftCols<3>().setIdentity();
    if constexpr (Walks) {
      state.template topRows<3>() += row.walked * state.template middleRows<3>(3);
      f.template block<3, 3>(0, 3) = row.walked;
    }
    if constexpr (Keeps) {
      state.template bottomRows<3>() *= decay;
      f.template bottomRightCorner<3, 3>().diagonal().setConstant(decay);
      sees.template rightCols<3>() = row.to_world;
    }
    if constexpr (Wanders) sees.template rightCols<1>() = row.columns.col(offset_column);
    covariance = (f * covariance * f.transpose()).eval();
    covariance.template topLeftCorner<3, 3>().diagonal().array() += fresh + (Walks ? walks * h * h * h / 3.0 : 0.0);
    if constexpr (Walks) covariance.template block<3, 3>(3, 3).diagonal().array() += walks * h;
    if constexpr (Keeps)
      covariance.template bottomRightCorner<3, 3>().diagonal().array() += keeps * (1.0 - decay * decay);
    if constexpr (Wanders) covariance(3, 3) += noises.clock * noises.clock * h;
    const Eigen::Matrix<double, n, 3> cross = covariance * sees.transpose();
    Eigen::Matrix3d spread = sees * cross;
    spread.diagonal().array() += white;
    const Eigen::LLT<Eigen::Matrix3d> factor(spread);
    innovation -= sees * state;
    const Eigen::Matrix<double, 3, sides> scaled = factor.matrixL().solve(innovation);
    result.moments.noalias() += scaled.transpose() * scaled;
    result.log_determinant += 2.0 * natural_logarithm(factor.matrixLLT().diagonal().prod());
    const Eigen::Matrix<double, n, 3> gain = factor.solve(cross.transpose()).transpose();
    state.noalias() += gain * innovation;
    covariance.noalias() -= gain * cross.transpose();
    covariance = (0.5 * (covariance + covariance.transpose())).eval();
  }
  return result;
}

Innovations filtered(const std::vector<DriftRow>& rows, const GyroNoises& noises) {
  if (noises.clock > 0.0) return filtered_with<false, false, true>(rows, noises);
  if (noises.drift > 0.0)
    return noises.correlated > 0.0 ? filtered_with<true, true>(rows, noises) : filtered_with<true, false>(rows, noises);
  return noises.correlated > 0.0 ? filtered_with<false, true>(rows, noises)
                                 : filtered_with<false, false>(rows, noises);
}

/// The widths of what is expected of the unknowns; 0: that one is none. Bias and offset are open.
struct Parts {
  double scale = 0.0, mount = 0.0, clock = 0.0;
  bool offset = false;

  [[nodiscard]] bool has(int column) const {
    return column < scale_column || (column == offset_column ? offset : width(column) > 0.0);
  }
  [[nodiscard]] double width(int column) const {
    if (column < scale_column) return 0.0;
    if (column == offset_column) return offset ? offset_width : 0.0;
    if (column < mount_column) return scale;
    if (column < cross_column) return mount;
    return column < offset_column ? cross_share * std::min(scale, mount) : clock;
  }
};

struct Solution {
  double evidence = std::numeric_limits<double>::infinity();  // -2 log, but for a constant
  Unknowns values = Unknowns::Zero();
  Eigen::Matrix<double, unknowns, unknowns> covariance = Eigen::Matrix<double, unknowns, unknowns>::Zero();
};

/// `present`: values about which the columns are linear.
Solution solved(const Innovations& found, const Unknowns& present, const Parts& parts) {
  // Of the values themselves: turn = (turn + columns present) - ... less what is left.
  Eigen::Matrix<double, unknowns, unknowns> normal = found.moments.bottomRightCorner<unknowns, unknowns>();
  // moments of y + X present, y = X (values - present) + noise
  const Unknowns right = found.moments.bottomLeftCorner<unknowns, 1>() + normal * present;
  const double square = found.moments(0, 0) + 2.0 * found.moments.bottomLeftCorner<unknowns, 1>().dot(present) +
                        present.dot(normal * present);
  Solution solution;
  std::vector<int> active;
  for (int c = 0; c < unknowns; ++c)
    if (parts.has(c)) active.push_back(c);
  const auto m = static_cast<Eigen::Index>(active.size());
  Eigen::MatrixXd a(m, m);
  Eigen::VectorXd b(m);
  double prior = 0.0;
  for (Eigen::Index i = 0; i < m; ++i) {
    b[i] = right[active[static_cast<std::size_t>(i)]];
    for (Eigen::Index k = 0; k < m; ++k)
      a(i, k) = normal(active[static_cast<std::size_t>(i)], active[static_cast<std::size_t>(k)]);
    const double width = parts.width(active[static_cast<std::size_t>(i)]);
    if (width > 0.0) {
      a(i, i) += 1.0 / (width * width);
      prior += 2.0 * natural_logarithm(width);
    } else {
      a(i, i) += 1e-9;  // what nothing tells stays
    }
  }
  const Eigen::VectorXd scale = a.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<Eigen::MatrixXd> factor(scale.asDiagonal() * a * scale.asDiagonal());
  const Eigen::VectorXd x = scale.asDiagonal() * factor.solve(scale.asDiagonal() * b);
  double log_determinant = 0.0;
  for (Eigen::Index i = 0; i < m; ++i)
    log_determinant += natural_logarithm(std::max(1e-300, factor.vectorD()[i])) - 2.0 * natural_logarithm(scale[i]);
  solution.evidence = found.log_determinant + square - b.dot(x) + log_determinant + prior;
  const Eigen::MatrixXd inverse = scale.asDiagonal() * factor.solve(Eigen::MatrixXd::Identity(m, m)) * scale.asDiagonal();
  for (Eigen::Index i = 0; i < m; ++i) {
    solution.values[active[static_cast<std::size_t>(i)]] = x[i];
    for (Eigen::Index k = 0; k < m; ++k)
      solution.covariance(active[static_cast<std::size_t>(i)], active[static_cast<std::size_t>(k)]) = inverse(i, k);
  }
  return solution;
}

constexpr int rounds = 3;
constexpr std::size_t fewest_rows = 8;
constexpr double sure = 8.0, little = 2.0;  // gain of -2 log by which a kind of noise is taken in

/// Noises of greatest likelihood, by a compass search in logarithms.
class NoiseSearch {
 public:
  NoiseSearch(const std::vector<DriftRow>& rows, const GyroModelPlan& plan, const Unknowns& present, const Parts& parts)
      : rows_(rows), plan_(plan), present_(present), parts_(parts) {}

  struct Found {
    GyroNoises noises{};
    double value = std::numeric_limits<double>::infinity();
  };

  /// As wrong as the rates may be under a calibration that is only near.
  [[nodiscard]] Found rough(GyroNoises noises) const {
    noises.rate = std::max(plan_.rate_noise, 0.3 * noises.white);
    return from_all(noises, {&GyroNoises::rate, &GyroNoises::white});
  }

  /// What explains the rows best, where every kind of noise costs its price.
  [[nodiscard]] Found best(const GyroNoises& near, double interval) const {
    using enum_of = double GyroNoises::*;
    constexpr enum_of rate = &GyroNoises::rate, white = &GyroNoises::white, drift = &GyroNoises::drift,
                      kept = &GyroNoises::correlated, time = &GyroNoises::time;
    const auto whiten = [&](GyroNoises noises, std::initializer_list<enum_of> others) {
      std::vector<enum_of> all(others);
      return plan_.states_noise ? from_all(noises, all) : (all.push_back(white), from_all(noises, all));
    };
    Found least = whiten({.rate = plan_.rate_noise, .white = near.white}, {});
    const GyroNoises plain = least.noises;
    const auto consider = [&](const Found& other, double price) {
      if (other.value + price < least.value) least = other;
    };
    if (!plan_.constant_bias) {
      GyroNoises other = plain;
      other.drift = 10.0 * plan_.rate_noise;
      consider(whiten(other, {drift}), little);
      other.drift *= 0.1;
      consider(whiten(other, {drift}), little);
    }
    if (plan_.finds_clock_rate) {
      GyroNoises other = plain;
      other.clock = 1e-3;
      consider(whiten(other, {&GyroNoises::clock}), sure);
    }
    const Found walks = least;
    GyroNoises noisy = walks.noises;
    noisy.rate *= 3.0;
    consider(whiten(noisy, {rate}), sure);
    if (noisy.drift > 0.0) consider(whiten(noisy, {rate, drift}), sure);
    if (plan_.states_noise) return least;
    for (const double intervals : {3.0, 30.0, 300.0}) {
      GyroNoises other = plain;
      other.correlated = plain.white;
      other.white *= 0.5;
      other.time = intervals * interval;
      const Found keeps = whiten(other, {kept, time});
      consider(keeps, 2.0 * sure);
      if (plan_.constant_bias || keeps.value > least.value) continue;
      other = keeps.noises;
      other.drift = plan_.rate_noise;
      consider(whiten(other, {kept, time, drift}), sure);
    }
    return least;
  }

 private:
  static constexpr double first_step = 1.4, last_step = 0.1, least_gain = 0.05;

  [[nodiscard]] double value(const GyroNoises& noises) const {
    return solved(filtered(rows_, noises), present_, parts_).evidence;
  }
  [[nodiscard]] Found from_all(const GyroNoises& noises, const std::vector<double GyroNoises::*>& sought) const {
    GyroNoises there = noises;
    double least = value(there);
    for (double step = first_step; step > last_step; step *= 0.4)
      for (bool moved = true; moved;) {
        moved = false;
        for (double GyroNoises::*const one : sought) moved = descend(there, least, one, step) || moved;
      }
    return {there, least};
  }
  bool descend(GyroNoises& noises, double& least, double GyroNoises::*one, double step) const {
    bool moved = false;
    for (const double factor : {exponential(step), exponential(-step)}) {
      for (;;) {
        const double before = noises.*one;
        const double bound = one == &GyroNoises::rate    ? plan_.rate_noise
                             : one == &GyroNoises::white ? std::max(least_noise, 0.02 * noises.correlated)
                                                         : 1e-12;
        noises.*one = std::max(before * factor, bound);
        const double there = noises.*one == before ? std::numeric_limits<double>::infinity() : value(noises);
        if (!(there < least - least_gain)) {
          noises.*one = before;
          break;
        }
        least = there;
        moved = true;
      }
      if (moved) break;
    }
    return moved;
  }

  const std::vector<DriftRow>& rows_;
  const GyroModelPlan& plan_;
  Unknowns present_;
  Parts parts_;
};

}  // namespace

GyroRates calibrated(const GyroRates& gyro, const GyroCalibration& calibration) {
  GyroRates rates = gyro;
  for (Eigen::Vector3d& rate : rates.rates) rate = (calibration.shape * rate).eval();
  if (calibration.clock_rate != 0.0)
    for (double& t : rates.times) t -= calibration.clock_rate * (t - calibration.clock_origin);
  return rates;
}

GyroModel gyro_model(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                     const GyroModelPlan& plan) {
  GyroModel model;
  model.calibration = plan.near;
  model.noises = {.rate = plan.rate_noise, .white = plan.pose_noise};
  const double span = poses.times.back() - poses.times.front();
  model.calibration.clock_origin = poses.times.front() + 0.5 * span;
  Unknowns present = Unknowns::Zero();
  const auto take = [&](const Unknowns& values) {
    model.calibration.correction = values.segment<3>(bias_column);
    model.calibration.shape = shape_of(values);
    model.calibration.offset = plan.near.offset + values[offset_column];
    model.calibration.clock_rate = values[clock_column];
    present = values;
  };
  present.segment<3>(bias_column) = plan.near.correction;
  const Parts all{.scale = scale_widths.back(),
                  .mount = mount_widths.back(),
                  .clock = plan.finds_clock_rate ? clock_widths.back() : 0.0,
                  .offset = plan.finds_offset};
  const double interval = median_interval(poses.times);
  Solution solution;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<DriftRow> rows = rows_of(poses, gyro, counts, model.calibration);
    if (rows.size() < fewest_rows) return model;
    const NoiseSearch search(rows, plan, present, all);
    const auto found = round == 0 ? search.rough(model.noises) : search.best(model.noises, interval);
    model.noises = found.noises;
    const double least = found.value;
    const Innovations innovations = filtered(rows, model.noises);
    solution = solved(innovations, present, all);
    if (round > 0)
      for (const double scale : scale_widths)
        for (const double mount : mount_widths)
          for (const double clock : clock_widths) {
            if (clock > 0.0 && !plan.finds_clock_rate) continue;
            for (const bool offset : {false, true}) {
              // An offset that is found nowhere else has to be sure.
              if (offset ? !plan.finds_offset : plan.finds_offset && plan.near.offset != 0.0) continue;
              const Parts some{.scale = scale, .mount = mount, .clock = clock, .offset = offset};
              Solution there = solved(innovations, present, some);
            if (!(there.evidence < solution.evidence)) continue;
            solution = there;
            model.has_scale = scale > 0.0;
            model.has_mount = mount > 0.0;
            model.has_clock_rate = clock > 0.0;
            }
          }
    if (getenv("GYRO_DEBUG")) {
      fprintf(stderr, "round %d rate %.4g white %.4g drift %.4g corr %.4g time %.3g ev %.2f parts %d%d%d\n", round,
              model.noises.rate * 57.3, model.noises.white * 57.3, model.noises.drift * 57.3, model.noises.correlated * 57.3, model.noises.time, least,
              model.has_scale, model.has_mount, model.has_clock_rate);
      for (int c = 0; c < unknowns; ++c)
        fprintf(stderr, " %.5g+-%.2g", solution.values[c], std::sqrt(solution.covariance(c, c)));
      fprintf(stderr, "\n");
    }
    take(solution.values);
    model.seen = rows.size();
  }
  model.scale_sigma = solution.covariance.diagonal().segment<3>(scale_column).cwiseSqrt();
  model.mount_sigma = solution.covariance.diagonal().segment<3>(mount_column).cwiseSqrt();
  model.offset_sigma = std::sqrt(solution.covariance(offset_column, offset_column));
  model.clock_rate_sigma = std::sqrt(solution.covariance(clock_column, clock_column));
  return model;
}

}}  // namespace orispline
