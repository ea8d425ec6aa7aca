// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/baked_path.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <orispline/batch/baker.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using PathPiece = BakedPath::Piece;

/// Where a piece is at a time on it. By itself: GCC 12 would take coefficients of which it sees how they were made as
/// if they had not been rounded to `float`.
[[gnu::noinline]] Eigen::Vector3d place_on(const PathPiece& piece, double t) noexcept {
  const double s = (t - piece.middle) * piece.per_step;
  Eigen::Vector3d place;
  for (Eigen::Index k = 0; k < 3; ++k) {
    double sum = 0.0;
    for (std::size_t p = BakedPath::degree; p-- > 0;) sum = (sum + static_cast<double>(piece.others[k][p])) * s;
    place[k] = piece.first[k] + sum;
  }
  return place;
}

/// What a baked path is made of.
class Positions {
 public:
  using Piece = PathPiece;
  static constexpr int components = 3, degree = BakedPath::degree;
  static constexpr std::string_view unit = "m", verb = "moves";
  static constexpr double most_offered = std::numeric_limits<double>::max();

  explicit Positions(const AnyPath& path) : path_(path) {}

  [[nodiscard]] const Knots& knots() const noexcept { return path_.knots(); }
  [[nodiscard]] Eigen::Vector3d value(std::size_t segment, double t) const noexcept {
    return path_.position_on(segment, t);
  }
  template <std::size_t N>
  [[nodiscard]] static std::array<Eigen::Vector3d, N> samples(const Piece& piece, const std::array<double, N>& times) {
    std::array<Eigen::Vector3d, N> places;
    std::ranges::transform(times, places.begin(), [&](double t) { return place_on(piece, t); });
    return places;
  }
  static void store(Piece& piece, Eigen::Index component, std::size_t power, double coefficient) noexcept {
    if (power == 0) piece.first[component] = coefficient;
    else piece.others[component][power - 1] = static_cast<float>(coefficient);
  }
  [[nodiscard]] static double size_of(const Eigen::Vector3d& off) noexcept { return batch::length_of(off); }

 private:
  const AnyPath& path_;
};

}  // namespace

Expected<BakedPath> bake_path(const AnyPath& path, double tolerance, const BakeOptions& options,
                              const Progress& progress) {
  if (!(tolerance > 0.0) || !std::isfinite(tolerance))
    return failure(ErrorCode::bad_argument, formatted("the tolerance is {} m, wanted a number above 0", tolerance));
  const Knots& knots = path.knots();
  if (knots.segments() == 0) {
    progress.at(1.0);
    PathPiece piece{};
    const Eigen::Vector3d position = path.linear_motion(knots.front()).position;
    for (Eigen::Index k = 0; k < 3; ++k) piece.first[k] = position[k];
    return BakedPath(knots, {piece}, 0.0);
  }
  batch::Baker baker(Positions(path), tolerance, options.max_pieces, progress);
  return baker.run().map(
      [&] { return BakedPath(Knots(baker.take_ends()), baker.take_pieces(), baker.largest_difference()); });
}

Eigen::Vector3d BakedPath::operator()(double t) const noexcept {
  const double held = std::isnan(t) ? t : std::clamp(t, knots_.front(), knots_.back());
  return place_on(pieces_[pieces_.size() == 1 ? 0 : knots_.segment_at(held)], held);
}

}}  // namespace orispline
