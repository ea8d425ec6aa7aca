// SPDX-License-Identifier: Apache-2.0
// What a caller in C does wrong is an error that says so, and never a crash.
#include <cmath>
#include <limits>

#include <out_of_memory/failing_new.hpp>

#include "c/handles.hpp"

namespace orispline { namespace {

using namespace testing_support;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr const char* no_text = nullptr;

/// Two keys, to be spoilt.
struct TwoKeys {
  std::vector<double> times{0.0, 1.0}, orientations{1, 0, 0, 0, 0.8, 0.6, 0, 0};
  orispline_order order = ORISPLINE_WXYZ;
  orispline_signs signs = ORISPLINE_SHORTEST;
  std::vector<orispline_column> columns{};

  Result made() const {
    auto* keys = reinterpret_cast<orispline_keys*>(1);
    Result result = call(orispline_keys_make, times.data(), orientations.data(), times.size(), order, signs,
                         columns.data(), columns.size(), &keys);
    EXPECT_EQ(keys == nullptr, result.code != ORISPLINE_OK);
    orispline_keys_free(keys);
    return result;
  }
};

void expect_fault(const Result& result, orispline_code code, std::string_view option, std::string_view words) {
  EXPECT_EQ(result.code, code) << result.text();
  EXPECT_EQ(result.option(), option) << result.text();
  EXPECT_NE(result.text().find(words), std::string::npos) << result.text();
}

TEST(ErrorsOfC, NameTheKeyThatIsWrong) {
  for (const double time : {nan, infinity, 0.0, -1.0}) {
    const Result result = TwoKeys{.times = {0.0, time}}.made();
    EXPECT_EQ(result.code, ORISPLINE_BAD_DATA);
    EXPECT_EQ(orispline_error_key(result.error.get()), 1);
    EXPECT_EQ(orispline_error_line(result.error.get()), -1);
  }
  for (const double w : {nan, infinity, 0.0, 2.0}) {
    const Result result = TwoKeys{.orientations = {w, 0, 0, 0, 1, 0, 0, 0}}.made();
    EXPECT_EQ(result.code, ORISPLINE_BAD_DATA);
    EXPECT_EQ(orispline_error_key(result.error.get()), 0);
  }
  EXPECT_EQ(TwoKeys{.times = {}}.made().code, ORISPLINE_BAD_DATA) << "no keys";
}

TEST(ErrorsOfC, SayWhatOrdersAndSignsThereAre) {
  expect_fault(TwoKeys{.order = 0}.made(), ORISPLINE_BAD_ARGUMENT, "order", "wanted ORISPLINE_WXYZ or ORISPLINE_XYZW");
  expect_fault(TwoKeys{.order = 7}.made(), ORISPLINE_BAD_ARGUMENT, "order", "found 7");
  expect_fault(TwoKeys{.signs = -1}.made(), ORISPLINE_BAD_ARGUMENT, "signs", "found -1");
}

TEST(ErrorsOfC, NameTheColumnThatIsWrong) {
  const std::vector<double> five(5, 0.0), six(6, 0.0);
  const auto made = [](const orispline_column& column) { return TwoKeys{.columns = {column}}.made(); };
  expect_fault(made(column("positions", five)), ORISPLINE_BAD_ARGUMENT, "positions",
               "found 5 numbers, wanted 6 for 2 keys");
  expect_fault(made(column("tension", six)), ORISPLINE_BAD_ARGUMENT, "tension", "found 6 numbers, wanted 2 for 2 keys");
  expect_fault(made({"positions", nullptr, 6}), ORISPLINE_BAD_ARGUMENT, "positions", "found null");
  expect_fault(made({nullptr, six.data(), 6}), ORISPLINE_BAD_ARGUMENT, "columns", "without a name");
  expect_fault(made(column("", six)), ORISPLINE_BAD_ARGUMENT, "columns", "found ''");
  expect_fault(made({"orientations", TwoKeys().orientations.data(), 8}), ORISPLINE_BAD_ARGUMENT, "orientations",
               "twice");
  expect_fault(TwoKeys{.columns = {column("positions", six), column("positions", six)}}.made(), ORISPLINE_BAD_ARGUMENT,
               "positions", "twice");
}

TEST(ErrorsOfC, OfferTheMethodThatIsSpeltAlike) {
  const KeysHandle keys = keys_of(walk());
  orispline_curve* curve = nullptr;
  const auto made = [&](const char* method) {
    return call(orispline_curve_make, static_cast<const orispline_keys*>(keys.get()), method, &curve);
  };
  expect_fault(made("squadd"), ORISPLINE_BAD_ARGUMENT, "", "did you mean 'squad'?");
  expect_fault(made(""), ORISPLINE_BAD_ARGUMENT, "", "method");
  EXPECT_EQ(made("timed-c2:tension=1e9").code, ORISPLINE_BAD_ARGUMENT);
  EXPECT_EQ(made("timed-c2:tension=1,2").code, ORISPLINE_BAD_ARGUMENT);
  EXPECT_EQ(curve, nullptr);
}

/// A null pointer of the type of another one.
template <class T>
T* no(T*) {
  return nullptr;
}

/// Functions that are given null pointers, or numbers of no meaning.
struct NullPointersOfC : testing::Test {
  const KeysHandle keys_handle = keys_of(walk());
  const CurveHandle curve_handle = curve_through(keys_handle, "auto");
  const orispline_keys* const keys = keys_handle.get();
  const orispline_curve* const curve = curve_handle.get();
  double number = 0.0;
  std::size_t size = 0;
  char* text = nullptr;
  orispline_keys* made_keys = nullptr;
  orispline_curve* made_curve = nullptr;
  orispline_baked* made_baked = nullptr;
  orispline_outcome* made_outcome = nullptr;
  const orispline_progress nobody = nullptr;
  void* const nothing = nullptr;
  const char* const* const no_options = nullptr;

  /// The call fails with that code, says why, and makes nothing.
  template <class Function, class... Arguments>
  void expect_refused(Function function, Arguments... arguments) {
    const Result result = call(function, arguments...);
    EXPECT_EQ(result.code, ORISPLINE_BAD_ARGUMENT);
    EXPECT_NE(result.option(), "") << result.text();
    EXPECT_TRUE(!text && !made_keys && !made_curve && !made_baked && !made_outcome);
  }
};

TEST_F(NullPointersOfC, AreNoKeys) {
  const auto made = [&](const double* times, const double* numbers, std::size_t count, std::size_t columns,
                        orispline_keys** to) {
    const orispline_column* const no_columns = nullptr;
    expect_refused(orispline_keys_make, times, numbers, count, ORISPLINE_WXYZ, ORISPLINE_SHORTEST, no_columns, columns,
                   to);
  };
  made(nullptr, &number, 1, 0, &made_keys);
  made(&number, nullptr, 1, 0, &made_keys);
  made(&number, &number, 1, 1, &made_keys);
  made(&number, &number, 1, 0, nullptr);
  made(&number, &number, std::numeric_limits<std::size_t>::max(), 0, &made_keys);
  expect_refused(orispline_keys_column, no(keys), "times", 0, &number, std::size_t{1});
  expect_refused(orispline_keys_column, keys, no_text, 0, &number, std::size_t{1});
  expect_refused(orispline_keys_column, keys, "times", 0, no(&number), std::size_t{1});
  expect_refused(orispline_keys_column, keys, "times", 0, &number, std::size_t{1});
  expect_refused(orispline_keys_column, keys, "tension", 0, &number, std::size_t{1});
  expect_refused(orispline_keys_json, no(keys), &text);
  expect_refused(orispline_keys_json, keys, no(&text));
  EXPECT_EQ(orispline_keys_count(nullptr), 0u);
  orispline_keys_free(nullptr);
}

TEST_F(NullPointersOfC, AreNoCurve) {
  orispline_motion motion;
  expect_refused(orispline_curve_make, no(keys), "auto", &made_curve);
  expect_refused(orispline_curve_make, keys, "auto", no(&made_curve));
  expect_refused(orispline_curve_domain, curve, &number, no(&number));
  expect_refused(orispline_curve_domain, no(curve), &number, &number);
  expect_refused(orispline_curve_method, no(curve), &text);
  expect_refused(orispline_curve_orientation, no(curve), 0.0, ORISPLINE_WXYZ, &number);
  expect_refused(orispline_curve_orientation, curve, 0.0, ORISPLINE_WXYZ, no(&number));
  expect_refused(orispline_curve_orientation, curve, 0.0, 0, &number);
  expect_refused(orispline_curve_motion, no(curve), 0.0, 0, ORISPLINE_WXYZ, &motion);
  expect_refused(orispline_curve_motion, curve, 0.0, 2, ORISPLINE_WXYZ, &motion);
  expect_refused(orispline_curve_motion, curve, 0.0, 0, 0, &motion);
  expect_refused(orispline_curve_motion, curve, 0.0, 0, ORISPLINE_WXYZ, no(&motion));
  expect_refused(orispline_curve_continuity, curve, static_cast<orispline_continuity*>(nullptr));
  expect_refused(orispline_curve_orders, curve, static_cast<std::int32_t*>(nullptr), std::size_t{1});
  expect_refused(orispline_curve_peaks, curve, no(&number), static_cast<orispline_peaks*>(nullptr));
  orispline_peaks largest;
  expect_refused(orispline_curve_bounded_peaks, curve, no(&number), &largest, static_cast<double*>(nullptr));
  expect_refused(orispline_curve_warnings, no(curve), &text);
  EXPECT_EQ(orispline_curve_make(nullptr, nullptr, nullptr, nullptr), ORISPLINE_BAD_ARGUMENT) << "nobody asks why";
}

TEST_F(NullPointersOfC, AreNoSamplesAndNothingBaked) {
  const orispline_output output{ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, nullptr, 0};
  const auto sampled = [&](const double* times, const orispline_output* outputs) {
    expect_refused(orispline_sample_at, curve, times, std::size_t{1}, ORISPLINE_WXYZ, no_text, 1u, outputs,
                   std::size_t{1});
  };
  sampled(nullptr, &output);
  sampled(&number, &output);
  sampled(&number, nullptr);
  expect_refused(orispline_bake, no(curve), 1e-6, ORISPLINE_DOUBLE, nobody, nothing, &made_baked);
  expect_refused(orispline_bake, curve, 1e-6, ORISPLINE_DOUBLE, nobody, nothing, no(&made_baked));
  expect_refused(orispline_bake, curve, 1e-6, 2, nobody, nothing, &made_baked);
  expect_refused(orispline_bake_text, no(curve), 1e-6, 1e-3, &text);
  expect_refused(orispline_bake_text, curve, 1e-6, 1e-3, no(&text));
  expect_refused(orispline_bake_text, curve, 1e-7, 1e-3, &text);
  const orispline_baked_parts no_parts{};
  expect_refused(orispline_baked_look, static_cast<const orispline_baked*>(nullptr),
                 static_cast<orispline_baked_parts*>(nullptr));
  expect_refused(orispline_baked_make, static_cast<const orispline_baked_parts*>(nullptr), &made_baked);
  expect_refused(orispline_baked_make, &no_parts, &made_baked);
}

/// One piece more or less than there are between the ends: nothing of the arrays is read, which are too short for it.
TEST(BakedOfC, IsRefusedForAnotherNumberOfPiecesBeforeTheyAreRead) {
  const std::vector<double> ends{0.0, 1.0}, scales{0.5, 2.0};
  std::vector<double> coefficients(40);
  coefficients[30] = 1.0;
  orispline_baked_parts parts{ends.data(), scales.data(), coefficients.data(), 2, 1, 9, ORISPLINE_DOUBLE, 0.0};
  for (const auto& [pieces, code] : {std::pair<std::size_t, orispline_code>{0, ORISPLINE_BAD_ARGUMENT},
                                     {1, ORISPLINE_OK},
                                     {2, ORISPLINE_BAD_DATA},
                                     {3, ORISPLINE_BAD_ARGUMENT},
                                     {SIZE_MAX, ORISPLINE_BAD_ARGUMENT}}) {
    parts.pieces = pieces;
    orispline_baked* made = nullptr;
    orispline_error* error = nullptr;
    EXPECT_EQ(orispline_baked_make(&parts, &made, &error), code) << pieces;
    EXPECT_EQ(made == nullptr, code != ORISPLINE_OK);
    orispline_baked_free(made);
    orispline_error_free(error);
  }
}

TEST_F(NullPointersOfC, AreNoTaskAndNoFile) {
  const auto run = [&](const char* task, const orispline_input* inputs, std::size_t input_count,
                       std::size_t option_count) {
    expect_refused(orispline_task_run, task, inputs, input_count, no_options, option_count, nobody, nothing,
                   &made_outcome);
  };
  const orispline_input unnamed{nullptr, keys}, empty{"keys", nullptr};
  run(nullptr, &empty, 1, 0);
  run("tune", &unnamed, 1, 0);
  run("tune", &empty, 1, 0);
  run("tune", nullptr, 1, 0);
  run("tune", &empty, 0, 1);
  expect_refused(orispline_outcome_track, static_cast<const orispline_outcome*>(nullptr), std::size_t{0}, &made_keys);
  EXPECT_EQ(orispline_outcome_document(nullptr), nullptr);
  EXPECT_EQ(orispline_outcome_track_count(nullptr), 0u);
  expect_refused(orispline_methods_json, no(&text));
  expect_refused(orispline_method_text, no_text, &text);
  expect_refused(orispline_tasks_json, no(&text));
  expect_refused(orispline_files_json, no(&text));
  const void* const no_bytes = nullptr;
  expect_refused(orispline_keys_read, no_bytes, std::size_t{1}, "keys.csv", no_options, std::size_t{0}, &made_keys);
  expect_refused(orispline_keys_read, no_bytes, std::size_t{0}, no_text, no_options, std::size_t{0}, &made_keys);
  expect_refused(orispline_keys_write, no(keys), "keys.csv", no_options, std::size_t{0}, &text, &size, no(&text));
  expect_refused(orispline_keys_write, keys, no_text, no_options, std::size_t{0}, &text, &size, no(&text));
  expect_refused(orispline_keys_write, keys, "keys.csv", no_options, std::size_t{0}, &text, no(&size), no(&text));
}

TEST_F(NullPointersOfC, AreNoError) {
  EXPECT_EQ(orispline_error_code(nullptr), ORISPLINE_OK);
  EXPECT_STREQ(orispline_error_message(nullptr), "");
  EXPECT_EQ(orispline_error_key(nullptr), -1);
  orispline_error_free(nullptr);
  orispline_text_free(nullptr);
}

TEST(ErrorsOfC, SayWhatSamplesAreAskedForWrongly) {
  const CurveHandle owned = curve_through(keys_of([] {
                                            KeyframeData data = walk();
                                            data.positions.clear();
                                            return data;
                                          }()),
                                          "auto");
  const orispline_curve* const curve = owned.get();
  std::vector<double> numbers(100);
  const auto sampled = [&](orispline_output output, const char* beyond = nullptr, double step = 0.1) {
    output.numbers = numbers.data();
    return call(orispline_sample_even, curve, 0.0, step, std::size_t{4}, ORISPLINE_WXYZ, beyond, 1u, &output,
                std::size_t{1});
  };
  const orispline_output sound{ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, nullptr, 0};
  expect_fault(sampled({10, ORISPLINE_DOUBLE, nullptr, 0}), ORISPLINE_BAD_ARGUMENT, "quantity", "found 10");
  expect_fault(sampled({-1, ORISPLINE_DOUBLE, nullptr, 0}), ORISPLINE_BAD_ARGUMENT, "quantity", "found -1");
  expect_fault(sampled({ORISPLINE_ORIENTATION, 5, nullptr, 0}), ORISPLINE_BAD_ARGUMENT, "type", "found 5");
  expect_fault(sampled({ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, nullptr, 3}), ORISPLINE_BAD_ARGUMENT, "stride",
               "at least 4");
  expect_fault(sampled(sound, "holdd"), ORISPLINE_BAD_ARGUMENT, "beyond", "wanted hold|error|nan|rate|segment");
  expect_fault(sampled(sound, nullptr, -0.1), ORISPLINE_BAD_ARGUMENT, "step", "found -0.1");
  expect_fault(sampled(sound, nullptr, nan), ORISPLINE_BAD_ARGUMENT, "step", "found nan");
  EXPECT_EQ(sampled({ORISPLINE_POSITION, ORISPLINE_DOUBLE, nullptr, 0}).code, ORISPLINE_BAD_ARGUMENT);
  EXPECT_EQ(sampled(sound).code, ORISPLINE_OK);
}

TEST(ErrorsOfC, SayThatNoMemoryHoldsSoManySamples) {
  const CurveHandle owned = curve_through(keys_of(walk()), "auto");
  const orispline_curve* const curve = owned.get();
  const std::vector<double> times(1);
  std::vector<double> numbers(100);
  constexpr std::size_t whole = std::numeric_limits<std::size_t>::max();
  struct {
    std::size_t count, stride;
    orispline_type type;
  } const cases[] = {{whole, 0, ORISPLINE_DOUBLE},
                     {whole / 4 + 2, 0, ORISPLINE_DOUBLE},
                     {whole / 32 + 2, 0, ORISPLINE_DOUBLE},
                     {whole / 64 + 2, 0, ORISPLINE_DOUBLE},
                     {whole / 32 + 2, 0, ORISPLINE_FLOAT},
                     {2, whole, ORISPLINE_DOUBLE},
                     {2, whole / 2 + 1, ORISPLINE_FLOAT},
                     {1, whole / 8 + 1, ORISPLINE_DOUBLE},
                     {std::size_t{1} << 32, std::size_t{1} << 32, ORISPLINE_FLOAT}};
  for (const auto& [count, stride, type] : cases) {
    const orispline_output output{ORISPLINE_ORIENTATION, type, numbers.data(), stride};
    const char* const hold = nullptr;
    expect_fault(call(orispline_sample_even, curve, 0.0, 0.1, count, ORISPLINE_WXYZ, hold, 1u, &output, std::size_t{1}),
                 ORISPLINE_BAD_ARGUMENT, "count", "wanted so few that memory can hold them");
    expect_fault(
        call(orispline_sample_at, curve, times.data(), count, ORISPLINE_WXYZ, hold, 1u, &output, std::size_t{1}),
        ORISPLINE_BAD_ARGUMENT, "count", "wanted so few that memory can hold them");
  }
}

TEST(ErrorsOfC, KnowHandlesThatWereFreedOrAreOthers) {
  KeysHandle keys = keys_of(walk());
  CurveHandle curve = curve_through(keys, "auto");
  orispline_curve* made = nullptr;
  const auto* const others = reinterpret_cast<const orispline_keys*>(curve.get());
  expect_fault(call(orispline_curve_make, others, "auto", &made), ORISPLINE_BAD_ARGUMENT, "keys", "is another one");
  orispline_keys_free(reinterpret_cast<orispline_keys*>(curve.get()));
  double start = 0.0, end = 0.0;
  const orispline_curve* const c = curve.get();
  expect_ok(call(orispline_curve_domain, c, &start, &end));
  orispline_curve_free(curve.get());
  expect_fault(call(orispline_curve_domain, c, &start, &end), ORISPLINE_BAD_ARGUMENT, "curve", "was freed");
  orispline_curve_free(curve.release());  // once more, which is nothing
  const orispline_keys* const k = keys.get();
  keys.reset();
  expect_fault(call(orispline_curve_make, k, "auto", &made), ORISPLINE_BAD_ARGUMENT, "keys", "was freed");
  EXPECT_EQ(orispline_keys_count(k), 0u);
}

TEST(ErrorsOfC, SayWhatBakingCannotReach) {
  const CurveHandle owned = curve_through(keys_of(walk()), "auto");
  const orispline_curve* const curve = owned.get();
  orispline_baked* baked = nullptr;
  for (const double tolerance : {0.0, -1.0, nan, infinity, 1e-15})
    EXPECT_EQ(call(orispline_bake, curve, tolerance, ORISPLINE_DOUBLE, static_cast<orispline_progress>(nullptr),
                   static_cast<void*>(nullptr), &baked)
                  .code,
              ORISPLINE_BAD_ARGUMENT);
  std::vector<double> inertia(9, nan);
  orispline_peaks found;
  EXPECT_EQ(call(orispline_curve_peaks, curve, static_cast<const double*>(inertia.data()), &found).code,
            ORISPLINE_BAD_ARGUMENT);
}

/// What a call gives while memory lasts for ever more allocations, until it is done.
template <class Work>
void expect_no_memory_alone(std::string_view name, Work work) {
  long allowed = 0;
  for (orispline_code code = ORISPLINE_NO_MEMORY; code != ORISPLINE_OK && allowed < 10'000'000;
       allowed += 1 + allowed / 8) {
    orispline_error* error = nullptr;
    allow_allocations(allowed);
    code = work(&error);
    allow_allocations(-1);
    if (code != ORISPLINE_OK) {
      ASSERT_EQ(code, ORISPLINE_NO_MEMORY) << name << ": " << orispline_error_text(error);
      ASSERT_EQ(orispline_error_code(error), ORISPLINE_NO_MEMORY);
      ASSERT_STREQ(orispline_error_text(error), "no memory left");
    }
    orispline_error_free(error);
  }
  EXPECT_GT(allowed, 1) << name;
  EXPECT_LT(allowed, 10'000'000) << name;
}

TEST(ErrorsOfC, SayThatMemoryRanOut) {
  const KeyframeData data = walk();
  const std::vector<double> orientations = flat(data.orientations, ORISPLINE_WXYZ);
  const KeysHandle keys = keys_of(data);
  const CurveHandle curve = curve_through(keys, "auto");
  expect_no_memory_alone("keys", [&](orispline_error** error) {
    orispline_keys* made = nullptr;
    const auto code = orispline_keys_make(data.times.data(), orientations.data(), data.times.size(), ORISPLINE_WXYZ,
                                          ORISPLINE_SHORTEST, nullptr, 0, &made, error);
    orispline_keys_free(made);
    return code;
  });
  expect_no_memory_alone("curve", [&](orispline_error** error) {
    orispline_curve* made = nullptr;
    const auto code = orispline_curve_make(keys.get(), "global-c2", &made, error);
    orispline_curve_free(made);
    return code;
  });
  expect_no_memory_alone("samples", [&](orispline_error** error) {
    std::array<double, 30> numbers;
    const orispline_output output{ORISPLINE_ANGULAR_JERK_WORLD, ORISPLINE_DOUBLE, numbers.data(), 0};
    return orispline_sample_even(curve.get(), 0.0, 0.1, 10, ORISPLINE_WXYZ, nullptr, 1, &output, 1, error);
  });
  expect_no_memory_alone("rates", [&](orispline_error** error) {
    const std::array<double, 3> numbers{};
    orispline_value* made = nullptr;
    const auto code = orispline_value_of_rates(numbers.data(), numbers.data(), 1, "0.5", &made, error);
    orispline_value_free(made);
    return code;
  });
  expect_no_memory_alone("task", [&](orispline_error** error) {
    const orispline_input input{"keys", keys.get()};
    orispline_outcome* made = nullptr;
    const auto code = orispline_task_run("tune", &input, 1, nullptr, 0, nullptr, nullptr, &made, error);
    orispline_outcome_free(made);
    return code;
  });
}

}}  // namespace orispline
