// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/fields/quantity.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a vector shall not exceed: its length, or each of its three components.
struct Limit {
  std::vector<double> sizes{};  ///< one of the length, or those of x, y, z; in the unit of the library
  Unit stated_in{"", 1.0};      ///< that messages and pages show it in; without a name in the usual one

  Limit() = default;
  Limit(double length) : sizes{length} {}  // NOLINT: a number is a limit of the length
  Limit(const Eigen::Vector3d& components)
      : sizes{components.x(), components.y(), components.z()} {}  // NOLINT: three numbers are one for each axis

  [[nodiscard]] bool is_per_axis() const noexcept { return sizes.size() == 3; }

  [[nodiscard]] friend bool operator==(const Limit&, const Limit&) = default;
};

/// What the body that follows the motion can do, everywhere and always; absent: not limited. Components are along the
/// axes of the body, of positions along those of the world.
struct MotionLimits {
  std::optional<Limit> rate{};                 ///< ω [rad/s]
  std::optional<Limit> acceleration{};         ///< α [rad/s²]
  std::optional<Limit> jerk{};                 ///< dα/dt [rad/s³]
  std::optional<Limit> torque{};               ///< |I α + ω × I ω| [N m]
  std::optional<Eigen::Matrix3d> inertia{};    ///< I [kg m²], body frame; for the torque
  std::optional<Limit> speed{};                ///< of the position [m/s]
  std::optional<Limit> linear_acceleration{};  ///< of the position [m/s²]
};

/// Which intervals between keys are slowed.
enum class Slowing {
  uniform,       ///< all by one factor s: the same path, ω/s and α/s² everywhere
  per_interval,  ///< each by its own: the method's curve through the keys at their new times
  fastest_keys   ///< each by its own, and they may get shorter too: the times that were typed do not matter
};

/// Which times of the keys shape the path of an even motion.
enum class PathTimes {
  lengths,  ///< in proportion to the angle or the distance from each key to the next, whatever was typed
  typed     ///< those that the keys have
};

/// What a motion shall keep, and how it may be slowed for it.
struct RetimeOptions {
  MotionLimits limits{};
  Slowing slowing = Slowing::uniform;
  std::optional<double> duration{};        ///< [s], from the first key to the last; the limits are checked then
  std::size_t insert_keys = 0;             ///< into each interval at most, where that makes the fastest keys faster
  std::optional<double> shorten_rests{};   ///< [s], what longer rests are cut to; absent: rests keep their duration
  std::optional<double> constant_rate{};   ///< of the angle travelled along the same path [rad/s]
  std::optional<double> constant_speed{};  ///< of the distance travelled along the same path [m/s]
  PathTimes path_times = PathTimes::lengths;
  std::optional<double> ease{};  ///< [s], how long an even motion takes to start and to stop; absent: no time
};

/// The largest of a quantity on one segment: what was found at a time, and what it is nowhere above.
struct CertifiedPeak {
  double found = 0.0, bound = 0.0;
  double time = 0.0;     ///< of `found` [s]
  std::size_t body = 0;  ///< of several bodies on one clock that of the bound
};

/// The peaks of one segment, one for each quantity.
using SegmentPeaks = std::vector<CertifiedPeak>;

/// How even a motion is, and how near to the path that it goes along.
struct Evenness {
  Method path_method{};                  ///< whose curve through the keys that were given is the path
  double unevenness = 0.0;               ///< the largest difference from the rate or speed asked for, as a share of it
  double turn = 0.0;                     ///< the largest angle between the orientation and the path's [rad]
  std::optional<double> shift{};         ///< the largest distance between the position and the path's [m]
  double largest_rate = 0.0;             ///< |ω| [rad/s]
  double largest_acceleration = 0.0;     ///< |α| [rad/s²]
  std::optional<double> typed_longer{};  ///< by which share of its length the path is longer by the typed times
  std::vector<double> path_times{};      ///< of the keys that were given, by which they shape the path [s]
  std::size_t stops = 0;                 ///< where the path turns back or bends too sharply for the ease
  std::size_t slower_stretches = 0;      ///< between stops, too short to get as fast as asked for
};

/// Keys at later times.
struct Retiming {
  Track track{};                        ///< the one given at the new times, the first as it was
  std::vector<std::size_t> inserted{};  ///< keys of the track that were not given
  Method method{};                      ///< the one given, with the settings of the track
  double time_scale = 1.0;              ///< of the whole duration; below 1 only where rests were shortened
  double slack = 0.0;                   ///< by which share less slowing might do: what was found is below the limits
  std::optional<Evenness> evenness{};   ///< of an even motion; its keys are others than those given, and many more
  Slowing slowing{};                    ///< how they were slowed: uniformly where intervals by themselves take longer
  std::vector<SegmentPeaks> peaks{};    ///< of the slowed curve, segment by segment: no bound above its limit
  std::vector<std::size_t> rests{};     ///< i where the body rests from key i to the next
  std::vector<Warning>
      warnings{};  ///< `loose_bounds`, `moving_rests`, `longer_rests`; of the inertia, and of the method's curve
};

/// The method for keys of which nobody said which curve they are for: the one given, with `hold` where it has that
/// setting, it is not stated and some of the keys are rests (Keyframes::rests_after), so that the body stays in them.
[[nodiscard]] ORISPLINE_EXPORT Method holding_rests(Method method, const Keyframes& keys);

/// Error (bad_argument): limits that are absent or not greater than 0, a torque without a positive definite inertia and
/// an inertia without a torque.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const RetimeOptions& options);

/// The least slowing, to 1e-4, with which the method's curve through the keys stays within the limits everywhere. Where
/// the largest values found are farther than 2e-4 below the limits, a warning says so: `loose_bounds` (`slack`).
///
/// Certified by certified_peaks() on the method's curve, with its settings and those of the track, through the keys at
/// the times that are returned. A motion within the limits stays as it is. Rests keep their duration, or the one that
/// `shorten_rests` states; a method that moves during them is warned of: `moving_rests` (`rests`). Where the limits
/// cannot be met that way, rests are slowed as well: `longer_rests`. `per_interval`
/// shortens the whole duration as far as least_interval_times() finds a way, for methods that are not local less far;
/// it is the uniform slowing where that is the shorter, or longer by less than 1e-4. `fastest_keys` is the best of
/// several ways down, and with `insert_keys` of those with more keys on its curve (`inserted`). The curve is as smooth
/// as the method makes it. Positions, where there are any, play no part. Errors: those of check(); bad_argument for
/// limits that ask for more than 1e15 times the duration, keys inserted for a method that does not pass through its
/// keys or has settings for each of them, a method that takes rates from the keys, does not state its segments as
/// polynomials, or whose ω jumps on these keys where acceleration is limited: no slowing helps; the like for
/// `per_interval` of a method whose ω is continuous on even times only; loops, and rates at the ends other than zero,
/// which slowing would change; bad_data for fewer than two keys; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<Retiming> retime(const Track& track, const Method& method,
                                                         const RetimeOptions& options, const Progress& progress = {});

/// A limited quantity at the segment where its bound is largest. Values are in the units of the library.
struct ORISPLINE_EXPORT Certificate {
  std::string name;            ///< `rate`, `linear acceleration`, of a component `rate about x`
  std::string id;              ///< `rate`, `linear_acceleration`, `rate_x`
  Unit shown, in_ids;          ///< the unit that was stated, else `°/s`; that of the ids, `deg_s`
  double limit, bound, found;  ///< rad/s and the like, as the times
  double time;                 ///< of `found` [s]
  std::size_t segment;
  std::size_t body = 0;  ///< of several bodies on one clock

  /// `rate_bound_deg_s`
  [[nodiscard]] std::string id_of(std::string_view part) const;
  /// A value with its unit, `90 °/s`.
  [[nodiscard]] std::string text_of(double value) const;
};

/// One for each of quantities_of(limits). Precondition: one segment at least.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Certificate> certificates_of(const MotionLimits& limits,
                                                                        std::span<const SegmentPeaks> peaks);

template <>
inline constexpr std::array words<Slowing>{
    word("uniform", Slowing::uniform, "All intervals between keys are slowed alike"),
    word("per-interval", Slowing::per_interval, "Each interval between keys is slowed by itself"),
    word("fastest-keys", Slowing::fastest_keys,
         "Each interval takes as little time as the limits allow, whatever it took before")};

template <>
inline constexpr std::array words<PathTimes>{
    word("lengths", PathTimes::lengths,
         "Times in proportion to the angle or the distance from each key to the next, whatever was typed"),
    word("typed", PathTimes::typed, "The times of the keys")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<RetimeOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Retiming>() noexcept;

}}  // namespace orispline
