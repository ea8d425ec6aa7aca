// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/even_path.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// How a curve of one kind moves at a time.
struct Going {
  Eigen::Vector3d rate, acceleration;
};

Going going(const AnyCurve& curve, std::size_t segment, double t) {
  const Motion m = curve.motion_on(segment, t);
  return {m.angular_velocity, m.angular_acceleration};
}
Going going(const AnyPath& path, std::size_t segment, double t) {
  const LinearMotion m = path.linear_motion_on(segment, t);
  return {m.velocity, m.acceleration};
}

constexpr double shortest_of(const AnyCurve&) { return rest_angle; }
constexpr double shortest_of(const AnyPath&) { return rest_length; }

/// Of two kinds of motion the one that goes on evenly, and an option for the other.
struct Words {
  std::string_view option, moves, other_moves, other_option;
};
constexpr Words words_of(const AnyCurve&) { return {"constant_rate", "turns", "shifts", "constant_speed"}; }
constexpr Words words_of(const AnyPath&) { return {"constant_speed", "shifts", "turns", "constant_rate"}; }

/// How far the other kind of motion goes from one end of a segment to the other, in what is too short to count.
double other_move(const AnyCurve&, const PoseCurve& pose, const KnotSpan& span) {
  if (!pose.position) return 0.0;
  return (pose.position->linear_motion(span.end()).position - pose.position->linear_motion(span.start()).position)
             .norm() /
         rest_length;
}
double other_move(const AnyPath&, const PoseCurve& pose, const KnotSpan& span) {
  return increment(pose.orientation(span.start()), pose.orientation(span.end())).norm() / rest_angle;
}

/// Where a curve of one kind turns back.
template <class C>
class Turns {
 public:
  Turns(const C& curve, double sharp_bend) : curve_(curve), sharp_bend_(std::max(sharp_bend, shortest_of(curve))) {}

  /// At a time of one segment, or where two of them meet.
  [[nodiscard]] bool is_back(std::size_t left, std::size_t right, double t) const {
    const Going before = going(curve_, left, t), after = going(curve_, right, t);
    const double speed = std::max(before.rate.norm(), after.rate.norm());
    const double acceleration = std::max(before.acceleration.norm(), after.acceleration.norm());
    if (speed * speed > acceleration * sharp_bend_) return false;
    const KnotSpan first = curve_.knots().span(left), last = curve_.knots().span(right);
    const double nearby = acceleration > 0.0 ? std::sqrt(sharp_bend_ / acceleration) : near_by * first.step();
    const Eigen::Vector3d in = going(curve_, left, std::max(first.start(), t - nearby)).rate;
    const Eigen::Vector3d out = going(curve_, right, std::min(last.end(), t + nearby)).rate;
    return in.dot(out) < least_cosine * in.norm() * out.norm();
  }

  /// Inside a segment, in order [s].
  [[nodiscard]] std::vector<double> inside(std::size_t segment) const {
    std::vector<double> times;
    const KnotSpan span = curve_.knots().span(segment);
    const auto slope = [&](double t) {  // half that of |rate|²
      const Going g = going(curve_, segment, t);
      return g.rate.dot(g.acceleration);
    };
    double start = span.start(), before = slope(start);
    for (int k = 1; k <= places; ++k) {
      const double end = std::lerp(span.start(), span.end(), static_cast<double>(k) / places), after = slope(end);
      if (before < 0.0 && after > 0.0)
        if (const double t = between(slope, start, end); is_back(segment, segment, t)) times.push_back(t);
      start = end;
      before = after;
    }
    return times;
  }

  /// Whether the direction jumps where two segments meet, though neither stops there.
  [[nodiscard]] bool is_corner(std::size_t left, std::size_t right, double t) const {
    const Eigen::Vector3d in = going(curve_, left, t).rate, out = going(curve_, right, t).rate;
    return in.norm() > 0.0 && out.norm() > 0.0 && (in.normalized() - out.normalized()).norm() > sharpest_corner;
  }

 private:
  static constexpr int places = 16;
  static constexpr double near_by = 1e-2;          // of a segment
  static constexpr double least_cosine = 0.5;      // of a direction that goes on
  static constexpr double sharpest_corner = 1e-5;  // [rad]

  /// Where a slope that rises is zero.
  template <class F>
  static double between(const F& slope, double low, double high) {
    while (true) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) return middle;
      (slope(middle) < 0.0 ? low : high) = middle;
    }
  }

  const C& curve_;
  double sharp_bend_;
};

/// Stretches and rests, made one after the other. A stop too soon after another one is none.
class Stretches {
 public:
  Stretches(double start, double shortest) : start_(start), shortest_(shortest) {}

  /// `length`: of all before.
  void stop_at(double time, double length) {
    if (length - before_ > shortest_) add(time, length, length - before_);
  }
  /// From the last stop on, or from `from`.
  void rest(double from, double to, double length) {
    stop_at(from, length);
    add(to, length, 0.0);
  }
  [[nodiscard]] std::vector<EvenStretch> all() && { return std::move(all_); }

 private:
  void add(double time, double length, double of_it) {
    all_.push_back({start_, time, before_, of_it});
    start_ = time;
    before_ = length;
  }

  double start_, shortest_, before_ = 0.0;
  std::vector<EvenStretch> all_;
};

/// Error: the other kind of motion goes on in a rest, or the motion jumps where the segment begins.
template <class C>
Expected<void> check_segment(const C& curve, const PoseCurve& pose, std::size_t s, bool is_rest, bool is_corner) {
  const Words words = words_of(curve);
  const KnotSpan span = curve.knots().span(s);
  const double start = span.start() - curve.knots().front(), end = span.end() - curve.knots().front();
  if (is_rest && other_move(curve, pose, span) > 1.0)
    return bad_option(words.option,
                      formatted("from {:.6g} s to {:.6g} s after the start the body {}, and nothing else, which would "
                                "take no time; wanted `{}`",
                                start, end, words.other_moves, words.other_option));
  if (is_corner)
    return bad_option(
        words.option,
        formatted("the path has a corner {:.6g} s after the start, where an even motion would jump; wanted "
                  "a method without corners, such as auto",
                  start));
  return {};
}

/// Where a curve turns back inside its segments, in order [s].
template <class C>
std::vector<double> kinks_of(const C& curve, const Turns<C>& turns) {
  std::vector<double> kinks;
  for (std::size_t s = 0; s < curve.knots().segments(); ++s)
    std::ranges::copy(turns.inside(s), std::back_inserter(kinks));
  return kinks;
}

template <class C>
Expected<std::vector<EvenStretch>> stretches_of(const C& curve, const PoseCurve& pose, const Turns<C>& turns,
                                                std::span<const double> kinks, const ArcLength<C>& travelled) {
  Stretches stretches(curve.knots().front(), shortest_of(curve));
  bool moved = false;
  for (std::size_t s = 0; s < curve.knots().segments(); ++s) {
    const KnotSpan span = curve.knots().span(s);
    const double before = travelled.at(span.start());
    const bool moves = travelled.at(span.end()) - before > shortest_of(curve);
    const bool turns_back = moves && moved && turns.is_back(s - 1, s, span.start());
    const bool is_corner = moves && moved && !turns_back && turns.is_corner(s - 1, s, span.start());
    if (auto checked = check_segment(curve, pose, s, !moves, is_corner); !checked)
      return tl::unexpected(std::move(checked.error()));
    if (!moves) stretches.rest(span.start(), span.end(), before);
    if (turns_back) stretches.stop_at(span.start(), before);
    for (; !kinks.empty() && kinks.front() < span.end(); kinks = kinks.subspan(1))
      if (moves) stretches.stop_at(kinks.front(), travelled.at(kinks.front()));
    moved = moves;
  }
  stretches.stop_at(curve.knots().back(), travelled.total());
  return std::move(stretches).all();
}

}  // namespace

template <class C>
Expected<EvenPath> EvenPath::along(const C& curve, const PoseCurve& pose, double sharp_bend) {
  const Turns<C> turns(curve, sharp_bend);
  const std::vector<double> kinks = kinks_of(curve, turns);
  const ArcLength<C> travelled(curve, kinks);
  return stretches_of(curve, pose, turns, kinks, travelled)
      .and_then([&](std::vector<EvenStretch> stretches) -> Expected<EvenPath> {
        if (std::ranges::all_of(stretches, &EvenStretch::is_rest))
          return bad_option(words_of(curve).option,
                            formatted("no key {} from the one before it, wanted keys that do", words_of(curve).moves));
        return EvenPath(travelled, std::move(stretches));
      });
}

Expected<EvenPath> EvenPath::by_angle(const PoseCurve& curve, double sharp_bend) {
  return along(curve.orientation, curve, sharp_bend);
}
Expected<EvenPath> EvenPath::by_distance(const PoseCurve& curve, double sharp_bend) {
  return along(*curve.position, curve, sharp_bend);
}

double EvenPath::time_at(const EvenStretch& stretch, double length) const {
  if (stretch.is_rest()) return stretch.from;
  const double time = std::visit([&](const auto& all) { return all.time_at(stretch.before + length); }, travelled_);
  return std::clamp(time, stretch.from, stretch.to);
}

double EvenPath::length_at(const EvenStretch& stretch, double time) const {
  const double length = std::visit([time](const auto& all) { return all.at(time); }, travelled_);
  return std::clamp(length - stretch.before, 0.0, stretch.length);
}

}}  // namespace orispline
