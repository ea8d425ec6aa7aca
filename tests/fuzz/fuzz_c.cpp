// SPDX-License-Identifier: Apache-2.0
// A program in C, as bytes: calls of every function of orispline.h, with null pointers, handles of another kind, counts
// that do not fit and numbers that are none. Arrays are exactly as long as the header says, so that sanitizers see what
// is read or written beyond them.
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <orispline.h>

#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>

namespace orispline::fuzz { namespace {

constexpr std::size_t most_numbers = 24, most_calls = 64, most_pieces = 4;
constexpr std::array methods{"auto",      "slerp",    "timed-c2:tension=0.6", "squad",         "hermite-c2",
                             "nu:nu=0.3", "measured", "auto:ends=clamped",    "auto:period=9", "none",
                             ""};
constexpr std::array tasks{"smooth", "tune",    "reduce",  "retime",     "bake", "mean",
                           "align",  "compare", "inspect", "difference", "none", ""};
constexpr std::array options{"tolerance=0.1deg",
                             "tolerance=nan",
                             "methods=auto,slerp",
                             "method=slerp",
                             "limit=0.1deg",
                             "angular_velocity=10deg/s",
                             "joint=hips",
                             "rate=30",
                             "angle_unit=deg",
                             "drop_duplicates",
                             "clip=walk",
                             "=",
                             ""};
constexpr std::array names{"keys",     "recording", "reference", "moved",    "fixed",     "gyro",
                           "first",    "second",    "rows",      "keys.csv", "keys.json", "keys.tum",
                           "walk.bvh", "walk.gltf", "walk.glb",  "x",        ""};
constexpr std::array columns{"positions",
                             "angular_velocities",
                             "angular_accelerations",
                             "angular_jerks",
                             "inner_leaving",
                             "inner_arriving",
                             "tension",
                             "times",
                             "orientations",
                             "none",
                             ""};
constexpr std::array beyond{"hold", "error", "nan", "rate", "segment", "none", ""};

void claim_text(const char* text) { claim(text != nullptr && *text != '\0', "a text that is none"); }

/// What every function promises of its error and of what it makes, by reference since the call is an argument beside.
template <class Made>
bool claim_done(orispline_code code, orispline_error*& error, const Made* made) {
  claim((code == ORISPLINE_OK) == (error == nullptr), "the code {} with{} an error", code, error ? "" : "out");
  claim(code != ORISPLINE_FAULT, "a fault: {}", orispline_error_text(error));
  if (error) {
    claim(orispline_error_code(error) == code, "an error of another code than {}", code);
    claim(is_one_printable_line(orispline_error_text(error)), "no printable line: '{}'", orispline_error_text(error));
    claim(*orispline_error_message(error) != '\0', "an error without a message");
    for (const char* text : {orispline_error_option(error), orispline_error_remedy(error), orispline_error_file(error)})
      claim(text != nullptr, "an error without a text");
    for (const std::int64_t place : {orispline_error_line(error), orispline_error_column(error),
                                     orispline_error_key(error), orispline_error_time(error)})
      claim(place >= -1, "the place {}", place);
    claim(!made || !*made, "something was made in spite of: {}", orispline_error_text(error));
  }
  orispline_error_free(error);
  return code == ORISPLINE_OK;
}

/// The handles of one kind; the first one is null.
template <class Handle, void (*Free)(Handle*)>
class Handles {
 public:
  Handles() = default;
  Handles(const Handles&) = delete;
  ~Handles() {
    for (Handle* handle : all_) Free(handle);
  }
  void add(Handle* handle) {
    if (handle) all_.push_back(handle);
  }
  void free_last() {
    if (all_.size() < 2) return Free(nullptr);
    Free(all_.back());
    all_.pop_back();
  }
  [[nodiscard]] Handle* any(FuzzInput& input) const {
    return all_[input.below(std::min<std::size_t>(all_.size(), 256))];
  }

 private:
  std::vector<Handle*> all_{nullptr};
};

class Program {
 public:
  Program(const std::uint8_t* bytes, std::size_t size) : input_(bytes, size) {}

  void run() {
    using Call = void (Program::*)();
    static constexpr std::array<Call, 25> calls{
        &Program::make_keys,  &Program::read_keys,    &Program::look_at_keys,  &Program::write_keys,
        &Program::make_curve, &Program::make_curve,   &Program::look_at_curve, &Program::move,
        &Program::sample,     &Program::sample,       &Program::judge,         &Program::bake,
        &Program::rebake,     &Program::sample_baked, &Program::lists,         &Program::method_text,
        &Program::value,      &Program::skeleton,     &Program::look_at_value, &Program::write_value,
        &Program::run_task,   &Program::run_with,     &Program::outcome,       &Program::free_one,
        &Program::other_kinds};
    for (std::size_t call = 0; call < most_calls; ++call) {
      const std::uint8_t byte = input_.byte();
      if (byte == 0) break;
      (this->*calls[byte % calls.size()])();
    }
  }

 private:
  template <std::size_t N>
  [[nodiscard]] const char* one_of(const std::array<const char*, N>& texts) {
    const std::size_t place = input_.below(N + 1);
    return place == N ? nullptr : texts[place];
  }
  [[nodiscard]] double number() {
    static constexpr std::array hostile{std::numeric_limits<double>::quiet_NaN(),
                                        std::numeric_limits<double>::infinity(),
                                        1.7e308,
                                        -1.7e308,
                                        1e200,
                                        5e-324,
                                        0.0,
                                        1.0};
    const std::uint8_t byte = input_.byte();
    return byte >= 248 ? hostile[byte - 248u] : input_.signed_unit() * std::pow(10.0, byte % 8 - 4);
  }
  [[nodiscard]] std::vector<double> numbers(std::size_t count) {
    std::vector<double> all(count);
    for (double& one : all) one = number();
    return all;
  }
  /// Mostly rising ones.
  [[nodiscard]] std::vector<double> times(std::size_t count) {
    std::vector<double> all(count);
    double time = number();
    for (double& one : all) {
      one = time;
      time += input_.below(16) ? 0.01 * (1.0 + static_cast<double>(input_.byte())) : number();
    }
    return all;
  }
  [[nodiscard]] std::vector<double> quaternions(std::size_t count) {
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d vector = input_.vector();
      Eigen::Vector4d q(vector.x(), vector.y(), vector.z(), 1.0 + input_.signed_unit());
      if (q.norm() > 0.0 && input_.below(32)) q.normalize();
      all.insert(all.end(), q.data(), q.data() + 4);
    }
    return all;
  }
  [[nodiscard]] std::int32_t small() { return static_cast<std::int32_t>(input_.below(12)) - 1; }
  [[nodiscard]] orispline_order order() {
    return static_cast<orispline_order>(input_.below(8) ? 1 + input_.below(2) : input_.below(4));
  }
  /// The array of a vector, or null.
  template <class T>
  [[nodiscard]] T* or_null(std::vector<T>& all) {
    return input_.below(32) ? all.data() : nullptr;
  }

  /// A name, and an option that is given or not.
  struct Named {
    const char* name;
    const char* option;
    std::size_t given;
  };
  [[nodiscard]] Named named() { return {one_of(names), one_of(options), input_.below(2)}; }

  void take_text(orispline_code code, orispline_error*& error, char*& text) {
    if (claim_done(code, error, &text)) claim_text(text);
    orispline_text_free(text);
  }

  void make_keys() {
    const std::size_t count = input_.below(9);
    std::vector<double> t = times(count), q = quaternions(count);
    const std::size_t beside_keys = input_.below(4) ? 0 : 1;
    std::vector<double> extra = numbers(beside_keys * (input_.below(2) ? 3 * count : count));
    const std::vector<orispline_column> beside{{one_of(columns), or_null(extra), extra.size()}};
    const double *const from = or_null(t), *const turns = or_null(q);
    const orispline_order as = order();
    const orispline_signs signs = input_.below(16) ? ORISPLINE_SHORTEST : small();
    orispline_keys* keys = nullptr;
    orispline_error* error = nullptr;
    const orispline_code code =
        orispline_keys_make(from, turns, count, as, signs, beside.data(), beside_keys, &keys, &error);
    claim_done(code, error, &keys);
    keys_.add(keys);
  }

  void read_keys() {
    FuzzInput part = input_.part(4 * (1 + input_.below(64)));
    const std::string_view bytes = part.rest();
    const std::vector<char> exact(bytes.begin(), bytes.end());
    const auto [name, option, given] = named();
    orispline_keys* keys = nullptr;
    orispline_error* error = nullptr;
    claim_done(orispline_keys_read(exact.data(), exact.size(), name, &option, given, &keys, &error), error, &keys);
    keys_.add(keys);
  }

  void look_at_keys() {
    const orispline_keys* const keys = keys_.any(input_);
    const std::size_t count = orispline_keys_count(keys), width = 1 + input_.below(4);
    std::vector<double> into(count * width);
    const char* const name = one_of(columns);
    const orispline_order as = order();
    orispline_error* error = nullptr;
    claim_done<void*>(orispline_keys_column(keys, name, as, or_null(into), into.size(), &error), error, nullptr);
    char* json = nullptr;
    error = nullptr;
    take_text(orispline_keys_json(keys, &json, &error), error, json);
  }

  /// Asks for the bytes of a file of one of the objects.
  template <class Objects, class Write>
  void write(const Objects& objects, const Write& written) {
    char *bytes = nullptr, *warnings = nullptr;
    std::size_t size = 0;
    const auto [name, option, given] = named();
    const auto* const object = objects.any(input_);
    orispline_error* error = nullptr;
    claim_done(written(object, name, &option, given, &bytes, &size, input_.below(2) ? &warnings : nullptr, &error),
               error, &bytes);
    orispline_text_free(bytes);
    orispline_text_free(warnings);
  }

  void write_keys() { write(keys_, orispline_keys_write); }

  void make_curve() {
    orispline_curve* curve = nullptr;
    orispline_error* error = nullptr;
    const orispline_keys* const keys = keys_.any(input_);
    claim_done(orispline_curve_make(keys, one_of(methods), &curve, &error), error, &curve);
    curves_.add(curve);
  }

  void look_at_curve() {
    const orispline_curve* const curve = curves_.any(input_);
    double start = 0.0, end = 0.0;
    orispline_error* error = nullptr;
    if (claim_done<void*>(orispline_curve_domain(curve, &start, &end, &error), error, nullptr))
      claim(std::isfinite(start) && start <= end, "a curve from {} to {}", start, end);
    char* text = nullptr;
    error = nullptr;
    take_text(orispline_curve_method(curve, &text, &error), error, text);
    error = nullptr;
    text = nullptr;
    take_text(orispline_curve_warnings(curve, &text, &error), error, text);
    error = nullptr;
    text = nullptr;
    take_text(orispline_bake_text(curve, 1e-3, 1e-3, &text, &error), error, text);
    claim(orispline_curve_has_positions(curve) <= 1, "positions neither there nor not");
  }

  void move() {
    const orispline_curve* const curve = curves_.any(input_);
    const double time = number();
    std::array<double, 4> q{};
    orispline_error* error = nullptr;
    if (claim_done<void*>(orispline_curve_orientation(curve, time, order(), q.data(), &error), error, nullptr))
      claim(std::isnan(time) || std::isfinite(q[0] + q[1] + q[2] + q[3]), "an orientation that is none at {}", time);
    orispline_motion motion;
    error = nullptr;
    const orispline_side side = small();
    claim_done<void*>(orispline_curve_motion(curve, time, side, order(), &motion, &error), error, nullptr);
  }

  /// Room for a few outputs, each in an array of its own.
  struct Outputs {
    std::vector<std::vector<double>> doubles{};
    std::vector<std::vector<float>> floats{};
    std::vector<orispline_output> all{};
  };

  [[nodiscard]] Outputs outputs(std::size_t samples) {
    Outputs made;
    const std::size_t count = input_.below(4);
    made.doubles.resize(count);
    made.floats.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const orispline_quantity quantity = input_.below(8) ? small() : 0;
      const std::size_t width = quantity == ORISPLINE_ORIENTATION ? 4 : 3;
      const std::size_t stride = input_.below(4) ? 0 : input_.below(8);
      const std::size_t room = samples == 0 ? 0 : (samples - 1) * (stride ? stride : width) + width;
      const bool is_float = input_.below(2) == 1;
      made.doubles[i].resize(is_float ? 0 : room);
      made.floats[i].resize(is_float ? room : 0);
      void* const numbers = is_float ? static_cast<void*>(or_null(made.floats[i])) : or_null(made.doubles[i]);
      made.all.push_back({quantity, is_float ? ORISPLINE_FLOAT : ORISPLINE_DOUBLE, numbers, stride});
    }
    return made;
  }

  void sample() {
    const orispline_curve* const curve = curves_.any(input_);
    const std::size_t count = input_.below(most_numbers);
    Outputs into = outputs(count);
    const char* const outside = one_of(beyond);
    const auto threads = static_cast<std::uint32_t>(input_.below(3));
    orispline_error* error = nullptr;
    if (input_.below(2)) {
      std::vector<double> at = input_.below(2) ? times(count) : numbers(count);
      const double* const from = or_null(at);
      claim_done<void*>(
          orispline_sample_at(curve, from, count, order(), outside, threads, into.all.data(), into.all.size(), &error),
          error, nullptr);
    } else {
      const double start = number(), step = number();
      claim_done<void*>(orispline_sample_even(curve, start, step, count, order(), outside, threads, into.all.data(),
                                              into.all.size(), &error),
                        error, nullptr);
    }
  }

  void judge() {
    const orispline_curve* const curve = curves_.any(input_);
    orispline_continuity continuity;
    orispline_error* error = nullptr;
    if (claim_done<void*>(orispline_curve_continuity(curve, &continuity, &error), error, nullptr))
      claim(-1 <= continuity.order && continuity.order <= 3, "C{}", continuity.order);
    std::vector<std::int32_t> orders(input_.below(10));
    error = nullptr;
    claim_done<void*>(orispline_curve_orders(curve, or_null(orders), orders.size(), &error), error, nullptr);
    orispline_peaks peaks;
    const std::vector<double> numbers_of_body = numbers(9);
    const double* const inertia = input_.below(2) ? nullptr : numbers_of_body.data();
    error = nullptr;
    claim_done<void*>(orispline_curve_peaks(curve, inertia, &peaks, &error), error, nullptr);
    std::array<double, 3> bounds;
    error = nullptr;
    if (!claim_done<void*>(orispline_curve_bounded_peaks(curve, inertia, &peaks, bounds.data(), &error), error,
                           nullptr))
      return;
    const std::array found{peaks.angular_velocity, peaks.angular_acceleration, peaks.torque};
    for (std::size_t i = 0; i < found.size(); ++i)
      claim(std::isnan(bounds[i]) || found[i].value <= bounds[i], "{} above its bound {}", found[i].value, bounds[i]);
  }

  void bake() {
    orispline_baked* baked = nullptr;
    orispline_error* error = nullptr;
    const double tolerance = input_.below(4) ? 1e-3 : number();
    const orispline_curve* const curve = curves_.any(input_);
    claim_done(orispline_bake(curve, tolerance, small(), &Program::stop_soon, this, &baked, &error), error, &baked);
    baked_.add(baked);
  }

  /// Parts that were looked at, changed, and of arrays of any numbers; the counts of either need not fit.
  void rebake() {
    orispline_baked_parts looked{};
    orispline_error* error = nullptr;
    claim_done<void*>(orispline_baked_look(baked_.any(input_), &looked, &error), error, nullptr);
    const std::size_t pieces = 1 + input_.below(most_pieces);
    const bool is_float = input_.below(2) == 1;
    const int degree = is_float ? 5 : 9;
    const auto coefficients = 4 * static_cast<std::size_t>(degree + 1) * pieces;
    std::vector<double> ends = times(pieces + 1), scales, all(coefficients);
    for (std::size_t i = 0; i < pieces; ++i) {
      scales.insert(scales.end(), {ends[i] / 2 + ends[i + 1] / 2, 2.0 / (ends[i + 1] - ends[i])});
      all[(4 * i + 3) * static_cast<std::size_t>(degree + 1)] = 1.0;
    }
    for (std::size_t change = input_.below(4); change > 0; --change)
      (input_.below(2) ? scales[input_.below(scales.size())] : all[input_.below(all.size())]) = number();
    std::vector<float> singles(is_float ? coefficients : 0);
    for (std::size_t i = 0; i < singles.size(); ++i)
      singles[i] = std::isfinite(all[i]) && std::abs(all[i]) < 1e38 ? static_cast<float>(all[i])
                                                                    : std::numeric_limits<float>::max();
    orispline_baked_parts parts{ends.data(),
                                scales.data(),
                                is_float ? static_cast<void*>(singles.data()) : all.data(),
                                pieces + 1,
                                pieces,
                                degree,
                                is_float ? ORISPLINE_FLOAT : ORISPLINE_DOUBLE,
                                1e-6};
    if (!input_.below(4)) parts.pieces = input_.below(8) ? pieces - 1 + input_.below(3) : ~std::size_t{0};
    if (!input_.below(16)) parts.degree = small();
    if (!input_.below(16)) parts.ends = nullptr;
    make_baked(input_.below(4) || !looked.ends ? parts : looked);
  }

  void make_baked(const orispline_baked_parts& parts) {
    orispline_baked* baked = nullptr;
    orispline_error* error = nullptr;
    claim_done(orispline_baked_make(&parts, &baked, &error), error, &baked);
    baked_.add(baked);
  }

  void sample_baked() {
    const std::size_t count = input_.below(most_numbers);
    std::vector<double> at = numbers(count);
    Outputs into = outputs(count);
    const double* const from = or_null(at);
    const orispline_baked* const baked = baked_.any(input_);
    orispline_error* error = nullptr;
    if (!claim_done<void*>(
            orispline_baked_sample_at(baked, from, count, order(), into.all.data(), into.all.size(), &error), error,
            nullptr))
      return;
    for (std::size_t i = 0; i < into.all.size(); ++i) {
      const auto& [quantity, type, numbers, stride] = into.all[i];
      if (quantity != ORISPLINE_ORIENTATION && type == ORISPLINE_FLOAT) continue;  // rates have no bound in float
      const auto width = quantity == ORISPLINE_ORIENTATION ? 4u : 3u;
      for (std::size_t k = 0; k < count && numbers; ++k)
        for (std::size_t j = 0; j < width; ++j) {
          const std::size_t place = k * (stride ? stride : width) + j;
          const double value =
              type == ORISPLINE_FLOAT ? static_cast<double>(into.floats[i][place]) : into.doubles[i][place];
          claim(std::isnan(at[k]) || std::isfinite(value), "the baked curve gives {} at {} s", value, at[k]);
        }
    }
  }

  void lists() {
    claim(orispline_abi() == ORISPLINE_C_ABI, "another ABI");
    claim_text(orispline_version());
    for (const auto list : {&orispline_methods_json, &orispline_tasks_json, &orispline_files_json}) {
      char* json = nullptr;
      orispline_error* error = nullptr;
      take_text(list(&json, &error), error, json);
      error = nullptr;
      claim_done<void*>(list(nullptr, &error), error, nullptr);
    }
  }

  void method_text() {
    char* text = nullptr;
    orispline_error* error = nullptr;
    FuzzInput part = input_.part(input_.below(32));
    const std::string typed(part.rest());
    take_text(orispline_method_text(input_.below(2) ? one_of(methods) : typed.c_str(), &text, &error), error, text);
  }

  void value() {
    orispline_value* value = nullptr;
    orispline_error* error = nullptr;
    if (input_.below(2)) {
      claim_done(orispline_value_of_keys(keys_.any(input_), &value, &error), error, &value);
    } else {
      const std::size_t count = input_.below(most_numbers);
      std::vector<double> t = times(count), rates = numbers(3 * count);
      static constexpr std::array epochs{"0", "1700000000.5", "-1e300", "x", ""};
      const double *const from = or_null(t), *const turns = or_null(rates);
      claim_done(orispline_value_of_rates(from, turns, count, one_of(epochs), &value, &error), error, &value);
    }
    values_.add(value);
  }

  void skeleton() {
    FuzzInput part = input_.part(8 * (1 + input_.below(64)));
    const std::string_view bytes = part.rest();
    const std::vector<char> exact(bytes.begin(), bytes.end());
    const auto [name, option, given] = named();
    orispline_value* value = nullptr;
    orispline_error* error = nullptr;
    claim_done(orispline_value_of_skeleton(exact.data(), exact.size(), name, &option, given, &value, &error), error,
               &value);
    values_.add(value);
  }

  void look_at_value() {
    const orispline_value* const value = values_.any(input_);
    const orispline_kind kind = orispline_value_kind(value);
    claim(0 <= kind && kind <= ORISPLINE_SKELETON, "the kind {}", kind);
    const std::size_t count = orispline_value_count(value) + (input_.below(8) ? 0 : 1);
    std::vector<double> t(count), rates(3 * count);
    orispline_error* error = nullptr;
    double* const into = or_null(t);
    claim_done<void*>(orispline_value_rates(value, into, or_null(rates), count, &error), error, nullptr);
    orispline_keys* keys = nullptr;
    error = nullptr;
    claim_done(orispline_value_keys(value, &keys, &error), error, &keys);
    keys_.add(keys);
    char* json = nullptr;
    error = nullptr;
    take_text(orispline_value_json(value, &json, &error), error, json);
  }

  void write_value() { write(values_, orispline_value_write); }

  /// Asks some tasks to stop.
  static std::int32_t stop_soon(double share, void* program) {
    claim(0.0 <= share && share <= 1.0, "the share {}", share);
    return static_cast<Program*>(program)->stops_ ? 1 : 0;
  }

  void take_outcome(orispline_code code, orispline_error*& error, orispline_outcome* outcome) {
    claim_done(code, error, &outcome);
    outcomes_.add(outcome);
  }

  void run_task() {
    stops_ = input_.below(8) == 0;
    const std::array<orispline_input, 2> inputs{
        {{one_of(names), keys_.any(input_)}, {one_of(names), keys_.any(input_)}}};
    const std::array<const char*, 2> words{one_of(options), one_of(options)};
    const char* const task = one_of(tasks);
    const std::size_t input_count = 1 + input_.below(2), option_count = input_.below(3);
    orispline_outcome* outcome = nullptr;
    orispline_error* error = nullptr;
    const orispline_code code =
        orispline_task_run(task, inputs.data(), input_count, words.data(), option_count,
                           input_.below(2) ? &Program::stop_soon : nullptr, this, &outcome, &error);
    take_outcome(code, error, outcome);
    stops_ = false;
  }

  void run_with() {
    const std::array<orispline_named_value, 2> inputs{
        {{one_of(names), values_.any(input_)}, {one_of(names), values_.any(input_)}}};
    const auto [task, option, given] = Named{one_of(tasks), one_of(options), input_.below(2)};
    orispline_outcome* outcome = nullptr;
    orispline_error* error = nullptr;
    const orispline_code code = orispline_task_run_with(task, inputs.data(), 1 + input_.below(2), &option, given,
                                                        nullptr, nullptr, &outcome, &error);
    take_outcome(code, error, outcome);
  }

  void outcome() {
    const orispline_outcome* const outcome = outcomes_.any(input_);
    for (const auto text : {&orispline_outcome_document, &orispline_outcome_summary, &orispline_outcome_line,
                            &orispline_outcome_warnings})
      claim((text(outcome) == nullptr) == (outcome == nullptr), "an outcome without its texts");
    const std::size_t track = input_.below(3), tracks = orispline_outcome_track_count(outcome);
    orispline_keys* keys = nullptr;
    orispline_error* error = nullptr;
    claim(claim_done(orispline_outcome_track(outcome, track, &keys, &error), error, &keys) == (track < tracks),
          "track {} of {}", track, tracks);
    keys_.add(keys);
    orispline_value* value = nullptr;
    error = nullptr;
    claim(claim_done(orispline_outcome_value(outcome, track, &value, &error), error, &value) ==
              (track < orispline_outcome_value_count(outcome)),
          "value {}", track);
    values_.add(value);
  }

  void free_one() {
    const std::size_t which = input_.below(5);
    if (which == 0) keys_.free_last();
    else if (which == 1) curves_.free_last();
    else if (which == 2) baked_.free_last();
    else if (which == 3) outcomes_.free_last();
    else values_.free_last();
  }

  /// Handles where others are wanted.
  void other_kinds() {
    auto* const keys = keys_.any(input_);
    auto* const curve = curves_.any(input_);
    claim(orispline_keys_count(reinterpret_cast<const orispline_keys*>(curve)) == 0, "a curve with keys");
    claim(orispline_curve_has_positions(reinterpret_cast<const orispline_curve*>(keys)) == 0, "keys with positions");
    claim(orispline_value_kind(reinterpret_cast<const orispline_value*>(keys)) == 0, "keys as a value");
    claim(orispline_outcome_document(reinterpret_cast<const orispline_outcome*>(curve)) == nullptr,
          "a curve's document");
    orispline_curve* made = nullptr;
    orispline_error* error = nullptr;
    claim(!claim_done(orispline_curve_make(reinterpret_cast<const orispline_keys*>(curve), nullptr, &made, &error),
                      error, &made),
          "a curve through a curve");
  }

  FuzzInput input_;
  bool stops_ = false;
  Handles<orispline_keys, orispline_keys_free> keys_;
  Handles<orispline_curve, orispline_curve_free> curves_;
  Handles<orispline_baked, orispline_baked_free> baked_;
  Handles<orispline_outcome, orispline_outcome_free> outcomes_;
  Handles<orispline_value, orispline_value_free> values_;
};

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  orispline::fuzz::Program(bytes, size).run();
  return 0;
}
