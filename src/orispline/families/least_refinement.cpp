// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least_refinement.hpp>

#include <array>
#include <numeric>

#include <orispline/curve/torque.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

constexpr double excess_share = 2e-9;        // of the energy, that is let be
constexpr std::size_t most_pieces = 256;     // of an interval
constexpr double rounding_of_turns = 1e-11;  // [rad]; so little within a piece is no excess
/// Of the excess by the change of momentum, measured against twice as many pieces.
constexpr double scale_of_excess = 1e-4, scale_of_jerk_excess = 1e-5;

/// Half the momentum of the orientation in the body frame at u of a piece, and the turn from there to the world.
Eigen::Vector3d momentum(LeastOf of, const Eigen::Matrix3d& inertia, const ChartPiece<5>& piece, double h, double u) {
  const auto path = rotation_vector(piece, Jet<double, 5>::variable(u));
  const auto rate = chart_rate<double, 5>(path);
  double power = h;
  std::array<Eigen::Vector3d, 5> omega;  // ω and its derivatives
  for (std::size_t k = 0; k < omega.size(); ++k, power *= h)
    omega[k] = Eigen::Vector3d(rate.x().derivative(k), rate.y().derivative(k), rate.z().derivative(k)) / power;
  const Motion m{.orientation = piece.base * exp<double>({path.x().c[0], path.y().c[0], path.z().c[0]}),
                 .angular_velocity = omega[0],
                 .angular_acceleration = omega[1],
                 .angular_jerk = omega[2]};
  if (of == LeastOf::jerk) return m.orientation * omega[4];
  if (of == LeastOf::acceleration) return m.orientation * omega[2];
  const Eigen::Vector3d force = torque(m, inertia);
  const Eigen::Vector3d spun = (inertia * omega[0]).cross(force) + inertia * force.cross(omega[0]);
  return m.orientation * (inertia * torque_rate(m, inertia) - spun);
}

}  // namespace

double excess_of(LeastOf of, const Eigen::Matrix3d& inertia, const ChartPiece<5>& piece, double h) {
  const bool of_jerk = of == LeastOf::jerk;
  const double moment = of == LeastOf::torque ? inertia.norm() : 1.0, power = of_jerk ? h * h * h * h * h : h * h * h;
  const double turn =
      power / moment * (momentum(of, inertia, piece, h, 1.0) - momentum(of, inertia, piece, h, 0.0)).norm();
  if (turn < rounding_of_turns) return 0.0;
  return (of_jerk ? scale_of_jerk_excess : scale_of_excess) * turn * turn * moment * moment / power;
}

std::vector<std::size_t> refined(const std::vector<std::size_t>& counts, const std::vector<double>& excesses,
                                 double energy) {
  const double allowed = excess_share * energy;
  if (!(std::accumulate(excesses.begin(), excesses.end(), 0.0) > allowed)) return {};
  std::vector<std::size_t> more = counts;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (excesses[i] * static_cast<double>(counts.size()) > allowed && counts[i] < most_pieces) more[i] *= 2;
  return more == counts ? std::vector<std::size_t>() : more;
}

}}}  // namespace orispline::families
