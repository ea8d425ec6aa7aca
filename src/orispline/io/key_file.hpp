// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/curve/frame_change.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/io/clock.hpp>
#include <orispline/io/euler_turns.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/input.hpp>
#include <orispline/io/orientation_form.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

class KeyInput;

/// What becomes of the line in which a file names the curve that its keys are for.
enum class RecipeUse { honoured, ignored };

/// How far from 1 the norms of hand-typed digits and of sensors may be.
inline constexpr double loose_norm_limit = 0.02;

/// Which norms of quaternions a file may have. Those farther than `norm_error_limit` from 1 are made 1 and counted.
enum class Norms {
  near_one,    ///< within `loose_norm_limit` of 1
  any,         ///< any but 0
  as_they_are  ///< left to whoever checks the keys
};

/// Which track of a file of skeletons is meant.
struct SceneTrack {
  enum class Space {
    local,  ///< a joint in the frame of its parent
    world,
  };

  std::vector<std::string> clips{};    ///< names; empty: all, of which a command of one track takes the only one
  std::optional<std::string> joint{};  ///< its name; absent: the only one that has keys
  Space space = Space::local;
  std::optional<Signs> signs{};             ///< of rotations that are cubic splines; absent: nobody says
  bool salvage = false;                     ///< of a file that was cut off take the whole frames that are there
  std::optional<std::size_t> rest_frame{};  ///< of a BVH file: its pose is the rest pose

  [[nodiscard]] bool is_given() const noexcept { return !clips.empty() || joint || space != Space::local; }
};

/// Columns by their canonical names: what the header calls them.
using ColumnNames = std::map<std::string, std::string, std::less<>>;

/// Order of the quaternion columns of a table without a header.
enum class QuaternionOrder { wxyz, xyzw };

/// What the caller says about the orientation columns of a table.
struct OrientationReading {
  /// Absent: quaternions where there are columns of them, else the only representation that there are columns of.
  std::optional<Representation> representation{};
  /// The order of Euler angles, which also asks for them. Absent: ZYX for `roll,pitch,yaw`.
  std::optional<EulerOrder> euler{};
  /// Of Euler angles whose column does not end in a unit.
  std::optional<AngleUnit> angle_unit{};
};

/// What a rate without a number in its three cells is.
enum class FreeRates {
  allowed,  ///< left free: NaN
  refused,  ///< not finite
  lenient,  ///< left free, and so is one that has no number in one of its cells
};

/// What a row is that has a rate but no number in any cell of its orientation.
enum class UnposedRows {
  refused,    ///< not finite
  set_aside,  ///< one of a gyro beside the keys
};

/// Body rates at times that are not those of keys.
struct RateRows {
  std::vector<Decimal> exact_times{};    ///< [s], strictly increasing
  std::vector<Eigen::Vector3d> rates{};  ///< [rad/s], body frame
  std::vector<std::uint32_t> lines{};    ///< of the file, from 1
  std::vector<Warning> warnings{};       ///< `time_unit_by_size`, `commented_header`
};

/// A recording in a file, from 1, or all of them.
inline constexpr std::size_t all_sessions = 0;

/// How a file of keyframes is to be read.
struct ReadOptions {
  /// Null: the one with the extension of the file; where several have it, or none has, by content: EuRoC by its header,
  /// TUM by 8 numbers separated by blanks, else CSV.
  const FormatInfo* format = nullptr;
  /// Canonical name to name in the header. A name here is believed: `wx` is taken as a body rate.
  ColumnNames columns{};
  /// For CSV without a header: t, the quaternion in this order, then px, py, pz where the rows have 8 cells.
  std::optional<QuaternionOrder> order{};
  /// For CSV with a header: which columns state the orientation, and how.
  OrientationReading orientation{};
  /// Seconds per unit of the time column, greater than 0. Absent: by the suffix of its name, else 1; of EuRoC 1e-9.
  std::optional<Fraction> time_scale{};
  /// For columns that count frames, and for times of ISO 8601, which are seconds whatever the unit of the column.
  Clock clock{};
  /// The file holds world to body (C-kernels of SPICE; CCSDS attitude with the spacecraft as frame A and direction A2B,
  /// or the reverse of both): orientations are conjugated. Positions and rates are not touched: whichever way
  /// the orientation is written, the body turns as it does, and `wx` is its rate in its own frame.
  bool conjugate = false;
  /// The poses of the file take the world into the body, x_body = R x_world + p (COLMAP): orientations are conjugated,
  /// and positions become those of the body, -Rᵀp. Rates are not touched, as with `conjugate`, which it is instead of.
  bool inverse_poses = false;
  /// Applied last, to all that the rows state, and to what their recipe does.
  FrameChange frames{};
  /// Rates that are read where they are there, up to this order: 0 none, 1 `wx,wy,wz`, 2 and `ax,ay,az`, 3 and
  /// `jx,jy,jz`. A fault in the columns of others is no fault of the file.
  int rate_orders = 1;
  /// Read `wx_world,…` where there are none in the body frame, and turn them into it.
  bool world_rates = false;
  bool inner_quaternions = false;             ///< read `a_qw,…` and `b_qw,…` where they are there
  FreeRates free_rates = FreeRates::allowed;  ///< what a rate without numbers in its cells is
  UnposedRows unposed_rows = UnposedRows::refused;
  bool drop_duplicates = false;  ///< of equal times keep the first
  bool drop_invalid = false;     ///< drop rows where a cell that is needed is empty, NaN or infinite
  bool sort = false;             ///< by time; rows of equal time keep their order
  /// The rows are a set, not a motion: a column of times is not needed, what it has does not count, and the n-th key
  /// has the time n [s], from 0.
  bool count_rows = false;
  bool no_positions = false;  ///< whatever columns there are
  /// Which of several recordings that stand one behind the other: the next begins where a block of rows goes back in
  /// time. `all_sessions`: each is a track.
  std::optional<std::size_t> session{};
  /// Intervals longer than this [s] are gaps, which no curve bridges; absent: those that the file's recipe states.
  std::optional<double> gap{};
  /// Two rows of one time that differ are a jump of the motion, where a stretch ends and the next one begins; the
  /// file's recipe may say so too. With `drop_duplicates` only rows that repeat the one before are dropped.
  bool jumps = false;
  /// Euler angles mean the turns that they state: a step of which a quaternion can hold less gets rows in between.
  bool count_turns = false;
  bool keep_exact_times = false;
  bool keep_as_read = false;  ///< orientations with the norms and signs of the file, for read_track()
  bool keep_table = false;
  RecipeUse recipe = RecipeUse::honoured;
  Norms norms = Norms::near_one;
  SceneTrack scene{};
  /// Parameters that are read where a column has their name.
  std::vector<std::string> parameters{};
};

/// Rows that the repairs touched.
struct RepairReport {
  std::size_t duplicates_dropped = 0;
  std::size_t invalid_dropped = 0;
  std::size_t rows_moved = 0;
  std::size_t normalised = 0;            ///< quaternions farther than `norm_error_limit` from norm 1
  double largest_norm_error = 0.0;       ///< of those
  std::size_t rates_left_free = 0;       ///< keys of which a rate that is read has no numbers; nothing is changed there
  double largest_matrix_distance = 0.0;  ///< of matrices that became the nearest rotations, by Frobenius' norm
  /// How far rows that were dropped as duplicates are from those that are kept [rad], [m].
  double largest_duplicate_turn = 0.0, largest_duplicate_distance = 0.0;
  std::size_t rows_between = 0;  ///< that were added where Euler angles turn by more than a quaternion can hold
};

/// What a file of keyframes holds.
struct KeyFile {
  std::string path{};
  const FormatInfo* format = &csv_format;
  Recipe recipe{};                                                       ///< of the curve that the keys are for
  Decimal epoch{};                                                       ///< time of the first key [s], exact
  KeyframeData data{};                                                   ///< times are relative to `epoch` [s]
  PositionTrack positions_apart{};                                       ///< of rows without orientations
  std::vector<std::uint32_t> lines{};                                    ///< 1-based line of each key
  std::map<std::string, std::vector<double>, std::less<>> parameters{};  ///< one value per key
  RepairReport repairs{};
  std::optional<EulerTurns> turns{};           ///< what is lost of those that Euler angles state, up to these keys
  EulerOrder euler{};                          ///< of these angles
  std::vector<Decimal> exact_times{};          ///< [s], of each key; only if asked for
  KeyTable table{};                            ///< the cells of each key; only if asked for
  RateRows unposed{};                          ///< rows without an orientation; only if asked for
  std::vector<std::string> ignored_columns{};  ///< that nothing was read from
  std::vector<Warning> warnings{};             ///< of reading
};

/// Error (bad_argument): frames that contradict each other, and orientations that are turned back twice.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_frames(const ReadOptions& options);

/// How many recordings stand one behind the other in a file that can be read again. Errors: those of read_keys().
[[nodiscard]] ORISPLINE_EXPORT Expected<std::size_t> sessions_in(const Input& input, const ReadOptions& options);

/// Reads the keyframes of a file of one track.
///
/// Times are strictly increasing and all numbers finite, norms near 1 unless they are left as they are; signs are left
/// to `Keyframes::make`.
/// Errors name the file, the line and the column or the key: bad_access, bad_data, and bad_argument for options that
/// contradict the file.
[[nodiscard]] ORISPLINE_EXPORT Expected<KeyFile> read_keys(const Input& input, const ReadOptions& options = {});

[[nodiscard]] ORISPLINE_EXPORT Expected<KeyFile> read_keys(KeyInput input, const ReadOptions& options);

/// Reads the keyframes of every track in a file, one at least.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<KeyFile>> read_all_keys(const Input& input,
                                                                            const ReadOptions& options = {});

[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<KeyFile>> read_all_keys(KeyInput input, const ReadOptions& options);

/// The error with the file and, where it names a key, the line.
[[nodiscard]] ORISPLINE_EXPORT Error located(const KeyFile& file, Error error);

}}}  // namespace orispline::io
