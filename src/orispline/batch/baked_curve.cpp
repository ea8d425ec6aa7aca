// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/baked_curve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/batch/baked_sampler.hpp>
#include <orispline/batch/baker.hpp>
#include <orispline/curve/stretched_curve.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using batch::BakedRecord;

/// What a baked curve is made of: its own orientations, and the samples of the pieces as the kernels make them.
template <class T>
class Orientations {
 public:
  using Piece = BakedRecord<T>;
  static constexpr int components = 4, degree = batch::baked_degree<T>;
  static constexpr std::string_view unit = "rad", verb = "turns";
  /// No tolerance is offered from where on nothing of the curve would be left [rad].
  static constexpr double most_offered = 1.0;

  explicit Orientations(const AnyCurve& curve) : curve_(curve) {}

  [[nodiscard]] const Knots& knots() const noexcept { return curve_.knots(); }
  [[nodiscard]] Eigen::Vector4d value(std::size_t segment, double t) const noexcept {
    return curve_.orientation_on(segment, t).coeffs();
  }
  template <std::size_t N>
  [[nodiscard]] std::array<Eigen::Vector4d, N> samples(const Piece& piece, const std::array<double, N>& times) const {
    std::array<T, 4 * N> numbers;
    batch::sample_piece<T>(piece, {.times = times.data(), .start = 0.0, .step = 0.0, .first = 0.0}, N,
                           {.orientation = numbers.data()});
    std::array<Eigen::Vector4d, N> found;
    for (std::size_t k = 0; k < N; ++k)
      for (std::size_t i = 0; i < 4; ++i)
        found[k][static_cast<Eigen::Index>(i)] = static_cast<double>(numbers[4 * k + i]);
    return found;
  }
  static void store(Piece& piece, Eigen::Index component, std::size_t power, double coefficient) noexcept {
    piece.coefficients[component][power] = static_cast<T>(coefficient);
  }
  [[nodiscard]] static double size_of(const Eigen::Vector4d& off) noexcept { return 2.0 * batch::length_of(off); }

 private:
  const AnyCurve& curve_;
};

template <class T>
BakedRecord<T> constant_piece(const AnyCurve& curve) {
  BakedRecord<T> piece{.coefficients = {}, .middle = curve.domain().start, .per_step = 0.0};
  const Eigen::Quaterniond q = curve(curve.domain().start);
  for (Eigen::Index k = 0; k < 4; ++k) piece.coefficients[k][0] = static_cast<T>(q.coeffs()[k]);
  return piece;
}

bool finite(double number) { return std::isfinite(number); }

template <class T>
bool has_finite_numbers(const BakedRecord<T>& piece) {
  return finite(piece.middle) && finite(piece.per_step) &&
         std::ranges::all_of(piece.coefficients, [](const auto& row) { return std::ranges::all_of(row, finite); });
}

/// The value of a polynomial.
template <class Row>
double value_at(const Row& row, double s) {
  return std::accumulate(std::rbegin(row), std::rend(row), 0.0,
                         [s](double sum, auto c) { return sum * s + static_cast<double>(c); });
}

/// At most so steep are polynomials on [-farthest, farthest].
template <class Row>
double steepest(const Row& row, double farthest) {
  double slope = 0.0;
  for (std::size_t k = std::size(row); --k > 0;)
    slope = slope * farthest + static_cast<double>(k) * std::abs(static_cast<double>(row[k]));
  return slope;
}

/// Whether its norm is far from 0 from place to place: in the middle of a part it is larger than what it may change by
/// on the way to the ends of the part. Pieces of baked curves need a handful of parts.
template <class T>
bool has_norm_on(const BakedRecord<T>& piece, double first, double last) {
  constexpr double least = 1e-6;
  constexpr int most_parts = 1024;
  const auto norm = [&](const auto& component) {
    double square = 0.0;
    for (const auto& row : piece.coefficients) {
      const double value = component(row);
      square += value * value;
    }
    return std::sqrt(square);
  };
  const double farthest = std::max(std::abs(first), std::abs(last));
  const double slope = norm([&](const auto& row) { return steepest(row, farthest); });
  std::vector<std::pair<double, double>> open{std::minmax({first, last})};
  for (int parts = 0; !open.empty(); ++parts) {
    const auto [from, to] = open.back();
    open.pop_back();
    const double middle = std::midpoint(from, to);
    const double here = norm([&](const auto& row) { return value_at(row, middle); });
    if (here - slope * (to - middle) >= least) continue;
    if (!(here >= least) || parts == most_parts) return false;
    open.insert(open.end(), {{from, middle}, {middle, to}});
  }
  return true;
}

/// Whether its orientations and their rates are finite from `start` to `end`, by limits that no baked curve comes near:
/// components of about 1 have far smaller coefficients, and rounding takes places no farther than this beyond [-1, 1].
template <class T>
bool is_sound(const BakedRecord<T>& piece, double start, double end) {
  constexpr double farthest_place = 2.0, largest_sum = 1e9, largest_per_step = 1e30;
  const double first = (start - piece.middle) * piece.per_step, last = (end - piece.middle) * piece.per_step;
  if (!(std::max(std::abs(first), std::abs(last)) <= farthest_place)) return false;
  if (!(std::abs(piece.per_step) <= largest_per_step)) return false;
  const auto sum_of_sizes = [](const auto& row) {
    return std::accumulate(std::begin(row), std::end(row), 0.0,
                           [](double sum, T c) { return sum + std::abs(static_cast<double>(c)); });
  };
  if (std::ranges::any_of(piece.coefficients, [&](const auto& row) { return !(sum_of_sizes(row) <= largest_sum); }))
    return false;
  return has_norm_on(piece, first, last);
}

/// Error (bad_argument): the first gap or jump, which no polynomial bridges.
Expected<void> check_without_gaps(const AnyCurve& curve) {
  for (std::size_t i = 0; i < curve.knots().segments(); ++i) {
    if (!is_gap(curve, i)) continue;
    const KnotSpan span = curve.knots().span(i);
    const std::string found = span.step() > 0.0 ? formatted("a gap from {} to {} s", span.start(), span.end())
                                                : formatted("a jump of the motion at {} s", span.start());
    return failure(ErrorCode::bad_argument, formatted("found {}, wanted one curve without a break", found));
  }
  return {};
}

}  // namespace

template <class T>
Expected<BakedCurve<T>> bake(const AnyCurve& curve, double tolerance, const BakeOptions& options,
                             const Progress& progress) {
  if (!(tolerance >= least_bake_tolerance<T>) || !std::isfinite(tolerance))
    return failure(ErrorCode::bad_argument, formatted("the tolerance is {} rad, wanted a number from {} on", tolerance,
                                                      least_bake_tolerance<T>));
  if (auto checked = check_without_gaps(curve); !checked) return tl::unexpected(std::move(checked.error()));
  const Knots& knots = curve.knots();
  if (knots.segments() == 0) {
    progress.at(1.0);
    return BakedCurve<T>(knots, {constant_piece<T>(curve)}, 0.0);
  }
  batch::Baker baker(Orientations<T>(curve), tolerance, options.max_pieces, progress);
  return baker.run().map(
      [&] { return BakedCurve<T>(Knots(baker.take_ends()), baker.take_pieces(), baker.largest_difference()); });
}

template <class T>
Expected<BakedCurve<T>> bake(const Method& method, const Keyframes& keys, double tolerance, const BakeOptions& options,
                             const Progress& progress) {
  return make_curve(method, keys).and_then([&](const AnyCurve& curve) {
    return bake<T>(curve, tolerance, options, progress);
  });
}

template <class T>
Expected<BakedCurve<T>> BakedCurve<T>::restored(std::vector<double> ends, std::vector<batch::BakedRecord<T>> pieces,
                                                double largest_difference) {
  if (ends.empty() || !std::ranges::all_of(ends, finite) ||
      std::ranges::adjacent_find(ends, std::ranges::greater_equal()) != ends.end())
    return failure(ErrorCode::bad_data, "found ends of pieces that do not increase, wanted those of a baked curve");
  const std::size_t wanted = std::max<std::size_t>(ends.size(), 2) - 1;
  if (pieces.size() != wanted)
    return failure(ErrorCode::bad_data, formatted("found {} pieces, wanted {}", pieces.size(), wanted));
  if (!finite(largest_difference) || !std::ranges::all_of(pieces, &has_finite_numbers<T>))
    return failure(ErrorCode::bad_data, "found numbers that are not finite, wanted those of a baked curve");
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (const double start = ends[i], end = ends[std::min(i + 1, ends.size() - 1)]; !is_sound(pieces[i], start, end))
      return failure(ErrorCode::bad_data,
                     formatted("the piece from {} to {} s: found no orientations on all of it, wanted those of a "
                               "baked curve",
                               start, end));
  return BakedCurve(Knots(std::move(ends)), std::move(pieces), largest_difference);
}

template <class T>
Eigen::Quaternion<T> BakedCurve<T>::operator()(double t) const noexcept {
  Eigen::Quaternion<T> q;
  const auto sampled = sample_at<T>(*this, {&t, 1}, {.orientations = {q.coeffs().data(), 4}});
  ORISPLINE_EXPECT(sampled.has_value());
  return q;
}

template class BakedCurve<double>;
template class BakedCurve<float>;
template Expected<BakedCurve<double>> bake<double>(const AnyCurve&, double, const BakeOptions&, const Progress&);
template Expected<BakedCurve<float>> bake<float>(const AnyCurve&, double, const BakeOptions&, const Progress&);
template Expected<BakedCurve<double>> bake<double>(const Method&, const Keyframes&, double, const BakeOptions&,
                                                   const Progress&);
template Expected<BakedCurve<float>> bake<float>(const Method&, const Keyframes&, double, const BakeOptions&,
                                                 const Progress&);

}}  // namespace orispline
