// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/clip/clip_difference.hpp>
#include <orispline/clip/key_compression.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The method of clips that joins keys by cubic polynomials of the components with tangents of their own on either side
/// of a key: glTF's CUBICSPLINE.
inline constexpr std::string_view cubicspline_method = "cubicspline";
/// In the place of a method. Of clips: each channel by `cubicspline` or `slerp`, or as it was, whichever has the fewest
/// bytes in a glTF file.
inline constexpr std::string_view smallest_method = "smallest";
/// Whether it is one of these two, which only clips have.
[[nodiscard]] constexpr bool is_of_clips_alone(std::string_view method) noexcept {
  return method == cubicspline_method || method == smallest_method;
}

/// What the motion between the samples of a recording is taken to be.
enum class BetweenSamples {
  smooth,  ///< the curve `auto` through all samples
  stored   ///< what the channel says: its own interpolation
};

/// Which jumps of joints are cuts, on either side of which the motion has nothing to do with the other.
enum class Cuts {
  usual,  ///< between keys at most 2 ms apart; of smooth motion also steps that neither side of them foretells
  steps,  ///< both, whatever lies between the keys
  none
};

/// The numbers of the keys, as the file that they are for holds them.
enum class KeyPrecision { float64, float32 };

/// The tool that the file goes through next.
enum class NextTool {
  any,
  meshopt  ///< of gltf-transform, which rounds splines of rotations so that they turn elsewhere
};

/// How the keys of clips are reduced. At least one of the tolerances is finite.
struct ClipReduceOptions {
  double tolerance = std::numeric_limits<double>::infinity();           ///< of rotations [rad]
  double position_tolerance = std::numeric_limits<double>::infinity();  ///< of translations [the skeleton's unit]
  double world_tolerance = std::numeric_limits<double>::infinity();     ///< of the shell distance [that unit]
  double shell = default_shell;                                         ///< of its points from a joint [that unit]
  /// That; or `smallest`; or `slerp`, whose channels are `linear`; or another one that reduce() takes, of which cubics
  /// follow the curve. The rates of `hermite-c1` are sought with its keys.
  Method method{cubicspline_method};
  BetweenSamples between = BetweenSamples::stored;
  Cuts cuts = Cuts::usual;
  KeyPrecision precision = KeyPrecision::float64;
  KeyPrecision precision_before = KeyPrecision::float64;  ///< that the keys have: those that stay are then the same
  /// Of the file. By `meshopt` values are rounded within the tolerances, and `smallest` counts compressed bytes.
  KeyCompression compression = KeyCompression::none;
  NextTool next_tool = NextTool::any;  ///< by `meshopt` all rotations are linear
  /// Of `cubicspline` and `hermite-c1`: channels that end as they begin, or nearer to it than the tolerance, have the
  /// same key and tangent at both ends, so that the clip goes on without a jump where it begins again. Those with a cut
  /// at an end stay open.
  bool closed = false;
  /// Channels of one key that is the rest pose of their joint are left out otherwise.
  bool keep_constant = false;
};

/// Error (bad_argument): options that do not fit together, a tolerance that is not greater than 0, an angle beyond
/// 180°.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const ClipReduceOptions& options);

/// A clip with fewer keys, and how far it is from the clip that it was.
struct ClipReduction {
  /// The joint where a distance is largest.
  struct Worst {
    LargestInTime largest{};
    std::size_t joint = no_parent;  ///< `no_parent` where no joint has such a distance

    [[nodiscard]] bool is_known() const noexcept { return joint != no_parent; }
    void take(const LargestInTime& other, std::size_t of_joint) noexcept {
      if (!is_known() || other.value > largest.value) largest = other, joint = of_joint;
    }
  };

  /// A channel that does not end as it begins, or is to be closed and has a cut at an end.
  struct OpenTrack {
    std::size_t joint = 0;
    bool is_rotation = true;      ///< else a translation
    double apart = 0.0;           ///< [rad], or in the skeleton's unit of length
    bool is_cut_at_ends = false;  ///< at one of them
  };

  Clip clip{};
  std::size_t rotation_keys = 0, rotation_keys_before = 0;  ///< of tracks that had three keys or more
  std::size_t rotation_tracks = 0;                          ///< such ones
  std::size_t translation_keys = 0, translation_keys_before = 0;
  std::size_t open_tracks = 0;      ///< rotation tracks of `rotation_tracks` that do not end as they begin
  std::vector<OpenTrack> open{};    ///< those, and such translations
  std::size_t cuts = 0;             ///< in the clip before: those of several joints at one time are one
  std::size_t tracks_before = 0;    ///< channels of the clip before
  std::size_t tracks_left_out = 0;  ///< those of them that the rest pose stands for
  Worst angle{};                    ///< of rotations in the frames of the parents, at all times [rad]
  Worst translation{};              ///< of translations, in the same frames [the skeleton's unit]
  Worst distance{};                 ///< the shell distance in the world
  /// Of rotations: from the curve `auto` through the keys before, and from what the clip says [rad].
  Worst from_smooth{}, from_stored{};
};

/// The clip as a reader of the file finds it. Channels of steps stay as they are: at the time of a key, which is
/// rounded, they may be before it or after it.
[[nodiscard]] ORISPLINE_EXPORT Clip as_stored(Clip clip, const ClipReduceOptions& options);

/// Every one of the clips with the fewest keys, or by `smallest` the fewest bytes, found whose rotations and
/// translations are within the tolerances at every key that they had and between these, and whose places in the world
/// are within theirs: of what the motion before is taken to be, which is looked at in eight places between two keys of
/// the clip and beside the farthest of these until nothing rises. Channels that stay as they are are no distance off.
/// The first and the last key of each channel stay.
///
/// Cuts are not smoothed: each side of them is reduced by itself. Where a step is one, its first value is held until 1
/// ms before the second.
///
/// Rotations are reduced where `tolerance` or `world_tolerance` is finite,
/// translations where `position_tolerance` or `world_tolerance` is; scales, steps and channels of two keys stay as they
/// are. But channels of any kind that stand still but for rounding become one key, that of the rest pose where it is
/// the same, and are then left out unless `keep_constant` is set; one that alone has the first or the last key of the
/// clip stays. Rounding is `rest_angle`, `rest_length` in the world and in the frame of the parent, and that part of
/// the largest scale, and no more than the tolerances say.
///
/// For `world_tolerance` a joint's rotation may be off by that length over its reach: the longest chain of bones below
/// it, and the shell. All joints' tolerances are then scaled by one factor until the shell distance of the whole clip
/// is within the length.
///
/// On up to that many threads, 0 means one per core; the results are the same on any number of them.
/// Errors: those of check(); bad_argument for a method that reduce() does not take.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<ClipReduction>> reduce_clips(const Skeleton& skeleton,
                                                                                 std::span<const Clip> clips,
                                                                                 const ClipReduceOptions& options,
                                                                                 unsigned threads = 0);

template <>
inline constexpr std::array words<BetweenSamples>{
    word("smooth", BetweenSamples::smooth, "The motion between the keys of the input is the curve auto through them"),
    word("stored", BetweenSamples::stored, "It is what the input says, such as straight lines")};

/// The method where none is asked for.
[[nodiscard]] constexpr std::string_view usual_method(const ClipReduceOptions& options) noexcept {
  if (options.compression != KeyCompression::none) return smallest_method;
  return options.next_tool == NextTool::meshopt ? std::string_view("slerp") : cubicspline_method;
}

template <>
inline constexpr std::array words<NextTool>{
    word("any", NextTool::any, "Any reader of glTF"),
    word("meshopt", NextTool::meshopt,
         "The command meshopt of gltf-transform: rotations are linear, for it breaks others")};

template <>
inline constexpr std::array words<Cuts>{word("usual", Cuts::usual,
                                             "Jumps between keys that are at most 2 ms apart, and in smooth motion "
                                             "single steps that neither side foretells"),
                                        word("steps", Cuts::steps, "Both, whatever lies between the keys"),
                                        word("none", Cuts::none, "Every jump is motion")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<ClipReduceOptions>() noexcept;

/// Of the keys of a clip in a glTF file, whose numbers are in single precision [bytes]: equal times of several channels
/// once; compressed, with what says where they are.
[[nodiscard]] ORISPLINE_EXPORT std::size_t bytes_of_keys(const Clip& clip,
                                                         KeyCompression compression = KeyCompression::none);

/// The tolerances that are given: `0.1°, 0.02 m in the world`.
///
/// `unit`: what follows a length, such as ` m`.
[[nodiscard]] ORISPLINE_EXPORT std::string tolerance_text(const ClipReduceOptions& options, std::string_view unit);

/// Of all clips together; its members are those of the clips.
struct ClipTotals {
  std::size_t rotation_keys = 0, rotation_keys_before = 0, rotation_tracks = 0, open_tracks = 0;
  std::size_t translation_keys = 0, translation_keys_before = 0, cuts = 0, tracks_before = 0, tracks_left_out = 0;
  /// The clips where these are largest, of equals the first; null where no clip has one.
  const ClipReduction *angle = nullptr, *translation = nullptr, *distance = nullptr;
  const ClipReduction *from_smooth = nullptr, *from_stored = nullptr;
};

/// The totals point to the reductions, which outlive them.
[[nodiscard]] ORISPLINE_EXPORT ClipTotals totals_of(std::span<const ClipReduction> reductions);

}}  // namespace orispline
