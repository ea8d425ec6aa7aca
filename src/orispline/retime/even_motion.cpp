// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/even_motion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/retime/even_law.hpp>
#include <orispline/retime/even_path.hpp>
#include <orispline/retime/inserted_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int places = 8;                   // of a step, at which its rate is measured
constexpr double largest_start = 0.5;       // of a step that is not halved yet, turned [rad]
constexpr double sharp_share = 0.05;        // of what is gone in an ease at full speed: a bend is passed at rest
constexpr double much_longer = 0.05;        // of a path
constexpr int most_halvings_of_steps = 12;  // more mend no unevenness
constexpr double of_usual_keys = 500.0;     // of work

double speed_of(const RetimeOptions& options) {
  return options.constant_rate ? *options.constant_rate : options.constant_speed.value_or(0.0);
}

/// A time of the even motion, what is to be there, and how fast.
struct Moment {
  double time;       ///< [s]
  double path_time;  ///< of the curve that gives the path [s]
  double speed;      ///< [rad/s] or [m/s]
};

/// An even motion along a curve: which time of the curve belongs to a time of the motion.
class EvenMotion {
 public:
  EvenMotion(const EvenPath& path, const RetimeOptions& options, double start) : path_(path) {
    const double speed = speed_of(options);
    const double longest_rest = options.shorten_rests.value_or(std::numeric_limits<double>::infinity());
    starts_.push_back(start);
    for (const EvenStretch& stretch : path.stretches()) {
      laws_.emplace_back(stretch.length, speed, stretch.is_rest() ? 0.0 : options.ease.value_or(0.0));
      const double duration =
          stretch.is_rest() ? std::min(stretch.to - stretch.from, longest_rest) : laws_.back().duration();
      starts_.push_back(starts_.back() + duration);
    }
  }

  [[nodiscard]] std::size_t stretches() const noexcept { return laws_.size(); }
  [[nodiscard]] const EvenStretch& stretch(std::size_t i) const { return path_.stretches()[i]; }
  /// The times of its stretches [s], one after the other, and the end.
  [[nodiscard]] const std::vector<double>& starts() const noexcept { return starts_; }
  [[nodiscard]] bool has_rests() const { return std::ranges::any_of(path_.stretches(), &EvenStretch::is_rest); }
  /// How often it stops for no time.
  [[nodiscard]] std::size_t stops() const {
    std::size_t count = 0;
    for (std::size_t i = 1; i < stretches(); ++i) count += !stretch(i - 1).is_rest() && !stretch(i).is_rest();
    return count;
  }
  /// How many stretches are too short to get as fast as they shall.
  [[nodiscard]] std::size_t too_short() const {
    return static_cast<std::size_t>(std::ranges::count_if(laws_, [](const EvenLaw& law) { return !law.is_reached(); }));
  }

  [[nodiscard]] double speed_at(std::size_t i, double t) const {
    return stretch(i).is_rest() ? 0.0 : laws_[i].at(t - starts_[i]).speed;
  }
  [[nodiscard]] Moment at(std::size_t i, double t) const {
    if (t <= starts_[i]) return {starts_[i], stretch(i).from, speed_at(i, starts_[i])};
    if (t >= starts_[i + 1]) return {starts_[i + 1], stretch(i).to, speed_at(i, starts_[i + 1])};
    const Advance advance = laws_[i].at(t - starts_[i]);
    return {t, path_.time_at(stretch(i), advance.length), advance.speed};
  }
  /// When the motion is at a time of the curve that lies in a stretch.
  [[nodiscard]] double time_of(std::size_t i, double path_time) const {
    return starts_[i] + laws_[i].time_of(path_.length_at(stretch(i), path_time));
  }

 private:
  const EvenPath& path_;
  std::vector<EvenLaw> laws_;
  std::vector<double> starts_;
};

/// A step from one key to the next.
struct Step {
  std::size_t stretch;
  Moment from, middle;
};

/// How far a step is from what it shall be.
struct Fault {
  double unevenness = 0.0, turn = 0.0, shift = 0.0;

  void add(const Fault& other) {
    unevenness = std::max(unevenness, other.unevenness);
    turn = std::max(turn, other.turn);
    shift = std::max(shift, other.shift);
  }
};

double distance_between(const Keyframes& keys) {
  double distance = 0.0;
  for (std::size_t i = 1; i < keys.positions().size(); ++i)
    distance += (keys.positions()[i] - keys.positions()[i - 1]).norm();
  return distance;
}

/// Keys on the path, more and more of them.
class EvenKeys {
 public:
  EvenKeys(const EvenMotion& motion, const PoseCurve& path, const RetimeOptions& options, double distance)
      : motion_(motion),
        path_(path),
        is_by_angle_(options.constant_rate),
        speed_(speed_of(options)),
        longest_shift_(std::max(largest_shift * distance, rest_length)) {
    for (std::size_t i = 0; i < motion.stretches(); ++i) begin(i);
  }

  [[nodiscard]] std::size_t size() const noexcept { return steps_.size() + 1; }
  [[nodiscard]] bool has_rests() const { return motion_.has_rests(); }

  [[nodiscard]] Expected<Keyframes> keys() const {
    KeyframeData data;
    for (std::size_t k = 0; k <= steps_.size(); ++k) {
      const Moment& moment = k < steps_.size() ? steps_[k].from : end_of(k - 1);
      data.times.push_back(moment.time);
      data.orientations.push_back(path_.orientation(moment.path_time));
      if (path_.position) data.positions.push_back(position_at(moment.path_time));
    }
    return Keyframes::make(std::move(data), Signs::as_given);
  }

  /// Of each step of the curve through keys().
  [[nodiscard]] std::vector<Fault> faults_of(const PoseCurve& curve) const {
    std::vector<Fault> faults;
    for (std::size_t k = 0; k < steps_.size(); ++k) faults.push_back(fault_of(curve, k));
    return faults;
  }

  /// Halves the steps that are too far from what they shall be, with their neighbours; false where none is.
  [[nodiscard]] bool halve(const std::vector<Fault>& faults) {
    std::vector<bool> are_bad;
    for (std::size_t k = 0; k < steps_.size(); ++k) are_bad.push_back(is_bad(faults[k]) && can_be_halved(k));
    std::vector<Step> steps;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const bool is_beside = (k > 0 && are_bad[k - 1]) || (k + 1 < steps_.size() && are_bad[k + 1]);
      if (are_bad[k] || (is_beside && can_be_halved(k))) {
        steps.push_back(step(steps_[k].stretch, steps_[k].from, steps_[k].middle.time));
        steps.push_back(step(steps_[k].stretch, steps_[k].middle, end_of(k).time));
      } else {
        steps.push_back(steps_[k]);
      }
    }
    const bool more = steps.size() > steps_.size();
    steps_ = std::move(steps);
    return more;
  }

 private:
  /// The steps of a stretch: from one of the path's knots to the next, cut into small turns.
  void begin(std::size_t i) {
    const EvenStretch& stretch = motion_.stretch(i);
    std::vector<double> path_times{stretch.from};
    if (!stretch.is_rest())
      for (const double t : path_.orientation.knots().times())
        if (stretch.from < t && t < stretch.to) path_times.push_back(t);
    path_times.push_back(stretch.to);
    Moment from = motion_.at(i, motion_.starts()[i]);
    for (std::size_t k = 1; k < path_times.size(); ++k) {
      const double end = k + 1 < path_times.size() ? motion_.time_of(i, path_times[k]) : motion_.starts()[i + 1];
      const double turn = increment(path_.orientation(path_times[k - 1]), path_.orientation(path_times[k])).norm();
      const int pieces = stretch.is_rest() ? 1 : static_cast<int>(std::ceil(turn / largest_start)) + 1;
      const double start = from.time;
      for (int piece = 1; piece <= pieces; ++piece) {
        const double to = piece < pieces ? std::lerp(start, end, static_cast<double>(piece) / pieces) : end;
        if (!(to > from.time)) continue;
        steps_.push_back(step(i, from, to));
        from = motion_.at(i, to);
      }
    }
  }

  [[nodiscard]] Step step(std::size_t stretch, const Moment& from, double to) const {
    return {stretch, from, motion_.at(stretch, 0.5 * (from.time + to))};
  }
  [[nodiscard]] Moment end_of(std::size_t k) const {
    if (k + 1 < steps_.size()) return steps_[k + 1].from;
    return motion_.at(steps_[k].stretch, motion_.starts().back());
  }
  [[nodiscard]] Eigen::Vector3d position_at(double t) const { return path_.position->linear_motion(t).position; }

  [[nodiscard]] Fault fault_of(const PoseCurve& curve, std::size_t k) const {
    Fault fault;
    const Step& step = steps_[k];
    const double end = end_of(k).time;
    for (int j = 0; j <= places; ++j) {
      const double t = std::lerp(step.from.time, end, static_cast<double>(j) / places);
      const double speed = is_by_angle_ ? curve.orientation.motion_on(k, t).angular_velocity.norm()
                                        : curve.position->linear_motion_on(k, t).velocity.norm();
      fault.unevenness = std::max(fault.unevenness, std::abs(speed - motion_.speed_at(step.stretch, t)) / speed_);
    }
    const Moment& middle = step.middle;
    fault.turn = increment(path_.orientation(middle.path_time), curve.orientation(middle.time)).norm();
    if (path_.position)
      fault.shift = (position_at(middle.path_time) - curve.position->linear_motion(middle.time).position).norm();
    return fault;
  }

  [[nodiscard]] bool is_bad(const Fault& fault) const {
    return fault.unevenness > largest_unevenness || fault.turn > largest_turn || fault.shift > longest_shift_;
  }
  /// Not a rest, and with halves that are not taken for rests.
  [[nodiscard]] bool can_be_halved(std::size_t k) const {
    const Moment &from = steps_[k].from, &middle = steps_[k].middle;
    if (motion_.stretch(steps_[k].stretch).is_rest() || !(from.time < middle.time && middle.time < end_of(k).time))
      return false;
    if (!motion_.has_rests()) return true;  // the method then takes none for rests
    const auto is_move = [&](double a, double b) {
      return increment(path_.orientation(a), path_.orientation(b)).norm() > least_moves * rest_angle ||
             (path_.position && (position_at(a) - position_at(b)).norm() > least_moves * rest_length);
    };
    return is_move(from.path_time, middle.path_time) && is_move(middle.path_time, end_of(k).path_time);
  }

  const EvenMotion& motion_;
  const PoseCurve& path_;
  bool is_by_angle_;
  double speed_, longest_shift_;
  std::vector<Step> steps_;
};

/// Keys that are dense enough, with their curve.
struct DenseKeys {
  Keyframes keys;
  PoseCurve curve;
  Method method;
  Fault fault;
};

Expected<DenseKeys> dense_enough(EvenKeys even, OpenEndedWork& work) {
  for (int round = 0;; ++round) {
    if (work.stopped()) return cancellation();
    if (even.size() > most_even_keys)
      return failure(
          ErrorCode::not_converged,
          formatted("an even motion takes more than {} keys, wanted a path that bends less", most_even_keys));
    auto keys = even.keys();
    if (!keys) return tl::unexpected(std::move(keys.error()));
    Method method = even.has_rests() ? holding_rests(Method(default_method), *keys) : Method(default_method);
    auto curve = make_pose_curve(method, *keys);
    if (!curve) return tl::unexpected(std::move(curve.error()));
    work.add(static_cast<double>(even.size()));
    const std::vector<Fault> faults = even.faults_of(*curve);
    if (round < most_halvings_of_steps && even.halve(faults)) continue;
    Fault fault;
    for (const Fault& of_step : faults) fault.add(of_step);
    return DenseKeys{*keys, std::move(*curve), std::move(method), fault};
  }
}

/// The keys at times in proportion to the lengths of their steps; rests and steps without a length keep their duration.
Expected<Keyframes> at_times_by_lengths(const Keyframes& keys, const RetimeOptions& options) {
  std::vector<double> times{keys.times().front()};
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const double length = options.constant_rate ? increment(keys.orientations()[i], keys.orientations()[i + 1]).norm()
                                                : (keys.positions()[i + 1] - keys.positions()[i]).norm();
    const bool goes_on = length > (options.constant_rate ? rest_angle : rest_length) && !keys.rests_after(i);
    times.push_back(times.back() + (goes_on ? length / speed_of(options) : keys.times()[i + 1] - keys.times()[i]));
  }
  return keys.with_times(std::move(times));
}

/// A curve, and what a motion may go along on it.
struct ShapedPath {
  PoseCurve curve;
  EvenPath even;
  std::vector<double> times;  ///< of the keys [s]

  [[nodiscard]] double length() const { return even.stretches().back().before + even.stretches().back().length; }
};

Expected<ShapedPath> path_of(const Method& method, const Keyframes& keys, const RetimeOptions& options) {
  const double sharp_bend = sharp_share * options.ease.value_or(0.0) * speed_of(options);
  return make_pose_curve(method, keys).and_then([&](PoseCurve curve) {
    auto even =
        options.constant_rate ? EvenPath::by_angle(curve, sharp_bend) : EvenPath::by_distance(curve, sharp_bend);
    return std::move(even).map([&](EvenPath found) {
      return ShapedPath{std::move(curve), std::move(found), {keys.times().begin(), keys.times().end()}};
    });
  });
}

/// The paths that both kinds of times of the keys shape.
struct ShapedPaths {
  Expected<ShapedPath> by_lengths, typed;

  ShapedPaths(const Track& track, const Method& method, const RetimeOptions& options)
      : by_lengths(at_times_by_lengths(track.keys, options).and_then([&](const Keyframes& keys) {
          return path_of(method, keys, options);
        })),
        typed(path_of(method, track.keys, options)) {}

  /// The one asked for. Errors say what is wrong at times that people typed, where it is wrong there too.
  [[nodiscard]] const Expected<ShapedPath>& chosen(PathTimes times) const {
    return times == PathTimes::lengths && (by_lengths || typed) ? by_lengths : typed;
  }
  [[nodiscard]] std::optional<double> typed_longer() const {
    return by_lengths && typed ? std::optional(typed->length() / by_lengths->length() - 1.0) : std::nullopt;
  }
};

/// Error: a path that has to be stopped on, and no ease for it.
Expected<void> check_ease(const EvenPath& path, const RetimeOptions& options) {
  if (options.ease || path.stretches().size() == 1) return {};
  const EvenStretch& first = path.stretches().front();
  return bad_option("ease",
                    formatted("the path stops {:.6g} s after its start, where an even motion would jump; wanted "
                              "a duration in which it slows down, such as 0.5s",
                              first.is_rest() ? 0.0 : first.to - first.from));
}

Evenness evenness_of(const DenseKeys& dense, const EvenMotion& motion, Method path_method) {
  const Peaks found = peaks(dense.curve.orientation);
  Evenness evenness{.path_method = std::move(path_method),
                    .unevenness = dense.fault.unevenness,
                    .turn = dense.fault.turn,
                    .shift = {},
                    .largest_rate = found.angular_velocity.value,
                    .largest_acceleration = found.angular_acceleration.value,
                    .stops = motion.stops(),
                    .slower_stretches = motion.too_short()};
  if (dense.curve.position) evenness.shift = dense.fault.shift;
  return evenness;
}

std::vector<Warning> warnings_of(const Evenness& evenness, PathTimes times) {
  std::vector<Warning> warnings;
  const double longer = evenness.typed_longer.value_or(0.0);
  if (times == PathTimes::typed && longer > much_longer)
    warnings.push_back(
        {.code = "uneven_times",
         .message = formatted("the typed times make the path {:.3g} % longer than times in proportion to the steps "
                              "between the keys, the default, would",
                              100.0 * longer),
         .numbers = {{"typed_longer", longer}}});
  if (evenness.unevenness > largest_unevenness)
    warnings.push_back(
        {.code = "uneven_motion",
         .message = formatted("the motion differs from the even one by {:.3g} % where its path bends most "
                              "sharply; smoother keys mend that",
                              100.0 * evenness.unevenness),
         .numbers = {{"unevenness", evenness.unevenness}}});
  if (evenness.slower_stretches > 0)
    warnings.push_back(
        {.code = "slower_stretches",
         .message = formatted("{} between two stops, too short to get as fast as asked for with this ease; "
                              "a shorter one mends that",
                              counted(evenness.slower_stretches, "part")),
         .numbers = {{"stretches", static_cast<double>(evenness.slower_stretches)}}});
  return warnings;
}

}  // namespace

Expected<Retiming> evenly_retimed(const Track& track, const Method& method, const RetimeOptions& options,
                                  const Progress& progress) {
  const ShapedPaths paths(track, method, options);
  const Expected<ShapedPath>& path = paths.chosen(options.path_times);
  if (!path) return tl::unexpected(path.error());
  if (auto checked = check_ease(path->even, options); !checked) {
    auto at_typed_times = paths.typed ? check_ease(paths.typed->even, options) : checked;
    return tl::unexpected(std::move(at_typed_times ? checked : at_typed_times).error());
  }
  const EvenMotion motion(path->even, options, track.keys.times().front());
  OpenEndedWork work(progress, of_usual_keys);
  auto dense = dense_enough({motion, path->curve, options, distance_between(track.keys)}, work);
  if (!dense) return tl::unexpected(std::move(dense.error()));
  Track even(dense->keys);
  even.name = track.name;
  even.epoch = track.epoch;
  even.is_dated = track.is_dated;
  even.recipe = recipe_for(dense->method, even);
  work.finish();
  const double before = track.keys.times().back() - track.keys.times().front();
  Retiming retiming{.track = std::move(even), .method = dense->method};
  retiming.time_scale = (motion.starts().back() - motion.starts().front()) / before;
  if (motion.has_rests()) retiming.rests = dense->keys.rests();
  retiming.evenness = evenness_of(*dense, motion, method);
  retiming.evenness->typed_longer = paths.typed_longer();
  retiming.evenness->path_times = path->times;
  retiming.warnings = warnings_of(*retiming.evenness, options.path_times);
  return retiming;
}

}}  // namespace orispline
