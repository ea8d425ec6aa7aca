// SPDX-License-Identifier: Apache-2.0
#ifndef ORISPLINE_H
#define ORISPLINE_H

#include <stddef.h>
#include <stdint.h>

// Smooth orientation curves through keyframes, for every language that can call C: handles, flat arrays, texts.
//
// QUATERNIONS are Hamilton's and take the body's frame into the world's; q and -q are one orientation. Their order is
// never guessed: a function that takes or gives them takes an `orispline_order`. Of several they lie row after row.
// UNITS are s, rad, rad/s, rad/s², rad/s³, m, m/s, m/s², m/s³. Times count from the keys' own epoch. Angular rates are
// in the body frame unless a name ends in `_world`; positions and their rates are in the world frame.
// TEXTS are UTF-8 and end in NUL. A method is its text, `timed-c2:tension=0.6:ends=natural`; an option is
// `name=value`, as people type it: `tolerance=0.1deg`. What there is to be typed is told by orispline_methods_json()
// and orispline_tasks_json(), so that no new method, option or task changes this header.
//
// ERRORS. A function that can fail returns a code, ORISPLINE_OK or another one, and takes `error` last: null, or where
// a new error goes, which the caller frees. On success *error is not touched. After a failure handles and texts that
// would have been made are null, and all other memory that the caller gave for results holds nothing of use. Null
// pointers, handles of another kind, lengths that do not fit and numbers that are none are errors
// (ORISPLINE_BAD_ARGUMENT or ORISPLINE_BAD_DATA); so is a handle that was freed, as long as no other one has taken its
// place. No C++ exception leaves a function.
//
// WHO FREES WHAT. Each kind of handle has an orispline_…_free(), which takes null too. A `char **` result is freed by
// orispline_text_free(). A `const char *` that is returned belongs to the handle it was asked of, and lives as long.
// A handle needs no other one: keys may be freed while curves through them live. Arrays of the caller are read or
// written during the call only.
//
// THREADS. Handles never change once they are made: any number of calls may use one at once, but for the one that frees
// it. Memory that is written belongs to one call at a time.

#if defined(_WIN32) && defined(ORISPLINE_C_BUILDING)
#define ORISPLINE_C_API __declspec(dllexport)
#elif defined(_WIN32)
#define ORISPLINE_C_API __declspec(dllimport)
#else
#define ORISPLINE_C_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

// ---- The library ----------------------------------------------------------------------------------------------------

/// Functions and structs of this number keep their meaning; others may join them.
#define ORISPLINE_C_ABI 1

/// That of the library which is there: a program that finds another number than ORISPLINE_C_ABI must not go on.
ORISPLINE_C_API int32_t orispline_abi(void);
/// `0.3.0`. It is never freed.
ORISPLINE_C_API const char *orispline_version(void);

/// Frees a text or bytes that a function of this header made. Null is nothing.
ORISPLINE_C_API void orispline_text_free(char *text);

// ---- Errors ---------------------------------------------------------------------------------------------------------

typedef int32_t orispline_code;
enum {
  ORISPLINE_OK = 0,
  ORISPLINE_BAD_DATA = 1,       ///< the keys, or the content of a file
  ORISPLINE_BAD_ARGUMENT = 2,   ///< a method, an option, a pointer or a number of the caller
  ORISPLINE_NOT_CONVERGED = 3,  ///< equations of a method, which have no solution that it could find for these keys
  ORISPLINE_BAD_ACCESS = 4,     ///< something that cannot be opened, read or written
  ORISPLINE_CANCELLED = 5,      ///< a task that was asked to stop
  ORISPLINE_NO_MEMORY = 6,      ///< memory ran out; nothing has leaked
  ORISPLINE_FAULT = 7           ///< a fault of the library, to be reported
};

typedef struct orispline_error orispline_error;

/// Functions of an error take null, of which they say ORISPLINE_OK, "" and -1.
ORISPLINE_C_API orispline_code orispline_error_code(const orispline_error *error);
/// One sentence: what was found, and what was wanted. Without the place.
ORISPLINE_C_API const char *orispline_error_message(const orispline_error *error);
/// One line for people, with the place: `keys.csv:4: key 2: duplicate time 1.5, …`.
ORISPLINE_C_API const char *orispline_error_text(const orispline_error *error);
/// The option or the argument that is at fault: `tolerance`; empty where there is none.
ORISPLINE_C_API const char *orispline_error_option(const orispline_error *error);
/// The option that would mend it: `drop_duplicates`; empty where there is none.
ORISPLINE_C_API const char *orispline_error_remedy(const orispline_error *error);
/// The name of the file, empty where there is none.
ORISPLINE_C_API const char *orispline_error_file(const orispline_error *error);
/// Of the file, from 1, the header counted; -1 where there is none.
ORISPLINE_C_API int64_t orispline_error_line(const orispline_error *error);
/// Of the table, from 1; -1 where there is none.
ORISPLINE_C_API int64_t orispline_error_column(const orispline_error *error);
/// The key, from 0; -1 where none is at fault.
ORISPLINE_C_API int64_t orispline_error_key(const orispline_error *error);
/// Which of the times that were asked for, from 0; -1 where none is at fault.
ORISPLINE_C_API int64_t orispline_error_time(const orispline_error *error);
ORISPLINE_C_API void orispline_error_free(orispline_error *error);

// ---- Keys -----------------------------------------------------------------------------------------------------------

/// The order of the four numbers of a quaternion. 0 is none, so that who forgets it is told.
typedef int32_t orispline_order;
enum { ORISPLINE_WXYZ = 1, ORISPLINE_XYZW = 2 };

typedef int32_t orispline_signs;
enum {
  ORISPLINE_SHORTEST = 0,  ///< from key to key the short way round
  ORISPLINE_AS_GIVEN = 1   ///< the signs of the quaternions say which way round, up to a full turn a step
};

/// What keys have beside their times and orientations, a row for every key.
///
/// | name                     | numbers a row | what                                                                   |
/// |--------------------------|---------------|------------------------------------------------------------------------|
/// | `positions`              | 3             | [m], world                                                             |
/// | `angular_velocities`     | 3             | [rad/s], body; a row of NaN is left to the method, here and below      |
/// | `angular_accelerations`  | 3             | [rad/s²], body                                                         |
/// | `angular_jerks`          | 3             | [rad/s³], body                                                         |
/// | `inner_leaving`          | 4             | inner quaternion of `squad` on the segment that leaves the key         |
/// | `inner_arriving`         | 4             | that on the segment that arrives at it; both in the keys' order        |
/// | any other: `tension`, …  | 1             | the setting of that name, which a method takes where its text is silent |
typedef struct orispline_column {
  const char *name;
  const double *numbers;  ///< as many rows as there are keys
  size_t count;           ///< of numbers: keys times numbers a row
} orispline_column;

typedef struct orispline_keys orispline_keys;

/// Keys of the caller's arrays, which are copied.
///
/// `times`: `count` of them [s], finite and increasing. `orientations`: 4 * `count` numbers, norms within 1e-3 of 1.
/// `columns` may be null where `column_count` is 0. Errors: ORISPLINE_BAD_DATA with the key; ORISPLINE_BAD_ARGUMENT
/// with the name of a column as the option.
ORISPLINE_C_API orispline_code orispline_keys_make(const double *times, const double *orientations, size_t count,
                                                   orispline_order order, orispline_signs signs,
                                                   const orispline_column *columns, size_t column_count,
                                                   orispline_keys **keys, orispline_error **error);

/// How many there are; 0 of null and of what is no keys.
ORISPLINE_C_API size_t orispline_keys_count(const orispline_keys *keys);

/// Copies a column: `times`, `orientations`, or one of those above. `count`: of numbers that there is room for, which
/// must be keys times numbers a row. Quaternions have the signs that the curve follows, rates that are free are NaN.
/// `order` may be 0 where the column has no quaternions. Error: ORISPLINE_BAD_ARGUMENT for a column that they lack.
ORISPLINE_C_API orispline_code orispline_keys_column(const orispline_keys *keys, const char *name,
                                                     orispline_order order, double *numbers, size_t count,
                                                     orispline_error **error);

/// JSON of what they are: `count`, `columns` (each with `name` and `width`), `name`, `epoch` [s] as a text, the
/// `method` that they are for or null, and what checking them changed: `sign_flips`, `non_unit_keys`, `largest_norm_error`,
/// `near_half_turns`. Of keys that were read also `format`, `repairs`, `ignored_columns` and `warnings`.
ORISPLINE_C_API orispline_code orispline_keys_json(const orispline_keys *keys, char **json, orispline_error **error);

ORISPLINE_C_API void orispline_keys_free(orispline_keys *keys);

// ---- Curves ---------------------------------------------------------------------------------------------------------

typedef struct orispline_curve orispline_curve;

/// The curve of a method through the keys, with the path of its kind where they have positions.
///
/// `method`: its text; null: the method that the keys are for, else `auto`. Errors: ORISPLINE_BAD_ARGUMENT for a method
/// or a setting that there is not, with the one that is spelt most like it, or of another number of values than keys;
/// ORISPLINE_BAD_DATA for too few keys; ORISPLINE_NOT_CONVERGED.
ORISPLINE_C_API orispline_code orispline_curve_make(const orispline_keys *keys, const char *method,
                                                    orispline_curve **curve, orispline_error **error);

/// The first and the last time [s] at which it is defined.
ORISPLINE_C_API orispline_code orispline_curve_domain(const orispline_curve *curve, double *start, double *end,
                                                      orispline_error **error);

/// The text of its method, with the settings that the keys have brought along.
ORISPLINE_C_API orispline_code orispline_curve_method(const orispline_curve *curve, char **text,
                                                      orispline_error **error);

/// 1 where it has positions, else 0; 0 of null and of what is no curve.
ORISPLINE_C_API int32_t orispline_curve_has_positions(const orispline_curve *curve);

/// The orientation at a time [s], to 4 numbers in `order`. Outside it is that of the end; a NaN gives NaN. Allocates
/// nothing: for players, which ask at every frame.
ORISPLINE_C_API orispline_code orispline_curve_orientation(const orispline_curve *curve, double time,
                                                           orispline_order order, double *orientation,
                                                           orispline_error **error);

/// The side of a time at which rates may jump.
typedef int32_t orispline_side;
enum { ORISPLINE_RIGHT = 0, ORISPLINE_LEFT = 1 };

/// How the body moves at one time: 25 numbers without a gap. Positions and their rates are NaN where there are none.
typedef struct orispline_motion {
  double orientation[4];           ///< in the order that was asked for
  double angular_velocity[3];      ///< [rad/s], body
  double angular_acceleration[3];  ///< [rad/s²], body
  double angular_jerk[3];          ///< [rad/s³], body
  double position[3];              ///< [m], world, as all below
  double velocity[3];              ///< [m/s]
  double acceleration[3];          ///< [m/s²]
  double jerk[3];                  ///< [m/s³]
} orispline_motion;

/// The motion at a time [s]. At a key inside the curve it is that of the segment to the `side`; outside the body rests
/// at the end; a NaN gives NaN. Allocates nothing.
ORISPLINE_C_API orispline_code orispline_curve_motion(const orispline_curve *curve, double time, orispline_side side,
                                                      orispline_order order, orispline_motion *motion,
                                                      orispline_error **error);

ORISPLINE_C_API void orispline_curve_free(orispline_curve *curve);

// ---- Samples --------------------------------------------------------------------------------------------------------

typedef int32_t orispline_quantity;
enum {
  ORISPLINE_ORIENTATION = 0,                 ///< 4 numbers in the order that is asked for; all others have 3
  ORISPLINE_ANGULAR_VELOCITY = 1,            ///< [rad/s], body
  ORISPLINE_ANGULAR_ACCELERATION = 2,        ///< [rad/s²], body
  ORISPLINE_ANGULAR_JERK = 3,                ///< [rad/s³], body
  ORISPLINE_ANGULAR_VELOCITY_WORLD = 4,      ///< [rad/s], world
  ORISPLINE_ANGULAR_ACCELERATION_WORLD = 5,  ///< [rad/s²], world
  ORISPLINE_ANGULAR_JERK_WORLD = 6,          ///< [rad/s³], world
  ORISPLINE_POSITION = 7,                    ///< [m], world, as all below
  ORISPLINE_VELOCITY = 8,                    ///< [m/s]
  ORISPLINE_ACCELERATION = 9                 ///< [m/s²]
};

typedef int32_t orispline_type;
enum { ORISPLINE_DOUBLE = 0, ORISPLINE_FLOAT = 1 };

/// Where one quantity of all samples goes. Several may lie in one array, each with its own place and the same stride.
typedef struct orispline_output {
  orispline_quantity quantity;
  orispline_type type;  ///< of all numbers of this output: float samples are made in float
  void *numbers;        ///< double or float, whose first one is the first number of the first sample
  size_t stride;        ///< numbers from the beginning of a sample to that of the next; 0: its own 3 or 4
} orispline_output;

/// Samples at `count` even times: the k-th at k * step + start [s], computed as written; `step` may not be negative.
///
/// `order`: of the quaternions, if there are any. `beyond`: what times outside the curve get, `hold`, `error`, `nan`,
/// `rate` or `segment` (docs/conventions.md); null: `hold`. `threads`: at most so many at work; 0: one per core. The
/// numbers do not depend on them, nor on the processor. At a key they are those of the segment to the right. No sample
/// is made of `count` 0.
ORISPLINE_C_API orispline_code orispline_sample_even(const orispline_curve *curve, double start, double step,
                                                     size_t count, orispline_order order, const char *beyond,
                                                     uint32_t threads, const orispline_output *outputs,
                                                     size_t output_count, orispline_error **error);

/// Samples at given times [s], in any order; those in order are faster. All else as above. An error of one time has its
/// place among them.
ORISPLINE_C_API orispline_code orispline_sample_at(const orispline_curve *curve, const double *times, size_t count,
                                                   orispline_order order, const char *beyond, uint32_t threads,
                                                   const orispline_output *outputs, size_t output_count,
                                                   orispline_error **error);

// ---- What a curve is worth ------------------------------------------------------------------------------------------

/// How far a rate jumps where segments meet.
typedef struct orispline_jump {
  double largest;   ///< in the unit of the rate
  double relative;  ///< to the largest rate of the curve; 0 where every jump is rounding
  int64_t key;      ///< where
} orispline_jump;

typedef struct orispline_continuity {
  int64_t order;  ///< no rate up to this order jumps at the keys: 0 to 3; -1 where the orientation itself jumps
  orispline_jump angular_velocity, angular_acceleration, angular_jerk;  ///< [rad/s], [rad/s²], [rad/s³]
  double orientation_jump;                                             ///< the largest at and between keys [rad]; 0: none
  double orientation_jump_time;                                        ///< where [s]
} orispline_continuity;

/// The order of continuity in time that the curve really has at its keys, and how far its rates jump there.
ORISPLINE_C_API orispline_code orispline_curve_continuity(const orispline_curve *curve, orispline_continuity *found,
                                                          orispline_error **error);

/// The order that is reached at each key, by the same measure: 3 at the ends, but for those of a loop, which are one
/// place, and at keys where no segments meet, such as control points; -1 where the orientation jumps there or before
/// the next key. `count`: of numbers that there is room for, which must be the number of keys.
ORISPLINE_C_API orispline_code orispline_curve_orders(const orispline_curve *curve, int32_t *orders, size_t count,
                                                      orispline_error **error);

typedef struct orispline_peak {
  double value, time;  ///< in its unit, and where [s]
} orispline_peak;

typedef struct orispline_peaks {
  orispline_peak angular_velocity;      ///< [rad/s]
  orispline_peak angular_acceleration;  ///< [rad/s²]
  orispline_peak torque;                ///< [N m]; NaN without an inertia
} orispline_peaks;

/// The largest rates of the curve that were found. `inertia`: null, or the 9 numbers [kg m²] of a symmetric matrix,
/// about the centre of mass in the body frame.
ORISPLINE_C_API orispline_code orispline_curve_peaks(const orispline_curve *curve, const double *inertia,
                                                     orispline_peaks *found, orispline_error **error);

/// The same, with what each of the rates is nowhere above: three `bounds` in the order of the peaks, in their units, NaN
/// where no bound is known.
ORISPLINE_C_API orispline_code orispline_curve_bounded_peaks(const orispline_curve *curve, const double *inertia,
                                                             orispline_peaks *found, double *bounds,
                                                             orispline_error **error);

/// JSON: the list of what is to be said of the curve, as in the documents of the command: each has a `code` for programs
/// and a `message` for people, where it has a place `line` and `key`, and the numbers of the message by their names.
ORISPLINE_C_API orispline_code orispline_curve_warnings(const orispline_curve *curve, char **json,
                                                        orispline_error **error);

// ---- Progress -------------------------------------------------------------------------------------------------------

/// Told the share of a task that is done, from 0 to 1; any other number than 0 asks the task to stop, which then soon
/// fails with ORISPLINE_CANCELLED, unless all was done. Called by one thread at a time, which need not be the caller's.
/// `context`: as it was given.
typedef int32_t (*orispline_progress)(double share, void *context);

// ---- Baking ---------------------------------------------------------------------------------------------------------

/// A curve as polynomials, to be stored and played: each of the four components of the quaternion is one of degree 9
/// (float: 5) on every piece.
typedef struct orispline_baked orispline_baked;

/// Bakes a curve so that no sample is farther from it than `tolerance` [rad], at least 1e-13 (float: 1e-6). `progress`
/// may be null. Errors: ORISPLINE_BAD_ARGUMENT for another tolerance and, with the key, for one that cannot be reached;
/// ORISPLINE_CANCELLED.
ORISPLINE_C_API orispline_code orispline_bake(const orispline_curve *curve, double tolerance, orispline_type type,
                                              orispline_progress progress, void *context, orispline_baked **baked,
                                              orispline_error **error);

/// What a baked curve is made of. The numbers belong to the handle.
///
/// At a time t of piece i, ends[i] <= t < ends[i + 1], the quaternion has the components
/// c(s) = coefficients[0] + coefficients[1] s + … with s = (t - scales[2 i]) * scales[2 i + 1]; they are x, y, z, w
/// one after another, each with `degree` + 1 coefficients. Its norm is 1 within the tolerance.
typedef struct orispline_baked_parts {
  const double *ends;         ///< `pieces` + 1 times [s]; of a curve of a single key its one time
  const double *scales;       ///< 2 a piece: the middle [s], and what its times are multiplied by [1/s]
  const void *coefficients;   ///< 4 * (degree + 1) a piece, of its type
  size_t end_count;           ///< of `ends`
  size_t pieces;              ///< 1 at least
  int32_t degree;             ///< 9 or 5
  orispline_type type;
  double largest_difference;  ///< from the curve, as it was found [rad]
} orispline_baked_parts;

ORISPLINE_C_API orispline_code orispline_baked_look(const orispline_baked *baked, orispline_baked_parts *parts,
                                                    orispline_error **error);

/// The baked curve of parts that were stored, which are copied. Errors: ORISPLINE_BAD_DATA for parts whose orientations
/// are not finite on all of a piece, and for another number of pieces, before they are read; ORISPLINE_BAD_ARGUMENT.
ORISPLINE_C_API orispline_code orispline_baked_make(const orispline_baked_parts *parts, orispline_baked **baked,
                                                    orispline_error **error);

/// Its samples at given times [s], as those of a curve: orientations and angular rates, of the type of its
/// coefficients. Outside its ends are held, at rest.
ORISPLINE_C_API orispline_code orispline_baked_sample_at(const orispline_baked *baked, const double *times,
                                                         size_t count, orispline_order order,
                                                         const orispline_output *outputs, size_t output_count,
                                                         orispline_error **error);

ORISPLINE_C_API void orispline_baked_free(orispline_baked *baked);

/// The text of the .json that `orispline bake` writes and the player of the npm package plays: orientations within
/// `tolerance` [rad], at least 1e-6, and where there are positions these within `position_tolerance` [m]. Its times are
/// those of the curve. To be freed by orispline_text_free(). Errors: ORISPLINE_BAD_ARGUMENT for other tolerances and,
/// with the key, for one that cannot be reached.
ORISPLINE_C_API orispline_code orispline_bake_text(const orispline_curve *curve, double tolerance,
                                                   double position_tolerance, char **text, orispline_error **error);

// ---- Methods --------------------------------------------------------------------------------------------------------

/// JSON: the list of all methods, as of `orispline methods --json`.
ORISPLINE_C_API orispline_code orispline_methods_json(char **json, orispline_error **error);

/// The text of a method as it is written, with all defaults left out; what there is not is an error.
ORISPLINE_C_API orispline_code orispline_method_text(const char *method, char **text, orispline_error **error);

// ---- Tasks ----------------------------------------------------------------------------------------------------------

/// JSON: the list of all tasks with their inputs, options and results, as of `orispline tasks --json`.
ORISPLINE_C_API orispline_code orispline_tasks_json(char **json, orispline_error **error);

/// Keys or a recording for a task, by the name that it has for them: `keys`, `recording`, `reference`, `moved`, …
/// Several of one name where the task takes several.
typedef struct orispline_input {
  const char *name;
  const orispline_keys *keys;
} orispline_input;

typedef struct orispline_outcome orispline_outcome;

/// What a task takes or makes: keys, the rates of a gyro on a clock of its own, or a skeleton with its clips.
typedef struct orispline_value orispline_value;

typedef int32_t orispline_kind;
enum { ORISPLINE_KEYS = 1, ORISPLINE_RATES = 2, ORISPLINE_SKELETON = 3 };

/// Keys as a value, which shares them.
ORISPLINE_C_API orispline_code orispline_value_of_keys(const orispline_keys *keys, orispline_value **value,
                                                       orispline_error **error);

/// The rates of a gyro, which are copied.
///
/// `times`: `count` of them [s], of the gyro's own clock, increasing. `rates`: 3 * `count` numbers [rad/s] in the frame
/// of the gyro, x, y, z one after another. `epoch`: what the times count from [s] as a decimal number, which is exact,
/// such as the `epoch` of the keys; null: 0. Error: ORISPLINE_BAD_ARGUMENT for an epoch that is no number. Times and
/// rates are checked by the task.
ORISPLINE_C_API orispline_code orispline_value_of_rates(const double *times, const double *rates, size_t count,
                                                        const char *epoch, orispline_value **value,
                                                        orispline_error **error);

/// The skeleton with its clips of a file that is in memory, of glTF (.gltf, .glb) or BVH.
///
/// `name`: that it would have, for messages, and whose extension names the format. `options`: `clip=NAME` for some of
/// the clips, once for each; `drop_duplicates` keeps the first of keys at equal times; `signs=shortest` lets cubic
/// rotations whose signs flip go the short way, `signs=as-given` the way that they say; `salvage` takes the whole
/// frames of a BVH file that was cut off; `rest_frame=N` the pose of that frame of one, from 0, as the rest pose. Errors: ORISPLINE_BAD_DATA; ORISPLINE_BAD_ARGUMENT for a name of no such
/// format, and with the option.
ORISPLINE_C_API orispline_code orispline_value_of_skeleton(const void *bytes, size_t size, const char *name,
                                                           const char *const *options, size_t option_count,
                                                           orispline_value **value, orispline_error **error);

/// What it is; 0 of null and of what is no value.
ORISPLINE_C_API orispline_kind orispline_value_kind(const orispline_value *value);
/// How many keys, rates or clips it has; 0 of null and of what is no value.
ORISPLINE_C_API size_t orispline_value_count(const orispline_value *value);

/// JSON of what it is: `kind`, `count`, of keys and rates their `epoch` [s] as a text, of keys and skeletons their
/// `name`, of skeletons also `format`, the names of the `joints` and the `clips`, and the `warnings` of reading.
ORISPLINE_C_API orispline_code orispline_value_json(const orispline_value *value, char **json,
                                                    orispline_error **error);

/// Its keys, as a handle of the caller. Error: ORISPLINE_BAD_ARGUMENT where it has none.
ORISPLINE_C_API orispline_code orispline_value_keys(const orispline_value *value, orispline_keys **keys,
                                                    orispline_error **error);

/// Copies its rates: `count` times [s] since its epoch, and 3 * `count` numbers [rad/s] in the frame of the gyro.
/// `count` must be that of the rates. Error: ORISPLINE_BAD_ARGUMENT where it has none.
ORISPLINE_C_API orispline_code orispline_value_rates(const orispline_value *value, double *times, double *rates,
                                                     size_t count, orispline_error **error);

/// The bytes of a file of its skeleton and clips, `size` of them, to be freed as a text is. What the file that it was
/// read from held besides is passed on where the format is the same.
///
/// `name`: as of orispline_value_of_skeleton(). `options`: of BVH, `output_euler=ZYX` and `rate=30`, frames per second
/// for keys at uneven times; of glTF, `position_scale=0.01`, the metres in the unit of length of a BVH file that was
/// read, so that lengths are written in metres, and `compress=meshopt`. `warnings`: null, or where their JSON goes: what the format has no room for is left out,
/// and they say so. Errors: ORISPLINE_BAD_ARGUMENT; ORISPLINE_BAD_DATA for what the format cannot hold.
ORISPLINE_C_API orispline_code orispline_value_write(const orispline_value *value, const char *name,
                                                     const char *const *options, size_t option_count, char **bytes,
                                                     size_t *size, char **warnings, orispline_error **error);

ORISPLINE_C_API void orispline_value_free(orispline_value *value);

/// A value for a task, by the name that the task has for it.
typedef struct orispline_named_value {
  const char *name;
  const orispline_value *value;
} orispline_named_value;

/// Runs a task on keys: `smooth`, `tune`, `reduce`, `retime`, `bake`, `mean`, `align`, `compare` or `inspect`, and what
/// else there is. orispline_task_run_with() runs it on rates of a gyro and on skeletons too.
///
/// `options`: texts, `tolerance=0.1deg`; what stands in none is at its default. `progress` may be null. Errors:
/// ORISPLINE_BAD_ARGUMENT for a task, an input or an option that there is not, with the option; those of the task.
ORISPLINE_C_API orispline_code orispline_task_run(const char *task, const orispline_input *inputs, size_t input_count,
                                                  const char *const *options, size_t option_count,
                                                  orispline_progress progress, void *context,
                                                  orispline_outcome **outcome, orispline_error **error);

/// Runs a task on values of any kind: what orispline_tasks_json() lists as `kinds` of an input. All else as above.
/// `difference` compares the motions of two skeletons; a gyro beside the recording of `smooth` is its input `gyro`.
ORISPLINE_C_API orispline_code orispline_task_run_with(const char *task, const orispline_named_value *inputs,
                                                       size_t input_count, const char *const *options,
                                                       size_t option_count, orispline_progress progress, void *context,
                                                       orispline_outcome **outcome, orispline_error **error);

/// JSON, described in docs/inspect-json.md, but for the names of files and the warnings. Null of what is no outcome, as
/// of the three below.
ORISPLINE_C_API const char *orispline_outcome_document(const orispline_outcome *outcome);
/// Sentences for people, in lines.
ORISPLINE_C_API const char *orispline_outcome_summary(const orispline_outcome *outcome);
/// They in one line, without an end; empty where a task has none.
ORISPLINE_C_API const char *orispline_outcome_line(const orispline_outcome *outcome);
/// JSON: the list of warnings, as of orispline_curve_warnings().
ORISPLINE_C_API const char *orispline_outcome_warnings(const orispline_outcome *outcome);
/// How many tracks there are: 1 of most tasks, as many as recordings of `reduce`, 0 of `bake`, `compare`, `difference`
/// and `inspect`, and where gyros or skeletons were made.
ORISPLINE_C_API size_t orispline_outcome_track_count(const orispline_outcome *outcome);
/// One of them, from 0, as keys of the caller. Where it is for the curve of a method it names it, so that
/// orispline_curve_make() with a null method makes this curve.
ORISPLINE_C_API orispline_code orispline_outcome_track(const orispline_outcome *outcome, size_t index,
                                                       orispline_keys **keys, orispline_error **error);
/// How many values it made: its tracks first, then rates of a gyro and skeletons.
ORISPLINE_C_API size_t orispline_outcome_value_count(const orispline_outcome *outcome);
/// One of them, from 0, as a value of the caller, which another task may take.
ORISPLINE_C_API orispline_code orispline_outcome_value(const orispline_outcome *outcome, size_t index,
                                                       orispline_value **value, orispline_error **error);
ORISPLINE_C_API void orispline_outcome_free(orispline_outcome *outcome);

// ---- Files in memory ------------------------------------------------------------------------------------------------

/// JSON: `formats` of keys, samples and skeletons, `reading` options and `writing` options, each with its sentence.
ORISPLINE_C_API orispline_code orispline_files_json(char **json, orispline_error **error);

/// The keys of a file that is in memory.
///
/// `name`: that it would have, for messages, and whose extension names the format. `options`: texts of
/// reading, `angle_unit=deg`, a flag by its name alone. Of skeletons (glTF, BVH) `joint` and `clip` say which track is
/// meant. Errors: ORISPLINE_BAD_DATA with the line and the column; ORISPLINE_BAD_ARGUMENT with the option.
ORISPLINE_C_API orispline_code orispline_keys_read(const void *bytes, size_t size, const char *name,
                                                   const char *const *options, size_t option_count,
                                                   orispline_keys **keys, orispline_error **error);

/// The bytes of a file of these keys, `size` of them, to be freed as a text is. `name` and `options` as above, of
/// writing. `warnings`: null, or where their JSON goes, as of orispline_curve_warnings(): what the format has no room
/// for is left out, and they say so.
ORISPLINE_C_API orispline_code orispline_keys_write(const orispline_keys *keys, const char *name,
                                                    const char *const *options, size_t option_count, char **bytes,
                                                    size_t *size, char **warnings, orispline_error **error);

#ifdef __cplusplus
}
#endif

#endif
