// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/rational.hpp>

#include <algorithm>

#include <Eigen/LU>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/rate_chain.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

using Eigen::Vector4d;

/// A derivative at a key, by those at the two ends: own + by_first · ṡ₀ + by_last · ṡ_n.
struct Derivative {
  Vector4d own = Vector4d::Zero();
  double by_first = 0.0, by_last = 0.0;

  /// Seen from the other end.
  [[nodiscard]] Derivative reversed() const { return {own, by_last, by_first}; }

  friend Derivative operator+(const Derivative& a, const Derivative& b) {
    return {a.own + b.own, a.by_first + b.by_first, a.by_last + b.by_last};
  }
  friend Derivative operator*(double f, const Derivative& a) { return {f * a.own, f * a.by_first, f * a.by_last}; }
};

/// The C2 cubic spline of R⁴ through the joints, as yet without a rule for its ends.
class Spline {
 public:
  Spline(const Knots& knots, std::span<const Eigen::Quaterniond> joints) : knots_(knots) {
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) chords_.push_back(joints[i + 1].coeffs() - joints[i].coeffs());
    eliminate();
  }

  [[nodiscard]] std::size_t last() const { return chords_.size(); }
  [[nodiscard]] double step(std::size_t i) const { return knots_.span(i).step(); }
  [[nodiscard]] Vector4d secant(std::size_t i) const { return chords_[i] / step(i); }
  [[nodiscard]] const Vector4d& chord(std::size_t i) const { return chords_[i]; }
  [[nodiscard]] const Derivative& derivative(std::size_t i) const { return derivatives_[i]; }

  /// The share of the step after a key that the derivative before it has in the equation at the key, between a segment
  /// and the next: share ṡ⁻ + 2 ṡ + (1 - share) ṡ⁺ = 3 (share · secant + (1 - share) · next secant).
  [[nodiscard]] double share(std::size_t segment, std::size_t next) const {
    return step(next) / (step(segment) + step(next));
  }

 private:
  /// Gauss's elimination of the tridiagonal equations at the inner keys, which are diagonally dominant.
  void eliminate() {
    const std::size_t n = last();
    derivatives_.resize(n + 1);
    derivatives_[0].by_first = derivatives_[n].by_last = 1.0;
    std::vector<double> above(n, 0.0);
    for (std::size_t i = 1; i < n; ++i) {
      const double before = share(i - 1, i), after = 1.0 - before, pivot = 1.0 / (2.0 - before * above[i - 1]);
      const Derivative wanted{3.0 * (before * secant(i - 1) + after * secant(i)), 0.0, 0.0};
      derivatives_[i] = pivot * (wanted + -before * derivatives_[i - 1]);
      above[i] = pivot * after;
    }
    for (std::size_t i = n; i-- > 1;) derivatives_[i] = derivatives_[i] + -above[i] * derivatives_[i + 1];
  }

  const Knots& knots_;
  std::vector<Vector4d> chords_;
  std::vector<Derivative> derivatives_;
};

/// The derivatives at the two ends.
struct EndDerivatives {
  Vector4d first, last;
};

/// The one of a loop, which is `sign` times itself after a period.
EndDerivatives around(const Spline& s, double sign) {
  const std::size_t n = s.last();
  const double before = s.share(n - 1, 0), after = 1.0 - before;
  const Derivative sum = before * sign * s.derivative(n - 1) + after * s.derivative(1);
  const Vector4d wanted = 3.0 * (before * sign * s.secant(n - 1) + after * s.secant(0));
  const Vector4d first = (wanted - sum.own) / (2.0 + sum.by_first + sign * sum.by_last);
  return {first, sign * first};
}

/// The four equations of an end in the derivatives of both: `here` of its own, `there` of the other one.
struct EndEquations {
  Eigen::Matrix4d here, there;
  Vector4d wanted;
};

/// No end changes |s|. A given rate says the rest; else nothing of s̈ is beside the key, so that α = 0. `next` is the
/// derivative at the next key, this end's own derivative taken for the first.
EndEquations end_equations(const End& end, const Eigen::Quaterniond& key, const Derivative& next,
                           const Vector4d& secant) {
  const Vector4d& k = key.coeffs();
  const Eigen::Matrix4d radial = k * k.transpose(), beside = Eigen::Matrix4d::Identity() - radial;
  if (end.rule == EndRule::natural)
    return {(2.0 + next.by_first) * beside + radial, next.by_last * beside, beside * (3.0 * secant - next.own)};
  const Eigen::Vector3d half = 0.5 * end.angular_velocity;
  return {Eigen::Matrix4d::Identity(), Eigen::Matrix4d::Zero(),
          (key * Eigen::Quaterniond(0.0, half.x(), half.y(), half.z())).coeffs()};
}

EndDerivatives open_ends(const Spline& s, std::span<const Eigen::Quaterniond> joints, const FamilySettings& settings) {
  const std::size_t n = s.last();
  const auto start = end_equations(settings.start, joints[0], s.derivative(1), s.secant(0));
  const auto end = end_equations(settings.end, joints[n], s.derivative(n - 1).reversed(), s.secant(n - 1));
  Eigen::Matrix<double, 8, 8> both;
  both << start.here, start.there, end.there, end.here;
  Eigen::Matrix<double, 8, 1> wanted;
  wanted << start.wanted, end.wanted;
  const Eigen::Matrix<double, 8, 1> found = both.partialPivLu().solve(wanted);
  return {found.head<4>(), found.tail<4>()};
}

std::vector<RationalPiece> pieces_of(const Spline& s, std::span<const Eigen::Quaterniond> joints,
                                     const EndDerivatives& ends) {
  std::vector<RationalPiece> pieces;
  pieces.reserve(s.last());
  const auto derivative = [&](std::size_t i) -> Vector4d {
    const Derivative& d = s.derivative(i);
    return d.own + d.by_first * ends.first + d.by_last * ends.last;
  };
  Vector4d leaving = derivative(0);
  for (std::size_t i = 0; i < s.last(); ++i) {
    const Vector4d arriving = derivative(i + 1);
    const double third = s.step(i) / 3.0;
    const Vector4d first = third * leaving, last = third * arriving;
    pieces.push_back({joints[i].coeffs(), joints[i + 1].coeffs(), {first, s.chord(i) - first - last, last}});
    leaving = arriving;
  }
  return pieces;
}

using Controls = std::array<Vector4d, 4>;

/// |s| on a part of a cubic is at least this: the part lies in the hull of its control points.
double bound_of_norm(const Controls& c) {
  const Vector4d along = (c[0] + c[3]).stableNormalized();
  return std::min({c[0].dot(along), c[1].dot(along), c[2].dot(along), c[3].dot(along)});
}

/// The halves of a cubic, by de Casteljau's algorithm.
std::pair<Controls, Controls> halves(const Controls& c) {
  const Vector4d a = 0.5 * (c[0] + c[1]), b = 0.5 * (c[1] + c[2]), d = 0.5 * (c[2] + c[3]);
  const Vector4d ab = 0.5 * (a + b), bd = 0.5 * (b + d), middle = 0.5 * (ab + bd);
  return {{c[0], a, ab, middle}, {middle, bd, d, c[3]}};
}

/// A value of |s| below the least norm, or nothing where a bound on every part of the cubic is above it.
std::optional<double> vanishing_norm(const Controls& c, int halvings = 0) {
  constexpr int most_halvings = 200;  // of control points 1e36 away, the largest that rates and steps admit
  if (bound_of_norm(c) >= Rational::least_norm) return std::nullopt;
  const auto [left, right] = halves(c);
  const double norm = right[0].norm();
  if (!(norm >= Rational::least_norm) || halvings == most_halvings) return norm;
  const auto found = vanishing_norm(left, halvings + 1);
  return found ? found : vanishing_norm(right, halvings + 1);
}

Error too_near_to_zero(std::size_t segment, double norm) {
  return {
      ErrorCode::not_converged,
      formatted("{} has no curve through these keys: on the way to the next key the spline of the quaternions comes "
                "within {:.2g} of 0, wanted {:g} at least; put keys in between, or take a local method such as auto",
                Rational::info.name, norm, Rational::least_norm),
      {.key = segment}};
}

}  // namespace

Expected<RationalCurve> Rational::curve(const Keyframes& keys, const FamilySettings& settings) {
  Knots knots = four_key_knots(keys, settings);
  const std::vector<Eigen::Quaterniond> joints = joint_orientations(keys, settings);
  const Spline spline(knots, joints);
  const EndDerivatives outer =
      settings.closure ? around(spline, settings.closure->sign) : open_ends(spline, joints, settings);
  std::vector<RationalPiece> pieces = pieces_of(spline, joints, outer);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (const auto norm = vanishing_norm(pieces[i].controls())) return tl::unexpected(too_near_to_zero(i, *norm));
  return RationalCurve(std::move(knots), std::move(pieces));
}

Expected<HermitePath<3>> Rational::path(const Keyframes& keys, const FamilySettings& settings) {
  return cubic_spline_path(info.name, keys, settings);
}

}}}  // namespace orispline::families
