// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/channel_reduction.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/clip/filtered_keys.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/highest.hpp>
#include <orispline/math/number.hpp>
#include <orispline/math/shorter_way.hpp>
#include <orispline/reduce/clip_bytes.hpp>
#include <orispline/reduce/cubic_keys.hpp>
#include <orispline/reduce/hermite_keys.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/reduce/stored_channel.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int attempts = 10;  // to hold the tolerance between the samples, and with the numbers of the file
/// Of the tolerance, for the keys of a method that is then written as cubics; the rest is for these.
constexpr double share_of_keys = 0.8;
/// Of the tolerance, so that the numbers of a file hold it too.
constexpr double share_before_rounding = 0.9999;
/// Of the tolerance, by which values may be off that are rounded to be compressed.
constexpr double share_of_rounding = 0.4;
constexpr double no_bound = 1e3;  // wider than any angle [rad]: of rotations that are the same throughout

Eigen::Quaterniond halfway(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.slerp(0.5, b); }
Eigen::Vector3d halfway(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return 0.5 * (a + b); }

Expected<Keyframes> keyframes(const RotationChannel& channel) {
  return Keyframes::make({.times = channel.times, .orientations = channel.values});
}
Expected<Keyframes> keyframes(const VectorChannel& channel) {
  KeyframeData data{.times = channel.times, .positions = channel.values};
  data.orientations.assign(channel.size(), Eigen::Quaterniond::Identity());
  return Keyframes::make(std::move(data));
}

RotationChannel followed(const PoseCurve& curve, double tolerance, const RotationChannel&) {
  return cubic_channel(curve.orientation, tolerance).channel;
}
VectorChannel followed(const PoseCurve& curve, double tolerance, const VectorChannel&) {
  return cubic_channel(*curve.position, tolerance).channel;
}

/// With a key of the channel before in the middle of steps of nearly 180°, which readers turn by either way.
RotationChannel without_half_turns(RotationChannel channel, const RotationChannel& before) {
  for (std::size_t k = 0; k + 1 < channel.size();) {
    const auto from = std::ranges::lower_bound(before.times, channel.times[k]),
               to = std::ranges::lower_bound(before.times, channel.times[k + 1]);
    if (to - from < 2 || std::abs(channel.values[k].dot(channel.values[k + 1])) > cosine_near_half_turn) {
      ++k;
      continue;
    }
    const auto middle = static_cast<std::ptrdiff_t>(from - before.times.begin()) + (to - from) / 2;
    const auto place = static_cast<std::ptrdiff_t>(k) + 1;
    channel.times.insert(channel.times.begin() + place, before.times[static_cast<std::size_t>(middle)]);
    channel.values.insert(channel.values.begin() + place, before.values[static_cast<std::size_t>(middle)]);
  }
  return channel;
}
VectorChannel without_half_turns(VectorChannel channel, const VectorChannel&) { return channel; }

/// By a method of the registry: `slerp` as geodesics, others as cubics that follow their curve.
template <CurvePoint P>
Expected<Channel<P>> by_method(const Channel<P>& channel, double tolerance, const Method& method) {
  const bool is_linear = method.name == "slerp", is_angle = std::same_as<P, Eigen::Quaterniond>;
  const double of_keys = is_linear ? tolerance : share_of_keys * tolerance;
  const ReduceOptions options{.tolerance =
                                  is_angle ? Tolerance{of_keys} : Tolerance{.angle = no_bound, .position = of_keys}};
  const auto keys = keyframes(channel);
  if (!keys) return tl::unexpected(keys.error());
  auto reduction = reduce(Track(*keys), method, options);
  if (!reduction) return tl::unexpected(std::move(reduction.error()));
  const Keyframes& found = reduction->track.keys;
  if (!is_linear)
    return make_pose_curve(reduction->method, found).map([&](const PoseCurve& curve) {
      return followed(curve, (1.0 - share_of_keys) * tolerance, channel);
    });
  Channel<P> result{.interpolation = ChannelInterpolation::linear};
  result.times.assign(found.times().begin(), found.times().end());
  const auto points = found.points<P>();
  result.values.assign(points.begin(), points.end());
  return without_half_turns(std::move(result), channel);
}

/// Chords of the unit sphere are faster than angles, and rise with them.
double chord(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double same = (a.coeffs() - b.coeffs()).squaredNorm(), other = (a.coeffs() + b.coeffs()).squaredNorm();
  return std::sqrt(std::min(same, other));
}
double chord(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm(); }
template <CurvePoint P>
double distance_of_chord(double chord) {
  if (!std::same_as<P, Eigen::Quaterniond>) return chord;
  const double sine = std::min(1.0, 0.5 * chord);
  return 4.0 * elementary::arctangent(sine, std::sqrt(1.0 - sine * sine));
}
template <CurvePoint P>
double chord_of_distance(double distance) {
  if (!std::same_as<P, Eigen::Quaterniond>) return distance;
  return 2.0 * elementary::sine_cosine(0.25 * std::min(distance, std::numbers::pi)).sine;
}

/// What few keys miss of a motion.
struct Missed {
  double at_samples = 0.0;             ///< the farthest there [rad, or a length]
  std::vector<std::size_t> between{};  ///< after which of the samples the tolerance is broken before the next
};

/// Whether what has these values at even places may be above a bound between them: by no more than the lines through
/// neighbours that go on, where it bends downwards.
bool may_rise_above(double bound, std::span<const double> values) {
  double largest = values.front(), widest_step = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k) {
    largest = std::max(largest, values[k]);
    widest_step = std::max(widest_step, std::abs(values[k] - values[k - 1]));
  }
  return largest + widest_step > bound;
}

/// Samples of a motion that few keys are to follow, and what it is where it is looked at between two of them.
template <CurvePoint P>
class Samples {
 public:
  explicit Samples(const TakenChannel<P>& taken)
      : motion_(taken.motion), samples_(taken.channel), looks_(taken.looks.begin(), taken.looks.end()) {
    for (std::size_t i = 0; taken.looks.empty() && i < samples_.size(); ++i) add_looks(samples_.times, i, looks_);
  }

  [[nodiscard]] const Channel<P>& keys() const { return samples_; }

  /// The first key and the last one are the same from now on.
  void join_ends() {
    samples_.values.front() = samples_.values.back() = halfway(samples_.values.front(), samples_.values.back());
  }

  [[nodiscard]] Missed missed_by(const Channel<P>& reduced, double tolerance) const {
    constexpr std::size_t each = looks_between + 1;
    const ChannelCurve<P> curve(reduced);
    const auto off = [&](double t) { return chord(motion_.at(t), curve.at(t)); };
    const double bound = chord_of_distance<P>(tolerance);
    Missed missed;
    double at_samples = 0.0;
    std::array<double, each + 1> places{}, chords{};
    chords.back() = chord(looks_[0], curve.at(samples_.times[0]));
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
      for (std::size_t k = 0; k < places.size(); ++k) places[k] = look(samples_.times, i, k);
      chords.front() = chords.back();
      for (std::size_t k = 1; k < places.size(); ++k) chords[k] = chord(looks_[i * each + k], curve.at(places[k]));
      const double at_ends = std::max(chords.front(), chords.back());
      at_samples = std::max(at_samples, at_ends);
      if (!may_rise_above(bound, chords)) continue;
      const Height top = highest(places, chords, off, bound);
      if (top.value > std::max(bound, at_ends)) missed.between.push_back(i);
    }
    missed.at_samples = distance_of_chord<P>(at_samples);
    return missed;
  }

  /// With the middle of the motion after those samples as another one.
  void add_middles(const std::vector<std::size_t>& after) {
    if (after.empty()) return;
    Channel<P> more{.joint = samples_.joint, .interpolation = samples_.interpolation};
    auto next = after.begin();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      more.times.push_back(samples_.times[i]);
      more.values.push_back(samples_.values[i]);
      if (next == after.end() || *next != i) continue;
      more.times.push_back(samples_.times[i] + 0.5 * (samples_.times[i + 1] - samples_.times[i]));
      more.values.push_back(motion_.at(more.times.back()));
      ++next;
    }
    std::vector<P> looks;
    for (std::size_t i = 0, k = 0; i < samples_.size(); ++i, ++k) {
      const bool is_halved = std::ranges::binary_search(after, i);
      if (is_halved) add_looks(more.times, k, looks), add_looks(more.times, ++k, looks);
      else copy_looks(i, looks);
    }
    samples_ = std::move(more);
    looks_ = std::move(looks);
  }

 private:
  [[nodiscard]] static double look(const std::vector<double>& times, std::size_t i, std::size_t k) {
    if (k == 0 || i + 1 == times.size()) return times[i];
    if (k > looks_between) return times[i + 1];
    return times[i] + static_cast<double>(k) / (looks_between + 1) * (times[i + 1] - times[i]);
  }
  void copy_looks(std::size_t i, std::vector<P>& looks) const {
    const auto first = looks_.begin() + static_cast<std::ptrdiff_t>(i * (looks_between + 1));
    looks.insert(looks.end(), first, i + 1 < samples_.size() ? first + looks_between + 1 : first + 1);
  }
  /// The motion at a sample and up to the next one.
  void add_looks(const std::vector<double>& times, std::size_t i, std::vector<P>& looks) const {
    for (std::size_t k = 0; k <= (i + 1 < times.size() ? looks_between : 0); ++k)
      looks.push_back(motion_.at(look(times, i, k)));
  }

  const ChannelCurve<P>& motion_;
  Channel<P> samples_;
  std::vector<P> looks_;
};

void turn_signs(RotationChannel& channel) {
  for (auto* const list : {&channel.values, &channel.in_tangents, &channel.out_tangents})
    for (Eigen::Quaterniond& entry : *list) entry.coeffs() = -entry.coeffs();
}

template <CurvePoint P>
void append_keys(Channel<P>& channel, const Channel<P>& more) {
  if (channel.interpolation == ChannelInterpolation::cubicspline)
    channel.out_tangents.back() = more.out_tangents.front();
  const auto add = [](auto& list, const auto& others) {
    if (!others.empty()) list.insert(list.end(), others.begin() + 1, others.end());
  };
  add(channel.times, more.times), add(channel.values, more.values);
  add(channel.in_tangents, more.in_tangents), add(channel.out_tangents, more.out_tangents);
}
/// The keys of a channel behind those of another one, whose last key is its first.
void append(RotationChannel& channel, RotationChannel more) {
  if (channel.values.back().dot(more.values.front()) < 0.0) turn_signs(more);
  append_keys(channel, more);
}
void append(VectorChannel& channel, VectorChannel more) { append_keys(channel, more); }

/// By a method that does not go over cuts by itself; `given`: rates at the ends, of `hermite-c1`.
template <CurvePoint P>
Expected<Channel<P>> of_stretch(const Channel<P>& samples, const ChannelCurve<P>& motion, double tolerance,
                                const Method& method, const RatesAtEnds& given) {
  if (!seeks_rates(method)) return by_method(samples, tolerance, method);
  return hermite_channel(cubic_samples(samples, motion), tolerance, method, given);
}

/// Keys within the tolerance at the samples, of every stretch between cuts by itself.
template <CurvePoint P>
Expected<Channel<P>> with_fewer_keys(const Channel<P>& samples, const TakenChannel<P>& before, double tolerance,
                                     const Method& method, bool closes) {
  if (method.name == cubicspline_method)
    return fewest_cubics(cubic_samples(samples, before.motion, before.cuts), tolerance, closes);
  std::optional<Eigen::Vector3d> seam;
  if (closes) seam = rate_at_seam(cubic_samples(samples, before.motion).targets);
  Expected<Channel<P>> whole = Channel<P>();
  pass_stretches<P>(samples, before.cuts, [&](std::size_t first, std::size_t last) {
    if (!whole) return;
    const RatesAtEnds given{.first = first == 0 ? seam : std::nullopt,
                            .last = last + 1 == samples.size() ? seam : std::nullopt};
    auto part = of_stretch(stretch_of(samples, first, last), before.motion, tolerance, method, given);
    if (!part || whole->times.empty()) whole = std::move(part);
    else append(*whole, *std::move(part));
  });
  return whole;
}

/// Cubics, of which those that break the tolerance at one of these times, each with the one behind it, are found anew.
template <CurvePoint P>
Channel<P> with_spans_anew(const Channel<P>& found, const Channel<P>& samples, const TakenChannel<P>& before,
                           const std::vector<double>& broken, double tolerance) {
  const auto sample_at = [&](double t) {
    return static_cast<std::size_t>(std::ranges::lower_bound(samples.times, t) - samples.times.begin());
  };
  Channel<P> whole;
  for (std::size_t k = 0, end = 0; k + 1 < found.size(); k = end) {
    end = k + 1;
    const auto next = std::ranges::lower_bound(broken, found.times[k]);
    const bool is_broken = next != broken.end() && *next < found.times[end];
    if (is_broken) end = std::min(end + 1, found.size() - 1);
    Channel<P> part = stretch_of(found, k, end);
    if (is_broken)
      part = fewest_cubics(cubic_samples(stretch_of(samples, sample_at(found.times[k]), sample_at(found.times[end])),
                                         before.motion, before.cuts),
                           tolerance);
    if (whole.times.empty()) whole = std::move(part);
    else append(whole, std::move(part));
  }
  return whole;
}

/// How far apart two values may be that are the same but for rounding of files [rad, or a length].
template <CurvePoint P>
constexpr double rounding = std::same_as<P, Eigen::Quaterniond> ? rest_angle : rest_length;

}  // namespace

std::vector<double> with_looks_between(std::span<const double> times) {
  constexpr double pieces = looks_between + 1;
  std::vector<double> all;
  for (std::size_t i = 0; i < times.size(); ++i) {
    all.push_back(times[i]);
    for (std::size_t k = 1; k <= looks_between && i + 1 < times.size(); ++k)
      all.push_back(times[i] + static_cast<double>(k) / pieces * (times[i + 1] - times[i]));
  }
  return all;
}

template <CurvePoint P>
LargestInTime farthest_from(const ChannelCurve<P>& motion, const Channel<P>& after, std::span<const double> times,
                            std::span<const P> looks, double known) {
  const ChannelCurve<P> curve(after);
  const std::vector<double> places = with_looks_between(times);
  SummitsInPassing summits;
  for (std::size_t k = 0; k < places.size(); ++k)
    summits.pass({places[k], chord(looks.empty() ? motion.at(places[k]) : looks[k], curve.at(places[k]))});
  const double t =
      summits
          .highest([&](double place) { return chord(motion.at(place), curve.at(place)); }, chord_of_distance<P>(known))
          .place;
  return {.value = distance_between(motion.at(t), curve.at(t)), .time = t};
}

template <CurvePoint P>
double apart_at_ends(const Channel<P>& channel) {
  return distance_between(channel.values.front(), channel.values.back());
}

template <CurvePoint P>
bool ends_as_it_begins(const Channel<P>& channel) {
  return apart_at_ends(channel) <= rounding<P>;
}

namespace {

template <CurvePoint P>
bool breaks_next_tool(const Channel<P>& channel, const ClipReduceOptions& options) {
  return options.next_tool == NextTool::meshopt && std::same_as<P, Eigen::Quaterniond> &&
         channel.interpolation == ChannelInterpolation::cubicspline;
}

/// Fewer keys, or fewer bytes where those are sought.
template <CurvePoint P>
bool is_less(const Channel<P>& channel, const Channel<P>& than, const ClipReduceOptions& options) {
  if (breaks_next_tool(than, options)) return !breaks_next_tool(channel, options);
  if (options.method.name == smallest_method)
    return bytes_of_keys(channel, options.compression) < bytes_of_keys(than, options.compression);
  return channel.size() < than.size();
}

template <CurvePoint P>
Expected<Channel<P>> reduced_by(const Method& method, const TakenChannel<P>& before, double tolerance,
                                const ClipReduceOptions& options) {
  const Channel<P>& channel = before.channel;
  const bool closes = options.closed && !is_cut_at_ends(channel, before.cuts) &&
                      apart_at_ends(channel) <= std::max(tolerance, rounding<P>);
  Samples<P> samples(before);
  if (closes && !ends_as_it_begins(channel)) samples.join_ends();
  const Channel<P> as_it_was = rounded_channel(channel, tolerance, options);
  const bool is_mended_in_parts = method.name == cubicspline_method && !closes;
  const bool is_rounded = options.compression != KeyCompression::none;
  double asked = (is_rounded ? 1.0 - 0.5 * share_of_rounding : share_before_rounding) * tolerance;
  std::vector<double> broken;
  Channel<P> found;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (broken.empty() || !is_mended_in_parts) {
      auto fewer = with_fewer_keys(samples.keys(), before, asked, method, closes);
      if (!fewer) return fewer;
      found = *std::move(fewer);
    } else {
      found = with_spans_anew(found, samples.keys(), before, broken, asked);
    }
    std::optional<Channel<P>> reduced = stored(found, options.precision);
    if (reduced) reduced = rounded_channel(*reduced, tolerance, options);
    if (!reduced || !is_less(*reduced, as_it_was, options)) break;
    reduced->joint = channel.joint;
    const Missed missed = samples.missed_by(*reduced, tolerance);
    if (missed.between.empty() && missed.at_samples <= tolerance) return *std::move(reduced);
    broken.clear();
    if (missed.at_samples > tolerance) asked *= 0.999 * tolerance / missed.at_samples;
    else
      for (const std::size_t i : missed.between) broken.push_back(samples.keys().times[i]);
    samples.add_middles(missed.between);
  }
  return as_it_was;
}

}  // namespace

template <CurvePoint P>
Expected<Channel<P>> reduced_channel(const TakenChannel<P>& before, double tolerance,
                                     const ClipReduceOptions& options) {
  const Channel<P>& channel = before.channel;
  const bool has_few_keys = channel.size() < 3 && !(channel.size() == 2 && breaks_next_tool(channel, options));
  if (has_few_keys || channel.interpolation == ChannelInterpolation::step)
    return rounded_channel(channel, tolerance, options);
  if (options.method.name != smallest_method) return reduced_by(options.method, before, tolerance, options);
  auto linear = reduced_by(Method{"slerp"}, before, tolerance, options);
  if (std::same_as<P, Eigen::Quaterniond> && options.next_tool == NextTool::meshopt) return linear;
  auto cubic = reduced_by(Method{cubicspline_method}, before, tolerance, options);
  if (!cubic || !linear) return cubic ? linear : cubic;
  return is_less(*linear, *cubic, options) ? linear : cubic;
}

template <CurvePoint P>
Channel<P> rounded_channel(const Channel<P>& channel, double tolerance, const ClipReduceOptions& options) {
  if (options.compression == KeyCompression::none || !(tolerance < std::numeric_limits<double>::infinity()))
    return channel;
  return with_fewest_bits(channel, share_of_rounding * tolerance);
}

template RotationChannel rounded_channel(const RotationChannel&, double, const ClipReduceOptions&);
template VectorChannel rounded_channel(const VectorChannel&, double, const ClipReduceOptions&);
template LargestInTime farthest_from(const ChannelCurve<Eigen::Quaterniond>&, const RotationChannel&,
                                     std::span<const double>, std::span<const Eigen::Quaterniond>, double);
template LargestInTime farthest_from(const ChannelCurve<Eigen::Vector3d>&, const VectorChannel&,
                                     std::span<const double>, std::span<const Eigen::Vector3d>, double);
template double apart_at_ends(const RotationChannel&);
template double apart_at_ends(const VectorChannel&);
template bool ends_as_it_begins(const RotationChannel&);
template bool ends_as_it_begins(const VectorChannel&);
template Expected<RotationChannel> reduced_channel(const TakenChannel<Eigen::Quaterniond>&, double,
                                                   const ClipReduceOptions&);
template Expected<VectorChannel> reduced_channel(const TakenChannel<Eigen::Vector3d>&, double,
                                                 const ClipReduceOptions&);

}}  // namespace orispline
