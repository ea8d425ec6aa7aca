// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/baked_curve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/batch/baked_sampler.hpp>
#include <orispline/batch/interpolation.hpp>
#include <orispline/curve/stretched_curve.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using batch::BakedRecord;
using batch::Subinterval;

constexpr int most_halvings = 24;
/// How much smaller than the tolerance differences at the checked times must be.
constexpr double reserve = 2.0;

template <class T>
class Baker {
 public:
  Baker(const AnyCurve& curve, double tolerance, const BakeOptions& options, const Progress& progress)
      : curve_(curve), progress_(progress), most_pieces_(options.max_pieces), allowed_(tolerance / reserve) {
    ends_.push_back(curve.knots().front());
  }

  /// Adds the pieces of a segment; false where it is stopped, or there are no more pieces. Where even the shortest one
  /// misses the tolerance, a little more than it reaches is allowed from there on: the error then knows what all of the
  /// curve keeps to.
  [[nodiscard]] bool add(const Subinterval& span, int halvings = 0) {
    if (progress_.stopped()) return false;
    if (pieces_.size() >= most_pieces_) {
      end_of_pieces_ = {span.segment, span.start, allowed_};
      return false;
    }
    const BakedRecord<T> piece = through_curve(span);
    const double off = difference(piece, span), middle = span.middle();
    if (!(off <= allowed_)) {
      if (halvings < most_halvings && span.start < middle && middle < span.end)
        return add({span.segment, span.start, middle}, halvings + 1) &&
               add({span.segment, middle, span.end}, halvings + 1);
      if (!first_miss_) {
        first_miss_ = {span.segment, middle, off};
        most_pieces_ = std::min(most_pieces_, pieces_.size() + pieces_after_a_miss);
      }
      allowed_ = after_a_miss * off;
      if (!std::isfinite(off)) return false;
    }
    pieces_.push_back(piece);
    ends_.push_back(span.end);
    largest_ = std::max(largest_, off);
    return true;
  }

  /// Error (bad_argument, with the key): the tolerance was missed, or there were no more pieces.
  [[nodiscard]] Expected<void> keeps_to(double tolerance) const {
    if (first_miss_) return failure(ErrorCode::bad_argument, miss(tolerance), {.key = first_miss_->segment});
    if (!end_of_pieces_) return {};
    return failure(ErrorCode::bad_argument,
                   formatted("the {} pieces that are allowed reach to {} s, wanted the end of the curve: ask for a "
                             "larger tolerance, or a curve that turns less there",
                             most_pieces_, end_of_pieces_->time),
                   {.key = end_of_pieces_->segment});
  }
  [[nodiscard]] double largest_difference() const noexcept { return largest_; }
  [[nodiscard]] std::vector<double> take_ends() { return std::move(ends_); }
  [[nodiscard]] std::vector<BakedRecord<T>> take_pieces() { return std::move(pieces_); }

 private:
  static constexpr std::size_t size = batch::baked_degree<T> + 1;
  /// Without some room for it, rounding would miss what is allowed again and again.
  static constexpr double after_a_miss = 1.25;
  /// So many pieces are made at most to find what all of the curve keeps to.
  static constexpr std::size_t pieces_after_a_miss = std::size_t{1} << 16;
  /// No tolerance is offered from where on nothing of the curve would be left [rad].
  static constexpr double most_offered = 1.0;
  /// More than rounding to four digits takes off.
  static constexpr double rounded_up = 1.001;

  struct Place {
    std::size_t segment;
    double time;
    double off;  ///< from the curve there [rad]
  };

  [[nodiscard]] std::string miss(double tolerance) const {
    const double kept = rounded_up * reserve * allowed_;
    const std::string cure = !end_of_pieces_ && kept <= most_offered
                                 ? formatted("{:.4g} rad or more, which all of the curve keeps to", kept)
                                 : "a much larger tolerance, or a curve that turns less there";
    return formatted("at {} s even the shortest piece reaches {:.4g} rad, wanted {:.4g}: ask for {}", first_miss_->time,
                     rounded_up * reserve * first_miss_->off, tolerance, cure);
  }

  [[nodiscard]] BakedRecord<T> through_curve(const Subinterval& span) const {
    BakedRecord<T> piece{.coefficients = {}, .middle = span.middle(), .per_step = 2.0 / (span.end - span.start)};
    const auto series = batch::interpolated<4>(
        span, nodes_, piece.per_step, [&](double t) { return curve_.orientation_on(span.segment, t).coeffs(); });
    for (std::size_t p = 0; p < size; ++p)
      for (Eigen::Index k = 0; k < 4; ++k) piece.coefficients[k][p] = static_cast<T>(series.powers[p][k]);
    return piece;
  }

  /// The largest difference of the piece's samples from the curve at the times that are checked [rad]; NaN is kept.
  [[nodiscard]] double difference(const BakedRecord<T>& piece, const Subinterval& span) const {
    std::array<double, size + 1> times;
    for (std::size_t k = 0; k <= size; ++k) times[k] = span.time(checks_[k]);
    std::array<T, 4 * (size + 1)> samples;
    batch::sample_piece<T>(piece, {.times = times.data(), .start = 0.0, .step = 0.0, .first = 0.0}, times.size(),
                           {.orientation = samples.data()});
    double largest = 0.0;
    for (std::size_t k = 0; k <= size; ++k) {
      const Eigen::Quaterniond q = curve_.orientation_on(span.segment, times[k]);
      double squares = 0.0;  // summed in this order everywhere
      for (std::size_t i = 0; i < 4; ++i) {
        const double off = static_cast<double>(samples[4 * k + i]) - q.coeffs()[static_cast<Eigen::Index>(i)];
        squares += off * off;
      }
      const double off = 2.0 * std::sqrt(squares);
      if (!(off <= largest)) largest = off;
    }
    return largest;
  }

  const AnyCurve& curve_;
  const Progress& progress_;
  std::size_t most_pieces_;
  double allowed_, largest_ = 0.0;
  std::optional<Place> first_miss_, end_of_pieces_;
  std::array<double, size> nodes_ = batch::chebyshev_nodes<size>();
  /// The extremes of ∏ (s - nodes), both ends among them.
  std::array<double, size + 1> checks_ = batch::cosines<size + 1>(0.0, static_cast<double>(size));
  std::vector<double> ends_;
  std::vector<BakedRecord<T>> pieces_;
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
  Baker<T> baker(curve, tolerance, options, progress);
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const bool added = baker.add({i, knots.span(i).start(), knots.span(i).end()});
    if (progress.stopped()) return cancellation();
    if (!added) break;
    progress.at(static_cast<double>(i + 1) / static_cast<double>(knots.segments()));
  }
  return baker.keeps_to(tolerance).map(
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
