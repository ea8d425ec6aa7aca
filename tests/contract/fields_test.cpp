// SPDX-License-Identifier: Apache-2.0
// What every list of fields promises, and that a field reads and writes the member that it stands for.
#include <cstdint>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include <orispline/fields.hpp>
#include <orispline/fields/field.hpp>

namespace orispline { namespace {

void expect_whole(std::span<const FieldInfo> fields) {
  std::set<std::string_view> names;
  for (const FieldInfo& field : fields) {
    SCOPED_TRACE(field.name);
    EXPECT_TRUE(names.insert(field.name).second);
    EXPECT_FALSE(field.sentence.empty());
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(field.sentence[0])) || field.sentence[0] < 0);
    EXPECT_EQ(field.type == FieldType::word, !field.words.empty());
    EXPECT_TRUE(field.get);
  }
}

/// Of options: the default can be set again, and nothing of another type.
void expect_settable(std::span<const FieldInfo> fields, void* options) {
  for (const FieldInfo& field : fields) {
    SCOPED_TRACE(field.name);
    if (field.type == FieldType::recording) continue;
    const FieldValue initial = field.initial();
    EXPECT_EQ(field.get(options), initial);
    EXPECT_TRUE(field.set(options, initial));
    EXPECT_EQ(field.get(options), initial);
    EXPECT_FALSE(field.set(options, std::vector<SampleRun>()));
    for (const Word& word : field.words) {
      EXPECT_TRUE(field.set(options, std::string(word.word)));
      EXPECT_EQ(field.get(options), FieldValue(std::string(word.word)));
    }
    EXPECT_EQ(field.set(options, std::string("no such word")), false);
  }
}

template <class... Options>
void expect_options() {
  const auto expect = [](auto options) {
    const auto fields = fields_of<decltype(options)>();
    expect_whole(fields);
    expect_settable(fields, &options);
  };
  (expect(Options{}), ...);
}

TEST(Fields, AreWholeAndStandForTheirMembers) {
  expect_options<SmoothOptions, TuneOptions, ReduceOptions, RetimeOptions, MeasureOptions, Decimation>();
}

/// Of these two one is std::uint64_t and none or the other is std::size_t: macOS and WebAssembly differ from Linux in
/// that.
template <class T>
struct Seeded {
  T seed = 3;
};

template <class T>
void expect_a_count() {
  const FieldInfo seed = field<&Seeded<T>::seed>({.name = "seed", .sentence = "Of random numbers"});
  EXPECT_EQ(seed.type, FieldType::count);
  Seeded<T> object;
  EXPECT_EQ(seed.get(&object), FieldValue(std::uint64_t{3}));
  const std::uint64_t greatest = std::numeric_limits<T>::max();
  EXPECT_TRUE(seed.set(&object, greatest));
  EXPECT_EQ(object.seed, std::numeric_limits<T>::max());
  if (greatest < std::numeric_limits<std::uint64_t>::max()) {
    EXPECT_FALSE(seed.set(&object, greatest + 1));
    EXPECT_EQ(object.seed, std::numeric_limits<T>::max());
  }
}

TEST(Fields, TakeWholeNumbersOfEveryType) {
  expect_a_count<unsigned long>();
  expect_a_count<unsigned long long>();
  expect_a_count<unsigned>();
  expect_a_count<int>();
}

TEST(Fields, OfResultsAreWhole) {
  for (const auto fields : {fields_of<Smoothing>(), fields_of<Tuning>(), fields_of<Reduction>(), fields_of<Retiming>()})
    expect_whole(fields);
}

TEST(Fields, ReachMembersOfMembers) {
  RetimeOptions options;
  const auto fields = fields_of<RetimeOptions>();
  EXPECT_TRUE(field_named(fields, "max_rate").set(&options, 2.0));
  EXPECT_EQ(options.limits.rate, 2.0);
  EXPECT_TRUE(field_named(fields, "max_rate").set(&options, std::monostate()));
  EXPECT_FALSE(options.limits.rate);
  EXPECT_TRUE(field_named(fields, "inertia").set(&options, std::vector{1.0, 2.0, 3.0, 0.1, 0.2, 0.3}));
  EXPECT_EQ((*options.limits.inertia)(2, 0), 0.2);
  EXPECT_TRUE(field_named(fields, "slowing").set(&options, std::string("per-interval")));
  EXPECT_EQ(options.slowing, Slowing::per_interval);
}

TEST(Fields, ShowWhatIsComputedOfAResult) {
  Smoothing smoothing;
  const auto fields = fields_of<Smoothing>();
  EXPECT_TRUE(is_absent(field_named(fields, "gyro_correction").get(&smoothing)));
  smoothing.gyro = GyroFinding{.noise = 0.1, .used = true};
  smoothing.nodes.gyro_correction = {1.0, 2.0, 3.0};
  EXPECT_EQ(field_named(fields, "gyro_correction").get(&smoothing), FieldValue(std::vector{1.0, 2.0, 3.0}));
  EXPECT_FALSE(field_named(fields, "cutoff").set);
  EXPECT_EQ(name_with_unit(field_named(fields, "gyro_noise")), "gyro_noise_rad_s");
}

TEST(Fields, HoldOptionsToTheirRanges) {
  EXPECT_TRUE(check_ranges(SmoothOptions{}));
  const auto refused = check_ranges(SmoothOptions{.gap = -1.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(describe(refused.error()), "gap: found -1 s, wanted more than 0 s");
  EXPECT_EQ(describe(check_ranges(Decimation{.keep_every = 0}).error()), "keep_every: found 0, wanted 1 or more");
}

}}  // namespace orispline
