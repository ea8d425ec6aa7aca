// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/batch/interpolation.hpp>
#include <orispline/curve/knots.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// Whose squares are summed in this order everywhere.
template <class Vector>
[[nodiscard]] double length_of(const Vector& vector) noexcept {
  double squares = 0.0;
  for (Eigen::Index i = 0; i < vector.size(); ++i) squares += vector[i] * vector[i];
  return std::sqrt(squares);
}

/// Turns a curve into pieces that are polynomials, within a tolerance.
///
/// `Source` is the curve: its `knots()`, `value(segment, t)` as a vector of `components` numbers, `samples(piece,
/// times)` as a player makes them of a `Piece` whose `degree` it states, `store(piece, component, power, coefficient)`,
/// `size_of(vector)` of a difference in its `unit`, `most_offered`, the largest tolerance that an error proposes, and
/// the `verb` of what it says to do less.
template <class Source>
class Baker {
 public:
  using Piece = typename Source::Piece;

  Baker(Source source, double tolerance, std::size_t most_pieces, const Progress& progress)
      : source_(std::move(source)),
        progress_(progress),
        tolerance_(tolerance),
        most_pieces_(most_pieces),
        allowed_(tolerance / reserve) {}

  /// Errors: bad_argument, with the key, where the tolerance is missed or there are no more pieces; cancelled.
  /// Precondition: there is a segment.
  [[nodiscard]] Expected<void> run() {
    const Knots& knots = source_.knots();
    ends_.push_back(knots.front());
    for (std::size_t i = 0; i < knots.segments(); ++i) {
      const bool added = add({i, knots.span(i).start(), knots.span(i).end()});
      if (progress_.stopped()) return cancellation();
      if (!added) break;
      progress_.at(static_cast<double>(i + 1) / static_cast<double>(knots.segments()));
    }
    return keeps_to();
  }

  [[nodiscard]] double largest_difference() const noexcept { return largest_; }
  [[nodiscard]] std::vector<double> take_ends() { return std::move(ends_); }
  [[nodiscard]] std::vector<Piece> take_pieces() { return std::move(pieces_); }

 private:
  static constexpr std::size_t size = static_cast<std::size_t>(Source::degree) + 1;
  static constexpr int most_halvings = 24;
  /// How much smaller than the tolerance differences at the checked times must be.
  static constexpr double reserve = 2.0;
  /// Without some room for it, rounding would miss what is allowed again and again.
  static constexpr double after_a_miss = 1.25;
  /// So many pieces are made at most to find what all of the curve keeps to.
  static constexpr std::size_t pieces_after_a_miss = std::size_t{1} << 16;
  /// More than rounding to four digits takes off.
  static constexpr double rounded_up = 1.001;

  struct Place {
    std::size_t segment;
    double time;
    double off;  ///< from the curve there
  };

  /// Adds the pieces of a segment; false where it is stopped, or there are no more pieces. Where even the shortest one
  /// misses the tolerance, a little more than it reaches is allowed from there on: the error then knows what all of the
  /// curve keeps to.
  [[nodiscard]] bool add(const Subinterval& span, int halvings = 0) {
    if (progress_.stopped()) return false;
    if (pieces_.size() >= most_pieces_) {
      end_of_pieces_ = {span.segment, span.start, allowed_};
      return false;
    }
    const Piece piece = through_curve(span);
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

  [[nodiscard]] Expected<void> keeps_to() const {
    if (first_miss_) return failure(ErrorCode::bad_argument, miss(), {.key = first_miss_->segment});
    if (!end_of_pieces_) return {};
    return failure(ErrorCode::bad_argument,
                   formatted("the {} pieces that are allowed reach to {} s, wanted the end of the curve: ask for a "
                             "larger tolerance, or a curve that {} less there",
                             most_pieces_, end_of_pieces_->time, Source::verb),
                   {.key = end_of_pieces_->segment});
  }

  [[nodiscard]] std::string miss() const {
    const double kept = rounded_up * reserve * allowed_;
    const std::string cure = !end_of_pieces_ && kept <= Source::most_offered
                                 ? formatted("{:.4g} {} or more, which all of the curve keeps to", kept, Source::unit)
                                 : formatted("a much larger tolerance, or a curve that {} less there", Source::verb);
    return formatted("at {} s even the shortest piece reaches {:.4g} {}, wanted {:.4g}: ask for {}", first_miss_->time,
                     rounded_up * reserve * first_miss_->off, Source::unit, tolerance_, cure);
  }

  [[nodiscard]] Piece through_curve(const Subinterval& span) const {
    Piece piece{};
    piece.middle = span.middle();
    piece.per_step = 2.0 / (span.end - span.start);
    const auto series = interpolated<Source::components>(span, nodes_, piece.per_step,
                                                         [&](double t) { return source_.value(span.segment, t); });
    for (std::size_t p = 0; p < size; ++p)
      for (Eigen::Index k = 0; k < Source::components; ++k) Source::store(piece, k, p, series.powers[p][k]);
    return piece;
  }

  /// The largest difference of the piece's samples from the curve at the times that are checked; NaN is kept.
  [[nodiscard]] double difference(const Piece& piece, const Subinterval& span) const {
    std::array<double, size + 1> times;
    for (std::size_t k = 0; k <= size; ++k) times[k] = span.time(checks_[k]);
    const auto samples = source_.samples(piece, times);
    double largest = 0.0;
    for (std::size_t k = 0; k <= size; ++k) {
      const double off = Source::size_of(samples[k] - source_.value(span.segment, times[k]));
      if (!(off <= largest)) largest = off;
    }
    return largest;
  }

  Source source_;
  const Progress& progress_;
  double tolerance_;
  std::size_t most_pieces_;
  double allowed_, largest_ = 0.0;
  std::optional<Place> first_miss_, end_of_pieces_;
  std::array<double, size> nodes_ = chebyshev_nodes<size>();
  /// The extremes of ∏ (s - nodes), both ends among them.
  std::array<double, size + 1> checks_ = cosines<size + 1>(0.0, static_cast<double>(size));
  std::vector<double> ends_;
  std::vector<Piece> pieces_;
};

}}}  // namespace orispline::batch
