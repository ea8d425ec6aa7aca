// SPDX-License-Identifier: Apache-2.0
#include <orispline/mean/smallest_ball.hpp>

#include <algorithm>
#include <vector>

#include <Eigen/QR>

#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace mean_of {

namespace {

using Point = Eigen::Vector4d;

/// A point of the hull of some points, and its shares of them.
struct Corral {
  std::vector<Point> corners{};
  std::vector<double> shares{};

  [[nodiscard]] Point point() const {
    Point sum = Point::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) sum += shares[i] * corners[i];
    return sum;
  }

  /// The shares of the point nearest to 0 of the plane through the corners.
  [[nodiscard]] Eigen::VectorXd nearest_of_plane() const {
    const auto count = static_cast<Eigen::Index>(corners.size());
    Eigen::MatrixXd products(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        products(i, j) = 1.0 + corners[static_cast<std::size_t>(i)].dot(corners[static_cast<std::size_t>(j)]);
    const Eigen::VectorXd found = products.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(count));
    return found / found.sum();
  }

  /// Goes to that point, or to the edge of the hull on the way and without its corner there; whether it is there.
  bool go_towards(const Eigen::VectorXd& wanted) {
    double part = 1.0;
    for (std::size_t i = 0; i < shares.size(); ++i)
      if (const double there = wanted[static_cast<Eigen::Index>(i)]; there < 0.0)
        part = std::min(part, shares[i] / (shares[i] - there));
    for (std::size_t i = 0; i < shares.size(); ++i)
      shares[i] += part * (wanted[static_cast<Eigen::Index>(i)] - shares[i]);
    if (part == 1.0) return true;
    const auto least = std::ranges::min_element(shares) - shares.begin();
    corners.erase(corners.begin() + least);
    shares.erase(shares.begin() + least);
    if (corners.size() > 1) return false;
    shares.front() = 1.0;
    return true;
  }
};

/// The direction of the point nearest to 0 of the hull of these unit vectors.
Point centre_of(const std::vector<Point>& points) {
  constexpr int enough = 200;  // rounds; each has another corral, of which a few do
  constexpr double rounding = 1e-15;
  Corral corral{{points.front()}, {1.0}};
  for (int round = 0; round < enough; ++round) {
    const Point here = corral.point();
    const auto farthest = std::ranges::min_element(points, {}, [&](const Point& p) { return p.dot(here); });
    if (farthest->dot(here) >= here.squaredNorm() - rounding) break;
    if (std::ranges::find(corral.corners, *farthest) != corral.corners.end()) break;
    corral.corners.push_back(*farthest);
    corral.shares.push_back(0.0);
    while (!corral.go_towards(corral.nearest_of_plane())) {
    }
  }
  const Point found = corral.point();
  return found.norm() > 0.0 ? Point(found.normalized()) : points.front();
}

}  // namespace

Ball ball_round(const Eigen::Quaterniond& centre, std::span<const Eigen::Quaterniond> orientations) {
  constexpr double rounding = 1e-15;
  Ball ball{centre, 0.0};
  double least = 1.0;
  for (const Eigen::Quaterniond& q : orientations) least = std::min(least, std::abs(q.dot(centre)));
  for (const Eigen::Quaterniond& q : orientations)
    if (std::abs(q.dot(centre)) <= least + rounding) ball.radius = std::max(ball.radius, angular_distance(centre, q));
  return ball;
}

Ball smallest_ball(std::span<const Eigen::Quaterniond> orientations) {
  std::vector<Point> points;
  points.reserve(orientations.size());
  for (const Eigen::Quaterniond& q : orientations)
    points.push_back(q.dot(orientations.front()) < 0.0 ? -q.coeffs() : q.coeffs());
  return ball_round(Eigen::Quaterniond(centre_of(points)), orientations);
}

}}}  // namespace orispline::mean_of
