// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/baked_curve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include <orispline/base/formatted.hpp>
#include <orispline/batch/baked_sampler.hpp>
#include <orispline/batch/interpolation.hpp>
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
      : curve_(curve), options_(options), progress_(progress), allowed_(tolerance / reserve) {
    ends_.push_back(curve.knots().front());
  }

  /// Adds the pieces of a segment; false where it is stopped, or for what failure() then says.
  [[nodiscard]] bool add(const Subinterval& span, int halvings = 0) {
    if (progress_.stopped()) return false;
    if (pieces_.size() >= options_.max_pieces) {
      failure_ = formatted(
          "the {} pieces that are allowed (max_pieces) reach to {} s, wanted a larger tolerance, or "
          "more pieces",
          options_.max_pieces, span.start);
      return false;
    }
    const BakedRecord<T> piece = through_curve(span);
    const double off = difference(piece, span);
    if (off <= allowed_) {
      pieces_.push_back(piece);
      ends_.push_back(span.end);
      largest_ = std::max(largest_, off);
      return true;
    }
    const double middle = span.middle();
    if (halvings == most_halvings || middle <= span.start || middle >= span.end) {
      failure_ =
          formatted("at {} s even the shortest piece reaches {:.4g} rad, wanted {:.4g}: ask for a larger tolerance",
                    middle, reserve * off, reserve * allowed_);
      return false;
    }
    return add({span.segment, span.start, middle}, halvings + 1) && add({span.segment, middle, span.end}, halvings + 1);
  }

  [[nodiscard]] const std::string& failure() const noexcept { return failure_; }
  [[nodiscard]] double largest_difference() const noexcept { return largest_; }
  [[nodiscard]] std::vector<double> take_ends() { return std::move(ends_); }
  [[nodiscard]] std::vector<BakedRecord<T>> take_pieces() { return std::move(pieces_); }

 private:
  static constexpr std::size_t size = batch::baked_degree<T> + 1;

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
  const BakeOptions& options_;
  const Progress& progress_;
  double allowed_, largest_ = 0.0;
  std::string failure_;
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

}  // namespace

template <class T>
Expected<BakedCurve<T>> bake(const AnyCurve& curve, double tolerance, const BakeOptions& options,
                             const Progress& progress) {
  if (!(tolerance >= least_bake_tolerance<T>) || !std::isfinite(tolerance))
    return failure(ErrorCode::bad_argument, formatted("the tolerance is {} rad, wanted a number from {} on", tolerance,
                                                      least_bake_tolerance<T>));
  const Knots& knots = curve.knots();
  if (knots.segments() == 0) {
    progress.at(1.0);
    return BakedCurve<T>(knots, {constant_piece<T>(curve)}, 0.0);
  }
  Baker<T> baker(curve, tolerance, options, progress);
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const bool added = baker.add({i, knots.span(i).start(), knots.span(i).end()});
    if (progress.stopped()) return cancellation();
    if (!added) return failure(ErrorCode::bad_argument, baker.failure(), {.key = i});
    progress.at(static_cast<double>(i + 1) / static_cast<double>(knots.segments()));
  }
  return BakedCurve<T>(Knots(baker.take_ends()), baker.take_pieces(), baker.largest_difference());
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
  const auto is_finite = [](auto number) { return std::isfinite(number); };
  const auto is_sound = [&](const BakedRecord<T>& piece) {
    return is_finite(piece.middle) && is_finite(piece.per_step) &&
           std::ranges::all_of(piece.coefficients,
                               [&](const auto& row) { return std::ranges::all_of(row, is_finite); });
  };
  if (ends.empty() || !std::ranges::all_of(ends, is_finite) ||
      std::ranges::adjacent_find(ends, std::ranges::greater_equal()) != ends.end())
    return failure(ErrorCode::bad_data, "found ends of pieces that do not increase, wanted those of a baked curve");
  const std::size_t wanted = std::max<std::size_t>(ends.size(), 2) - 1;
  if (pieces.size() != wanted)
    return failure(ErrorCode::bad_data, formatted("found {} pieces, wanted {}", pieces.size(), wanted));
  if (!is_finite(largest_difference) || !std::ranges::all_of(pieces, is_sound))
    return failure(ErrorCode::bad_data, "found numbers that are not finite, wanted those of a baked curve");
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
