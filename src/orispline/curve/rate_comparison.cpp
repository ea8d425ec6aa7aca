// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/rate_comparison.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

constexpr double contradiction = 0.5;   // from this misfit on another meaning is looked for
constexpr double agreeing_share = 0.4;  // of the misfit as body rates, and of 1: below both another one agrees

struct Candidate {
  std::string_view code, in_degrees, cure;
  bool in_world;
  double sign;
};

constexpr std::string_view name_world = "`columns` wx_world=…,wy_world=…,wz_world=… names them so";
constexpr std::string_view other_way = "give `conjugate`, or leave it out where it is given";

constexpr std::array candidates{
    Candidate{"body", "degrees", "they agree", false, 1.0},
    Candidate{"world", "degrees_world", "they agree as rates in the frame of the world", true, 1.0},
    Candidate{"conjugate", "degrees_conjugate", "they agree if the orientations turn the other way round", true, -1.0},
    Candidate{"reversed", "degrees_reversed",
              "they agree with all signs reversed, as rates of the world do where the orientations turn the other way "
              "round",
              false, -1.0}};

Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3d>& vectors) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : vectors) sum += v;
  return sum / static_cast<double>(vectors.size());
}

double root_mean_square(std::vector<Eigen::Vector3d> vectors, RateComparison::Bias bias) {
  if (vectors.empty()) return 0.0;
  const Eigen::Vector3d mean =
      bias == RateComparison::Bias::constant ? mean_of(vectors) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  double sum = 0.0;
  for (const Eigen::Vector3d& v : vectors) sum += (v - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

/// The misfit if the given rates are those of the candidate, times `unit` [1/(rad/s)].
double misfit_of(const RateComparison& rates, const Candidate& candidate, double unit) {
  std::vector<Eigen::Vector3d> given(rates.given.begin(), rates.given.end()), wanted, differences;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Eigen::Vector3d& turned = rates.turned[i];
    const Eigen::Vector3d there = candidate.in_world ? Eigen::Vector3d(rates.orientations[i] * turned) : turned;
    wanted.emplace_back(candidate.sign * unit * there);
    differences.emplace_back(given[i] - wanted.back());
  }
  const double size =
      std::max(root_mean_square(std::move(given), rates.bias), root_mean_square(std::move(wanted), rates.bias));
  return size > 0.0 ? root_mean_square(std::move(differences), rates.bias) / size : 0.0;
}

std::string cure_of(const Candidate& candidate, std::string_view unit) {
  std::string cure = formatted("{}{}", candidate.cure, unit);
  if (candidate.code == "world") cure += formatted(": {}", name_world);
  if (candidate.code == "conjugate") cure += formatted(": {}", other_way);
  if (candidate.code == "reversed") cure += formatted(": {}, and {}", other_way, name_world);
  return cure;
}

}  // namespace

double RateComparison::misfit() const { return misfit_of(*this, candidates.front(), 1.0); }

std::optional<RateMeaning> RateComparison::better_meaning() const {
  const double as_body = misfit();
  if (as_body < contradiction) return std::nullopt;
  double least = agreeing_share * std::min(1.0, as_body);
  std::optional<RateMeaning> best;
  for (const bool in_degrees : {false, true})
    for (const Candidate& candidate : candidates) {
      const double misfit = misfit_of(*this, candidate, in_degrees ? degrees : 1.0);
      if (!(misfit < least)) continue;
      least = misfit;
      const auto unit = in_degrees ? " in degrees per second, which need columns with names that end in _deg_s" : "";
      best = RateMeaning{in_degrees ? candidate.in_degrees : candidate.code, cure_of(candidate, unit)};
    }
  return best;
}

}  // namespace orispline::inline ORISPLINE_ABI
