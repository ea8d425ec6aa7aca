// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/shared_motion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <orispline/math/chain_elimination.hpp>
#include <orispline/math/eigensystem.hpp>
#include <orispline/math/number.hpp>
#include <orispline/math/scalar_link.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr Eigen::Index longest_part = 512;
constexpr Eigen::Index straight_modes = 2;  // which the penalty does not see
constexpr double white_noise_share = 0.03;  // of σ, beside noise that correlates, for the condition of the fit
constexpr int search_steps_for_time = 6, search_steps = 20;
constexpr double least_strength = 1e-14;
constexpr std::array tried_noise_times{0.0, 1.2, 1.7, 2.4, 3.4, 4.8, 6.8, 9.6, 13.6, 19.2, 27.0, 38.0};  // in intervals
constexpr double first_strength = -14.0, last_strength = 12.0, strength_step = 0.5;                      // logarithms

/// Amplitudes of the cosines of parts of the channels, of each part without its straight line.
struct Spectrum {
  Eigen::MatrixXd amplitudes{};
  Eigen::VectorXd cosines{};  ///< of the phase from time to time
};

/// The line of least squares is left out.
Eigen::MatrixXd without_line(Eigen::MatrixXd values) {
  const Eigen::Index count = values.rows();
  const Eigen::VectorXd times =
      Eigen::VectorXd::LinSpaced(count, -0.5 * static_cast<double>(count - 1), 0.5 * static_cast<double>(count - 1));
  const Eigen::RowVectorXd mean = values.colwise().mean(), slope = times.transpose() * values / times.squaredNorm();
  values.rowwise() -= mean;
  values.noalias() -= times * slope;
  return values;
}

/// Sums go from the first term to the last on every processor; those of Eigen's product go by the size of its caches.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(a.rows(), b.cols());
  for (Eigen::Index k = 0; k < a.cols(); ++k) sum.noalias() += a.col(k) * b.row(k);
  return sum;
}

Spectrum spectrum_of(const Eigen::MatrixXd& values) {
  const Eigen::Index parts = (values.rows() + longest_part - 1) / longest_part;
  const Eigen::Index modes = values.rows() - straight_modes * parts;
  Spectrum all{.amplitudes = Eigen::MatrixXd(modes, values.cols()), .cosines = Eigen::VectorXd(modes)};
  Eigen::Index first = 0, mode = 0;
  for (Eigen::Index part = 0; part < parts; ++part) {
    const Eigen::Index end = values.rows() * (part + 1) / parts, count = end - first;
    std::vector<double> table;
    for (Eigen::Index i = 0; i < 4 * count; ++i)
      table.push_back(
          elementary::sine_cosine(std::numbers::pi * static_cast<double>(i) / static_cast<double>(2 * count)).cosine);
    Eigen::MatrixXd cosines(count - straight_modes, count);
    for (Eigen::Index k = straight_modes; k < count; ++k) {
      all.cosines[mode + k - straight_modes] = table[static_cast<std::size_t>(2 * k)];
      for (Eigen::Index i = 0; i < count; ++i)
        cosines(k - straight_modes, i) = table[static_cast<std::size_t>(k * (2 * i + 1) % (4 * count))];
    }
    all.amplitudes.middleRows(mode, count - straight_modes) =
        std::sqrt(2.0 / static_cast<double>(count)) * product(cosines, without_line(values.middleRows(first, count)));
    first = end, mode += count - straight_modes;
  }
  return all;
}

/// Amplitudes over the root of the spectrum of the noise, in which they are white, and what the penalty has for each.
struct Modes {
  Eigen::MatrixXd amplitudes{};
  Eigen::VectorXd stiffness{};
  double logarithms = 0.0;  ///< of the spectrum of the noise, summed
};

Modes modes_of(const Spectrum& spectrum, double noise_time) {
  const double kept = noise_time > 0.0 ? elementary::exponential(-1.0 / noise_time) : 0.0;
  const double white = noise_time > 0.0 ? white_noise_share * white_noise_share : 0.0;
  Modes modes{.amplitudes = spectrum.amplitudes, .stiffness = Eigen::VectorXd(spectrum.cosines.size())};
  for (Eigen::Index i = 0; i < modes.stiffness.size(); ++i) {
    const double cosine = spectrum.cosines[i], bend = 2.0 - 2.0 * cosine;
    const double noise = (1.0 - kept * kept) / (1.0 - 2.0 * kept * cosine + kept * kept) + white;
    modes.stiffness[i] = noise * bend * bend / ((2.0 + cosine) / 3.0);  // of a cubic spline through even times
    modes.amplitudes.row(i) /= std::sqrt(noise);
    modes.logarithms += elementary::natural_logarithm(noise);
  }
  return modes;
}

/// The best of strengths over σ² that may be, by the sums of logarithms and the sums of squares that each leaves.
struct StrengthGrid {
  Eigen::VectorXd strengths{}, logarithms{};
  Eigen::MatrixXd squares{};  ///< a row for each channel
};

StrengthGrid strength_grid(const Modes& modes) {
  const auto count = static_cast<Eigen::Index>((last_strength - first_strength) / strength_step) + 1;
  StrengthGrid grid{.strengths = Eigen::VectorXd(count), .logarithms = Eigen::VectorXd::Zero(count)};
  Eigen::MatrixXd precisions(modes.stiffness.size(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    grid.strengths[k] = elementary::exponential(first_strength + strength_step * static_cast<double>(k));
    for (Eigen::Index i = 0; i < modes.stiffness.size(); ++i) {
      const double variance = 1.0 + grid.strengths[k] / modes.stiffness[i];
      precisions(i, k) = 1.0 / variance;
      grid.logarithms[k] += elementary::natural_logarithm(variance);
    }
  }
  grid.squares = product(modes.amplitudes.cwiseAbs2().transpose(), precisions);
  return grid;
}

double lower_quartile(std::vector<double> values) {
  const auto quartile = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::ranges::nth_element(values, quartile);
  return *quartile;
}

/// The mean of those of each group, or its lower quartile, for each channel.
template <class Of>
Eigen::VectorXd by_groups(const Eigen::VectorXd& values, const std::vector<std::size_t>& groups, Of of) {
  Eigen::VectorXd all(values.size());
  std::vector<std::vector<double>> members(groups.size());
  for (std::size_t c = 0; c < groups.size(); ++c) members[groups[c]].push_back(values[static_cast<Eigen::Index>(c)]);
  for (std::size_t c = 0; c < groups.size(); ++c) all[static_cast<Eigen::Index>(c)] = of(members[groups[c]]);
  return all;
}
double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Expectation and maximisation for the covariance of the accelerations and the noise.
class MotionSearch {
 public:
  /// `by_joint`: it begins with the noise that each joint shows by itself, which is told well where it is white; else
  /// with that of the quietest quarter of a kind.
  MotionSearch(const Channels& channels, const Modes& modes, const ChannelNoise& known, bool by_joint)
      : channels_(channels),
        modes_(modes),
        amplitudes_(modes.amplitudes),
        is_known_(static_cast<std::size_t>(amplitudes_.cols())) {
    start(known, by_joint);
  }

  /// `by_joint`: each joint has a noise of its own; else all of one kind have the same.
  void step(bool by_joint) {
    find_directions();
    const Eigen::MatrixXd along = product(amplitudes_, directions_);
    Eigen::MatrixXd signal = along;
    Eigen::VectorXd uncertain = Eigen::VectorXd::Zero(along.cols()), moving = uncertain;
    for (Eigen::Index k = 0; k < along.cols(); ++k)
      for (Eigen::Index i = 0; i < along.rows(); ++i) {
        const double share = strengths_[k] / (strengths_[k] + modes_.stiffness[i]);
        signal(i, k) *= share;
        uncertain[k] += share;
        moving[k] += share * modes_.stiffness[i];
      }
    const auto count = static_cast<double>(along.rows());
    const Eigen::VectorXd left =
        product(along - signal, directions_.transpose()).cwiseAbs2().colwise().sum().transpose() +
        directions_.cwiseAbs2() * uncertain;
    const Eigen::MatrixXd root = modes_.stiffness.cwiseSqrt().asDiagonal() * signal;
    Eigen::MatrixXd moments = product(root.transpose(), root);
    moments.diagonal() += moving;
    covariance_ = product(product(directions_, moments), directions_.transpose()) / count;
    const Eigen::VectorXd noise = by_groups(left / count, by_joint ? channels_.joints : channels_.kinds, mean_of);
    for (Eigen::Index c = 0; c < noise.size(); ++c)
      if (!is_known_[static_cast<std::size_t>(c)]) rescale(c, std::sqrt(noise[c]));
  }

  /// -2 log of the likelihood, but for a constant.
  [[nodiscard]] double evidence() {
    find_directions();
    const Eigen::MatrixXd along = product(amplitudes_, directions_);
    double sum = static_cast<double>(along.cols()) * modes_.logarithms;
    for (Eigen::Index k = 0; k < along.cols(); ++k)
      for (Eigen::Index i = 0; i < along.rows(); ++i) {
        const double variance = 1.0 + strengths_[k] / modes_.stiffness[i];
        sum += elementary::natural_logarithm(variance) + along(i, k) * along(i, k) / variance;
      }
    for (const double sigma : sigmas_)
      sum += 2.0 * static_cast<double>(along.rows()) * elementary::natural_logarithm(sigma);
    return sum;
  }

  [[nodiscard]] SharedMotion found(double noise_time) {
    find_directions();
    return {.noise_time = noise_time, .sigmas = sigmas_, .directions = directions_, .strengths = strengths_};
  }

 private:
  /// As if each channel moved by itself.
  void start(const ChannelNoise& known, bool by_joint) {
    const StrengthGrid grid = strength_grid(modes_);
    const auto count = static_cast<double>(modes_.stiffness.size());
    const Eigen::Index channels = amplitudes_.cols();
    Eigen::VectorXd variances(channels);
    for (Eigen::Index c = 0; c < channels; ++c) {
      double least = std::numeric_limits<double>::infinity();
      for (Eigen::Index k = 0; k < grid.strengths.size(); ++k) {
        const double variance = grid.squares(c, k) / count;
        const double value = grid.logarithms[k] + count * elementary::natural_logarithm(variance);
        if (value < least) least = value, variances[c] = variance;
      }
    }
    sigmas_ = (by_joint ? by_groups(variances, channels_.joints, mean_of)
                        : by_groups(variances, channels_.kinds, lower_quartile))
                  .cwiseSqrt();
    for (Eigen::Index c = 0; c < channels; ++c)
      if (const auto& sigma = known.sigmas[channels_.kinds[static_cast<std::size_t>(c)]])
        sigmas_[c] = *sigma, is_known_[static_cast<std::size_t>(c)] = true;
    covariance_ = Eigen::MatrixXd::Zero(channels, channels);
    for (Eigen::Index c = 0; c < channels; ++c) {
      const double variance = sigmas_[c] * sigmas_[c];
      const Eigen::VectorXd values = grid.logarithms + grid.squares.row(c).transpose() / variance;
      Eigen::Index best = 0;
      values.minCoeff(&best);
      covariance_(c, c) = grid.strengths[best];
      amplitudes_.col(c) /= sigmas_[c];
    }
  }

  void rescale(Eigen::Index channel, double ratio) {
    sigmas_[channel] *= ratio;
    amplitudes_.col(channel) /= ratio;
    covariance_.col(channel) /= ratio;
    covariance_.row(channel) /= ratio;
  }

  void find_directions() {
    const Eigensystem<Eigen::Dynamic> system =
        eigensystem<Eigen::Dynamic>((covariance_ + covariance_.transpose()) / 2.0);
    directions_ = system.vectors;
    strengths_ = system.values.cwiseMax(least_strength);
  }

  const Channels& channels_;
  const Modes& modes_;
  Eigen::MatrixXd amplitudes_;  // over the σ of each channel
  std::vector<bool> is_known_;  // the σ of each channel
  Eigen::VectorXd sigmas_{};
  Eigen::MatrixXd covariance_{};  // of accelerations, over the σ of both channels
  Eigen::MatrixXd directions_{};
  Eigen::VectorXd strengths_{};
};

double best_noise_time(const Channels& channels, const Spectrum& spectrum, const ChannelNoise& known) {
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (const double time : tried_noise_times) {
    const Modes modes = modes_of(spectrum, time);
    MotionSearch search(channels, modes, known, false);
    for (int i = 0; i < search_steps_for_time; ++i) search.step(false);
    if (const double evidence = search.evidence(); evidence < least) least = evidence, best = time;
  }
  return best;
}

/// One channel of σ 1 without its noise.
Eigen::VectorXd smoothed_channel(const Eigen::VectorXd& values, double strength, double noise_time) {
  using Chain = ChainElimination<3, 2, 1, 3>;  // value, rate and correlated noise
  Chain chain;
  const Eigen::Index count = values.size();
  chain.start(static_cast<std::size_t>(count));
  const double kept = noise_time > 0.0 ? elementary::exponential(-1.0 / noise_time) : 0.0;
  const double fresh = std::sqrt(1.0 - kept * kept), weight = noise_time > 0.0 ? 1.0 / white_noise_share : 1.0;
  const Eigen::Matrix<double, 2, 4> link = scalar_link<2>(1.0) / std::sqrt(strength);
  for (Eigen::Index i = 0; i < count; ++i) {
    Chain::Low low = Chain::Low::Zero();
    low(0, 0) = weight;
    low(0, 6) = weight * values[i];
    if (noise_time > 0.0) low(0, 2) = weight;
    if (i == 0 || noise_time == 0.0) low(1, 2) = 1.0;
    if (i + 1 < count) {
      low.block<2, 2>(2, 0) = link.leftCols<2>();
      low.block<2, 2>(2, 3) = link.rightCols<2>();
      if (noise_time > 0.0) low(4, 2) = -kept / fresh, low(4, 5) = 1.0 / fresh;
    }
    static_cast<void>(chain.add(low));
  }
  Eigen::VectorXd smooth(count);
  chain.solve(Eigen::Matrix<double, 1, 1>::Ones(),
              [&](std::size_t i, const Eigen::Vector3d& node) { smooth[static_cast<Eigen::Index>(i)] = node[0]; });
  return smooth;
}

}  // namespace

SharedMotion shared_motion(const Channels& channels, const ChannelNoise& known) {
  const Spectrum spectrum = spectrum_of(channels.values);
  const double time = known.time ? *known.time : best_noise_time(channels, spectrum, known);
  const Modes modes = modes_of(spectrum, time);
  const bool is_white = time == 0.0;  // noise that correlates is told less well, and is that of one tracker
  MotionSearch search(channels, modes, known, is_white);
  for (int i = 0; i < search_steps; ++i) search.step(is_white);
  return search.found(time);
}

Eigen::MatrixXd smoothed_channels(const Channels& channels, const SharedMotion& motion) {
  const Eigen::MatrixXd along = product(channels.values * motion.sigmas.cwiseInverse().asDiagonal(), motion.directions);
  Eigen::MatrixXd smooth(along.rows(), along.cols());
  for (Eigen::Index k = 0; k < along.cols(); ++k)
    smooth.col(k) = smoothed_channel(along.col(k), motion.strengths[k], motion.noise_time);
  return product(smooth, motion.directions.transpose()) * motion.sigmas.asDiagonal();
}

double lambda_alone(const SharedMotion& motion, Eigen::Index channel) {
  return 1.0 / motion.directions.row(channel).cwiseAbs2().dot(motion.strengths.transpose());
}

}}  // namespace orispline
