// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/rate_comparison.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double contradiction = 0.25;  // from this misfit on another meaning is looked for
constexpr double agreeing_share = 0.4;  // of the misfit as body rates, and of 1: below both another one agrees

constexpr double too_small = 0.7;  // times the rates of the orientations

/// The frame in which the rates of the orientations are the given ones.
enum class GivenIn {
  body,
  world,
  turned_from_world,  ///< those of the body, which were taken for the world's and turned into the body's frame
};

struct Candidate {
  std::string_view code, cure;
  GivenIn frame;
  double sign;
};

constexpr std::string_view name_world = "`columns` wx_world=…,wy_world=…,wz_world=… names them so";
constexpr std::string_view name_body = "`columns` wx=…,wy=…,wz=… names them so";
constexpr std::string_view other_way = "give `conjugate`, or leave it out where it is given";

constexpr std::array candidates{
    Candidate{"body", "they agree", GivenIn::body, 1.0},
    Candidate{"world", "they agree as rates in the frame of the world", GivenIn::world, 1.0},
    Candidate{"conjugate", "they agree if the orientations turn the other way round", GivenIn::world, -1.0},
    Candidate{"reversed",
              "they agree with all signs reversed, as rates of the world do where the orientations turn the other way "
              "round",
              GivenIn::body, -1.0},
    Candidate{"body_taken_for_world", "they agree as rates in the body's own frame, and not in that of the world",
              GivenIn::turned_from_world, 1.0}};

/// What one unit of the given rates is [1/(rad/s)].
struct RateUnit {
  std::string_view code, cure;
  double size;
};

constexpr std::array rate_units{
    RateUnit{"", "", 1.0},
    RateUnit{"degrees", " in degrees per second, which need columns with names that end in _deg_s", degrees},
    RateUnit{"radians", " in radians per second, which need columns with names that do not end in _deg_s",
             1.0 / degrees}};

/// The axes of the body along which those of a gyro point: signed permutations but the one that changes nothing.
std::vector<Eigen::Matrix3d> exchanged_axes() {
  std::vector<Eigen::Matrix3d> all;
  std::array<Eigen::Index, 3> order{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
      for (Eigen::Index k = 0; k < 3; ++k)
        axes(k, order[static_cast<std::size_t>(k)]) = ((signs >> k) & 1U) != 0 ? -1.0 : 1.0;
      if (axes != Eigen::Matrix3d::Identity()) all.push_back(axes);
    }
  } while (std::ranges::next_permutation(order).found);
  return all;
}

Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3d>& vectors) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : vectors) sum += v;
  return sum / static_cast<double>(vectors.size());
}

double root_mean_square(const std::vector<Eigen::Vector3d>& vectors, RateComparison::Bias bias) {
  if (vectors.empty()) return 0.0;
  const Eigen::Vector3d mean =
      bias == RateComparison::Bias::constant ? mean_of(vectors) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  double sum = 0.0;
  for (const Eigen::Vector3d& v : vectors) sum += (v - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

Eigen::Vector3d seen_in(GivenIn frame, const Eigen::Quaterniond& orientation, const Eigen::Vector3d& turned) {
  switch (frame) {
    case GivenIn::world:
      return orientation * turned;
    case GivenIn::turned_from_world:
      return orientation.conjugate() * turned;
    case GivenIn::body:
      break;
  }
  return turned;
}

/// The misfit if the given rates are those of the orientations in that frame, times a matrix.
double misfit_of(const RateComparison& rates, GivenIn frame, const Eigen::Matrix3d& times) {
  std::vector<Eigen::Vector3d> given(rates.given.begin(), rates.given.end()), wanted, differences;
  for (std::size_t i = 0; i < given.size(); ++i) {
    wanted.emplace_back(times * seen_in(frame, rates.orientations[i], rates.turned[i]));
    differences.emplace_back(given[i] - wanted.back());
  }
  const double size = std::max(root_mean_square(given, rates.bias), root_mean_square(wanted, rates.bias));
  return size > 0.0 ? root_mean_square(differences, rates.bias) / size : 0.0;
}

std::string code_of(const Candidate& candidate, const RateUnit& unit) {
  if (unit.code.empty()) return std::string(candidate.code);
  return candidate.code == "body" ? std::string(unit.code) : formatted("{}_{}", unit.code, candidate.code);
}

std::string cure_of(const Candidate& candidate, const RateUnit& unit) {
  std::string cure = formatted("{}{}", candidate.cure, unit.cure);
  if (candidate.code == "world") cure += formatted(": {}", name_world);
  if (candidate.code == "conjugate") cure += formatted(": {}", other_way);
  if (candidate.code == "reversed") cure += formatted(": {}, and {}", other_way, name_world);
  if (candidate.code == "body_taken_for_world") cure += formatted(": {}", name_body);
  return cure;
}

/// `-y, x, z`: the body's axes along x, y and z of the gyro.
std::string text_of(const Eigen::Matrix3d& axes) {
  std::string text;
  for (Eigen::Index k = 0; k < 3; ++k)
    for (Eigen::Index of_body = 0; of_body < 3; ++of_body)
      if (axes(k, of_body) != 0.0)
        text += formatted("{}{}{}", text.empty() ? "" : ", ", axes(k, of_body) < 0.0 ? "-" : "", "xyz"[of_body]);
  return text;
}

/// The factor that makes the rates of the orientations the nearest to the given ones.
double scale_of(const RateComparison& rates) {
  const auto about_mean = [&](std::span<const Eigen::Vector3d> vectors) {
    std::vector<Eigen::Vector3d> all(vectors.begin(), vectors.end());
    if (rates.bias == RateComparison::Bias::none) return all;
    const Eigen::Vector3d mean = mean_of(all);
    for (Eigen::Vector3d& v : all) v -= mean;
    return all;
  };
  const auto given = about_mean(rates.given), turned = about_mean(rates.turned);
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    product += given[i].dot(turned[i]);
    square += turned[i].squaredNorm();
  }
  return square > 0.0 && product > 0.0 ? product / square : 1.0;
}

}  // namespace

double RateComparison::misfit() const { return misfit_of(*this, GivenIn::body, Eigen::Matrix3d::Identity()); }

std::optional<RateMeaning> RateComparison::better_meaning() const {
  const double as_body = misfit();
  if (as_body < contradiction) return std::nullopt;
  double least = agreeing_share * std::min(1.0, as_body);
  std::optional<RateMeaning> best;
  const auto try_meaning = [&](GivenIn frame, const Eigen::Matrix3d& times, const auto& meaning) {
    const double misfit = misfit_of(*this, frame, times);
    if (!(misfit < least)) return;
    least = misfit;
    best = meaning();
  };
  for (const RateUnit& unit : rate_units)
    for (const Candidate& candidate : candidates)
      try_meaning(candidate.frame, candidate.sign * unit.size * Eigen::Matrix3d::Identity(), [&] {
        return RateMeaning{code_of(candidate, unit), cure_of(candidate, unit)};
      });
  if (best) return best;
  for (const Eigen::Matrix3d& axes : exchanged_axes())
    try_meaning(GivenIn::body, axes, [&] {
      return RateMeaning{"axes", formatted("they agree if x, y and z of the rates are {} of the body, which need "
                                           "columns in the order and with the signs of the body's axes",
                                           text_of(axes))};
    });
  if (best) return best;
  // Rates that are too large are left alone: those of orientations which were smoothed too much look smaller.
  if (const double scale = scale_of(*this); scale < too_small)
    try_meaning(GivenIn::body, scale * Eigen::Matrix3d::Identity(), [&] {
      return RateMeaning{"scaled", formatted("they agree if they are divided by {:.3g}, which need another unit than "
                                             "rad/s or columns that are scaled",
                                             scale)};
    });
  return best;
}

}}  // namespace orispline
