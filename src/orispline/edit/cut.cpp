// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/cut.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include <Eigen/LU>

#include <orispline/clip/clip_clock.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/clip/clip_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double cut_tolerance = 1e-7;  // of the rotation in a piece of a cubic that is cut [rad]: what floats resolve
constexpr int most_halvings = 10;
constexpr std::size_t places = 16;  // between which a piece is compared

template <CurvePoint P>
using Numbers = Eigen::Matrix<double, std::same_as<P, Eigen::Quaterniond> ? 4 : 3, 1>;

Eigen::Vector4d numbers_of(const Eigen::Quaterniond& value) { return value.coeffs(); }
Eigen::Vector3d numbers_of(const Eigen::Vector3d& value) { return value; }

/// A cubic of the components between two times.
template <CurvePoint P>
struct Cubic {
  struct End {
    double time;
    Numbers<P> value, rate;
  };
  End start, end;

  [[nodiscard]] End at(double t) const {
    const double step = end.time - start.time, u = (t - start.time) / step, v = 1.0 - u;
    const Numbers<P> leaving = step * start.rate, arriving = step * end.rate, between = end.value - start.value;
    return {t,
            v * v * (1.0 + 2.0 * u) * start.value + u * u * (1.0 + 2.0 * v) * end.value +
                u * v * (v * leaving - u * arriving),
            (6.0 * u * v * between + v * (v - 2.0 * u) * leaving + u * (u - 2.0 * v) * arriving) / step};
  }
};

template <CurvePoint P>
Cubic<P> segment_of(const Channel<P>& channel, std::size_t i) {
  return {{channel.times[i], numbers_of(channel.values[i]), numbers_of(channel.out_tangents[i])},
          {channel.times[i + 1], numbers_of(channel.values[i + 1]), numbers_of(channel.in_tangents[i + 1])}};
}

/// The same directions, with unit ends: times a function that is linear in time.
Cubic<Eigen::Quaterniond> with_unit_ends(const Cubic<Eigen::Quaterniond>& piece) {
  const double start = 1.0 / piece.start.value.norm(), end = 1.0 / piece.end.value.norm();
  const double growth = (end - start) / (piece.end.time - piece.start.time);
  const auto scaled = [&](const auto& key, double factor) {
    return Cubic<Eigen::Quaterniond>::End{key.time, factor * key.value, factor * key.rate + growth * key.value};
  };
  return {scaled(piece.start, start), scaled(piece.end, end)};
}

/// With other rates along the values at its ends, which change no direction there: those by which it follows the
/// directions of another one best, by least squares.
Cubic<Eigen::Quaterniond> following(const Cubic<Eigen::Quaterniond>& unit, const Cubic<Eigen::Quaterniond>& whole) {
  const auto &start = unit.start, &end = unit.end;
  const Eigen::Vector4d none = Eigen::Vector4d::Zero();
  const Cubic<Eigen::Quaterniond> by_start{{start.time, none, start.value}, {end.time, none, none}},
      by_end{{start.time, none, none}, {end.time, none, end.value}};
  Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
  Eigen::Vector2d sums = Eigen::Vector2d::Zero();
  for (std::size_t k = 1; k < places; ++k) {
    const double t = start.time + static_cast<double>(k) / double{places} * (end.time - start.time);
    const Eigen::Vector4d direction = whole.at(t).value.normalized();
    const auto across = [&](const Cubic<Eigen::Quaterniond>& cubic) -> Eigen::Vector4d {
      const Eigen::Vector4d value = cubic.at(t).value;
      return value - direction * direction.dot(value);
    };
    Eigen::Matrix<double, 4, 2> each;
    each << across(by_start), across(by_end);
    products += each.transpose() * each;
    sums -= each.transpose() * across(unit);
  }
  const Eigen::Vector2d rates = products.inverse() * sums;
  if (!rates.allFinite()) return unit;
  return {{start.time, start.value, start.rate + rates[0] * start.value},
          {end.time, end.value, end.rate + rates[1] * end.value}};
}

/// The largest angle between two cubics that are normalised, within the first one [rad].
double angle_between(const Cubic<Eigen::Quaterniond>& a, const Cubic<Eigen::Quaterniond>& b) {
  double largest = 0.0;
  for (std::size_t k = 1; k < places; ++k) {
    const double share = static_cast<double>(k) / double{places};
    const double t = a.start.time + share * (a.end.time - a.start.time);
    largest = std::max(largest, angular_distance(Eigen::Quaterniond(a.at(t).value).normalized(),
                                                 Eigen::Quaterniond(b.at(t).value).normalized()));
  }
  return largest;
}

/// Collects the keys of a part.
template <CurvePoint P>
class Part {
 public:
  Part(const Channel<P>& channel, double from, double to) : channel_(channel), curve_(channel), from_(from), to_(to) {
    part_.joint = channel.joint;
    part_.interpolation = channel.interpolation;
  }

  [[nodiscard]] Channel<P> of_values() && {
    append(from_, curve_.at(from_));
    for (std::size_t i = 0; i < channel_.size(); ++i)
      if (channel_.times[i] > from_ && channel_.times[i] < to_) append(channel_.times[i], channel_.values[i]);
    append(to_, curve_.at(to_));
    return std::move(part_);
  }

  [[nodiscard]] Channel<P> of_cubics() && {
    if (from_ < channel_.times.front()) rest(from_, std::min(channel_.times.front(), to_), channel_.values.front());
    for (std::size_t i = 0; i + 1 < channel_.size(); ++i) {
      const double start = std::max(from_, channel_.times[i]), end = std::min(to_, channel_.times[i + 1]);
      if (start < end) piece(segment_of(channel_, i), start, end);
    }
    if (to_ > channel_.times.back()) rest(std::max(channel_.times.back(), from_), to_, channel_.values.back());
    return std::move(part_);
  }

 private:
  void append(double time, const P& value) {
    part_.times.push_back(time);
    part_.values.push_back(value);
  }

  void append(const Cubic<P>& cubic) {
    if (part_.times.empty()) {
      append(cubic.start.time, P(cubic.start.value));
      part_.in_tangents.push_back(P(cubic.start.rate));
      part_.out_tangents.push_back(P(cubic.start.rate));
    }
    part_.out_tangents.back() = P(cubic.start.rate);
    append(cubic.end.time, P(cubic.end.value));
    part_.in_tangents.push_back(P(cubic.end.rate));
    part_.out_tangents.push_back(P(cubic.end.rate));
  }

  void rest(double start, double end, const P& value) {
    const Numbers<P> numbers = numbers_of(value), none = Numbers<P>::Zero();
    append(Cubic<P>{{start, numbers, none}, {end, numbers, none}});
  }

  void piece(const Cubic<P>& whole, double start, double end, int halved = 0) {
    const auto end_at = [&](double t) {
      return t == whole.start.time ? whole.start : t == whole.end.time ? whole.end : whole.at(t);
    };
    const Cubic<P> part{end_at(start), end_at(end)};
    if constexpr (std::same_as<P, Eigen::Quaterniond>) {
      const bool is_whole = start == whole.start.time && end == whole.end.time;
      Cubic<P> unit = is_whole ? part : with_unit_ends(part);
      const auto is_off = [&] { return !is_whole && angle_between(unit, whole) > cut_tolerance; };
      if (is_off()) unit = following(unit, whole);
      if (halved < most_halvings && is_off()) {
        const double middle = std::midpoint(start, end);
        piece(whole, start, middle, halved + 1);
        return piece(whole, middle, end, halved + 1);
      }
      return append(unit);
    }
    append(part);
  }

  const Channel<P>& channel_;
  ChannelCurve<P> curve_;
  double from_, to_;
  Channel<P> part_{};
};

template <class T>
SharedList<T> backwards(const SharedList<T>& list) {
  return std::vector<T>(std::make_reverse_iterator(list.end()), std::make_reverse_iterator(list.begin()));
}

template <CurvePoint P>
Channel<P> reversed_within(const Channel<P>& channel, Domain domain) {
  Channel<P> back{.joint = channel.joint, .interpolation = channel.interpolation};
  back.values = backwards(channel.values);
  for (auto time = channel.times.end(); time != channel.times.begin();)
    back.times.push_back(domain.start + (domain.end - *--time));
  back.in_tangents = backwards(channel.out_tangents);
  back.out_tangents = backwards(channel.in_tangents);
  for (P& tangent : back.in_tangents) tangent = scaled(tangent, -1.0);
  for (P& tangent : back.out_tangents) tangent = scaled(tangent, -1.0);
  if (channel.interpolation != ChannelInterpolation::step || channel.size() == 1) return back;
  // Between two keys a step has the value of the earlier one, which is the later one now.
  std::rotate(back.values.begin(), back.values.begin() + 1, back.values.end());
  back.values.back() = channel.values.front();
  if (channel.times.back() < domain.end) {
    back.times.insert(back.times.begin(), domain.start);
    back.values.insert(back.values.begin(), channel.values.back());
  }
  return back;
}

}  // namespace

template <CurvePoint P>
Channel<P> part_of(const Channel<P>& channel, double from, double to) {
  if (channel.size() == 1) {
    Channel<P> one = channel;
    one.times = std::vector<double>(1, from);
    return one;
  }
  Part<P> part(channel, from, to);
  return channel.interpolation == ChannelInterpolation::cubicspline ? std::move(part).of_cubics()
                                                                    : std::move(part).of_values();
}
template RotationChannel part_of(const RotationChannel&, double, double);
template VectorChannel part_of(const VectorChannel&, double, double);

Clip part_of(const Clip& clip, Domain part) {
  return with_channels(clip, [&](const auto& channel) { return part_of(channel, part.start, part.end); });
}

double key_time_near(const Clip& clip, double time) {
  constexpr double rounding = 0x1p-23;
  const std::vector<double> times = key_times(clip);
  const auto after = std::ranges::lower_bound(times, time);
  for (const auto near : {after, after == times.begin() ? times.end() : std::prev(after)})
    if (near != times.end() && std::abs(*near - time) <= rounding * std::abs(time)) return *near;
  return time;
}

Clip resampled(Clip clip, double rate) {
  constexpr double least_step = 1e-3;  // of the last interval, as a share of the others
  const Domain domain = clip.domain();
  const double steps = (domain.end - domain.start) * rate;
  std::vector<double> times;
  for (std::size_t k = 0; static_cast<double>(k) < steps - least_step; ++k)
    times.push_back(domain.start + static_cast<double>(k) / rate);
  times.push_back(domain.end);
  const SharedList<double> shared = std::move(times);
  return with_channels(std::move(clip), [&](auto channel) {
    if (channel.size() == 1 || channel.interpolation == ChannelInterpolation::step) return channel;
    const ChannelCurve curve(channel);
    channel.interpolation = ChannelInterpolation::linear;
    channel.times = shared;
    channel.in_tangents = channel.out_tangents = {};
    channel.values = {};
    for (const double t : shared) channel.values.push_back(curve.at(t));
    return channel;
  });
}

Clip shifted(Clip clip, double by) {
  return with_channels(std::move(clip), [by](auto channel) {
    for (double& time : channel.times) time += by;
    return channel;
  });
}

Clip with_speed(Clip clip, double factor) {
  const double start = clip.domain().start, end = start + 1.0;
  return on_clock(std::move(clip), {{start, end}, {start, start + 1.0 / factor}});
}

Clip reversed(Clip clip) {
  const Domain domain = clip.domain();
  return with_channels(std::move(clip), [&](const auto& channel) { return reversed_within(channel, domain); });
}

}}  // namespace orispline
