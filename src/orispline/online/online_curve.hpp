// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/batch/sample.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/online/stream_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The keys that the next segments need, and the segments of one method by their place in a ring.
class OnlineSegments {
 public:
  virtual ~OnlineSegments() = default;
  /// True where keys and segments are put on the heap one by one.
  [[nodiscard]] virtual bool allocates() const noexcept = 0;

  /// Takes the next key, which is checked: its orientation is of unit norm as `unit` says, with the sign chosen.
  virtual void push(const StreamKey& key, const Eigen::Quaterniond& unit) = 0;
  /// Takes the newest key back.
  virtual void pop() noexcept = 0;
  virtual void reset() noexcept = 0;
  /// Makes the segment whose first key came `behind` keys before the newest. Errors: those of make_curve().
  [[nodiscard]] virtual Expected<Domain> store(std::size_t place, std::size_t behind, Stream stream) = 0;

  [[nodiscard]] virtual Eigen::Quaterniond orientation(double t, std::size_t place) const noexcept = 0;
  [[nodiscard]] virtual Motion motion(double t, Side side, std::size_t place) const noexcept = 0;
  [[nodiscard]] virtual LinearMotion linear_motion(double t, Side side, std::size_t place) const noexcept = 0;

  /// Writes samples of one segment, from sample `at` on, with the bits that the whole curve has in bulk.
  virtual void sample(std::span<const double> times, std::size_t place, const Samples<double>& out,
                      std::size_t at) const = 0;
};

/// The samples of a curve on one of its segments, from sample `at` on.
ORISPLINE_EXPORT void sample_on_segment(const PoseCurve& curve, std::size_t segment, std::span<const double> times,
                                        const Samples<double>& out, std::size_t at);

/// Segments that blend two or four keys and hold all that they depend on: nothing is allocated after construction. Null
/// where the method has no such segments, or its keys bring settings of their own.
[[nodiscard]] ORISPLINE_EXPORT std::unique_ptr<OnlineSegments> segments_in_place(const StreamMethod& method,
                                                                                 std::size_t places);

/// Segments of any local method: each is the middle of a curve through its own keys and those beside them.
[[nodiscard]] ORISPLINE_EXPORT std::unique_ptr<OnlineSegments> segments_of_windows(const StreamMethod& method,
                                                                                   std::size_t places);

/// The names of the methods whose segments depend on a few keys.
[[nodiscard]] ORISPLINE_EXPORT std::span<const std::string_view> online_methods() noexcept;

/// A curve whose keys arrive one by one, for loops that cannot wait for the last one.
///
/// A segment is *final* once the keys that it depends on are here: for the four-key families when one key behind its
/// end has come, for `auto` three, for slerp at once. Final segments never change and are, bit for bit, those of the
/// curve that `make_curve` builds through the same keys. The newest ones are kept in a ring, the others are forgotten.
///
/// Where a segment blends two or four keys nothing is allocated after construction, but for the message of an error.
/// The other methods, and parameters that come with the keys, allocate when a key is appended, never when the curve is
/// evaluated: `allocates()` tells. For one thread: let the writer evaluate, or lock.
class ORISPLINE_EXPORT OnlineCurve {
 public:
  static constexpr std::size_t least_capacity = 2, greatest_capacity = 1'000'000;

  /// The methods that have an online form: those of which a segment depends on a few keys.
  [[nodiscard]] static std::span<const std::string_view> methods() noexcept { return online_methods(); }

  /// A curve without keys. `capacity` is how many ends of final segments stay available, the newest.
  ///
  /// Parameters have one value for all keys, or in the method none: then every key brings its own. The rule of the
  /// start is used at the first key, that of the end by `finish`. Errors (bad_argument): a method without online form,
  /// a capacity out of range, a loop, several values of a parameter, settings that the family does not accept or with
  /// which no end can have the given rate.
  [[nodiscard]] static Expected<OnlineCurve> make(const Method& method, std::size_t capacity,
                                                  Signs signs = Signs::shortest);

  /// Takes the next key, body to world, at `time` [s].
  ///
  /// Normalises, aligns the sign and refuses as `Keyframes::make` does (bad_data with the key's index, counted from 0
  /// since construction or reset). A refused key leaves the curve as it was. Either all keys have a position or none;
  /// after `finish` there are no more (bad_argument).
  [[nodiscard]] Expected<void> append(double time, const Eigen::Quaterniond& orientation) {
    return append({.time = time, .orientation = orientation});
  }
  /// Takes the next key with its position [m], world frame.
  [[nodiscard]] Expected<void> append(double time, const Eigen::Quaterniond& orientation,
                                      const Eigen::Vector3d& position) {
    return append({.time = time, .orientation = orientation, .position = position});
  }
  /// Takes the next key with rates, which some methods use, and with values of the parameters that come with the keys.
  [[nodiscard]] Expected<void> append(const StreamKey& key);

  /// Declares the last key to be the end: by the end rule the last segment becomes final too.
  ///
  /// Errors: bad_data without keys, with fewer than the end rules need or with another count than the method takes; the
  /// curve stays as it was.
  [[nodiscard]] Expected<void> finish();

  /// Forgets all keys, not the method: a new curve, in the same memory.
  void reset() noexcept;

  /// From the first to the last key [s] between which the curve is final and kept; nothing before the first key.
  [[nodiscard]] std::optional<Domain> available() const noexcept;

  /// How many keys behind the end of a segment must have come before it is final: half of those that a segment depends
  /// on beside its own. The first segments wait for as many keys as the start depends on.
  [[nodiscard]] std::size_t look_ahead() const noexcept { return *method_.keys_beside; }

  /// True where `append` and `finish` allocate memory.
  [[nodiscard]] bool allocates() const noexcept { return segments_->allocates(); }

  /// Whether its keys have positions.
  [[nodiscard]] bool has_positions() const noexcept { return parts_.position; }

  /// Keys taken since construction or reset.
  [[nodiscard]] std::uint64_t keys() const noexcept { return keys_; }

  /// Orientation at time t [s]. Before and after what is available the orientation there is held. A NaN time gives NaN,
  /// and so does a curve without keys.
  [[nodiscard]] Eigen::Quaterniond operator()(double t) const noexcept;

  /// Orientation with body rates at time t [s], held at rest outside what is available. At a key the right-hand
  /// segment's or on request the left-hand one's; at the last one available always the left-hand one's. All NaN
  /// at a NaN time and without keys.
  [[nodiscard]] Motion motion(double t, Side side = Side::right) const noexcept;

  /// As motion(), but a time that is not available is an error (bad_argument).
  [[nodiscard]] Expected<Motion> checked_motion(double t) const;

  /// Position with velocity, acceleration and jerk at time t [s], held at rest outside what is available; nothing when
  /// the keys have no positions. All NaN at a NaN time.
  [[nodiscard]] std::optional<LinearMotion> linear_motion(double t, Side side = Side::right) const noexcept;

  /// Samples at times in any order, held at rest outside what is available; NaN at a NaN time and without keys. Where
  /// the curve is final they have the bits of samples of the curve through all keys, but for the last key available,
  /// which is the left-hand segment's. Memory is allocated.
  ///
  /// Errors (bad_argument): spans whose sizes do not belong together; room for positions that the keys do not have.
  [[nodiscard]] Expected<void> sample(std::span<const double> times, const Samples<double>& out) const;

 private:
  OnlineCurve(StreamMethod method, std::size_t capacity, Signs signs);

  [[nodiscard]] Expected<void> make_final(Stream stream);

  [[nodiscard]] std::size_t places() const noexcept { return starts_.size() / 2; }
  /// The place of the segment that is `index` after the oldest one kept.
  [[nodiscard]] std::size_t place_of(std::size_t index) const noexcept {
    const std::size_t place = next_place_ + places() - kept() + index;
    return place < places() ? place : place - places();
  }
  void hold(double end, const Samples<double>& out, std::size_t at) const;
  [[nodiscard]] std::size_t place_at(double t, Side side) const noexcept;
  [[nodiscard]] std::size_t kept() const noexcept;
  [[nodiscard]] std::span<const double> starts() const noexcept;

  /// A key as far as later ones and times without a segment ask for it.
  struct Place {
    double time = 0.0;
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
  };

  StreamMethod method_;
  Signs signs_;
  std::unique_ptr<OnlineSegments> segments_;
  std::vector<double> starts_;  ///< of the segments [s]; the ring twice, so that what is kept lies in one piece
  double end_ = 0.0;            ///< of the last final segment [s]
  Place first_, newest_;
  RecentTimes times_;
  KeyParts parts_;
  std::uint64_t keys_ = 0, final_segments_ = 0;
  std::size_t next_place_ = 0;
  bool finished_ = false;
};

}}  // namespace orispline
