// SPDX-License-Identifier: Apache-2.0
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <orispline/io/file_option.hpp>

namespace orispline::io { namespace {

Reading read_by(const StatedOptions& stated) {
  Reading reading;
  const auto taken = take_options(reading, stated);
  EXPECT_TRUE(taken) << describe(taken.error());
  return reading;
}

std::string refused_by(const StatedOptions& stated) {
  Reading reading;
  const auto taken = take_options(reading, stated);
  EXPECT_FALSE(taken);
  return taken ? "" : describe(taken.error());
}

TEST(ReadingOptions, HaveNamesOfTheirOwnAndSayWhatTheyAre) {
  std::set<std::string_view> names;
  for (const auto& option : reading_options()) {
    EXPECT_TRUE(names.insert(option.name).second) << option.name;
    EXPECT_FALSE(option.sentence.empty()) << option.name;
    EXPECT_EQ(option_named(reading_options(), option.name), &option);
    if (!option.member.empty()) {
      EXPECT_EQ(reading_option_of(option.member), &option);
    }
  }
  EXPECT_EQ(names.size(), 31u);
  EXPECT_EQ(reading_option_of(""), nullptr);
  EXPECT_EQ(reading_option_of("rate"), nullptr);
}

TEST(ReadingOptions, AreTakenOver) {
  const Reading reading = read_by({{"input_format", "tum"},
                                   {"columns", "t=sclk,qw=q0"},
                                   {"columns", "qx=q1"},
                                   {"order", "xyzw"},
                                   {"input_orientation", "rotvec"},
                                   {"euler", "zyx"},
                                   {"angle_unit", "mrad"},
                                   {"time_scale", "1/24"},
                                   {"fps", "30000/1001"},
                                   {"epoch", "1970-01-02"},
                                   {"signs", "as-given"}});
  EXPECT_EQ(reading.options.format, &tum_format);
  EXPECT_EQ(reading.options.columns, (ColumnNames{{"t", "sclk"}, {"qw", "q0"}, {"qx", "q1"}}));
  EXPECT_EQ(reading.options.order, QuaternionOrder::xyzw);
  EXPECT_EQ(reading.options.orientation.representation, Representation::rotation_vector);
  EXPECT_EQ(reading.options.orientation.angle_unit, AngleUnit::milliradians);
  EXPECT_EQ(reading.options.time_scale->to_string(), "1/24");
  EXPECT_EQ(reading.options.clock.frames_per_second->to_string(), "30000/1001");
  EXPECT_EQ(reading.options.clock.zero.to_string(), "86400");
  EXPECT_EQ(reading.signs, Signs::as_given);
}

TEST(ReadingOptions, OfFlagsStandAsTheyAreNamed) {
  const Reading plain = read_by({});
  EXPECT_FALSE(plain.options.conjugate || plain.options.sort || plain.signs);
  const ReadOptions options =
      read_by({{"conjugate", ""}, {"normalise", ""}, {"ignore_recipe", ""}, {"drop_invalid", ""}, {"sort", ""}})
          .options;
  EXPECT_TRUE(options.conjugate && options.drop_invalid && options.sort);
  EXPECT_FALSE(options.drop_duplicates);
  EXPECT_EQ(options.norms, Norms::any);
  EXPECT_EQ(options.recipe, RecipeUse::ignored);
}

TEST(ReadingOptions, SayWhatWasWanted) {
  EXPECT_EQ(refused_by({{"order", "wzyx"}}), "order: found 'wzyx', wanted wxyz|xyzw");
  EXPECT_EQ(refused_by({{"input_format", "bvh"}}), "input_format: found 'bvh', wanted csv|tum|euroc");
  EXPECT_EQ(refused_by({{"columns", "t"}}), "columns: found 't', wanted NAME=VALUE");
  EXPECT_EQ(refused_by({{"columns", "t=a,t=b"}}), "columns: 't' is given twice, wanted it once");
  EXPECT_EQ(refused_by({{"fps", "-1"}}),
            "fps: found '-1', wanted a number greater than 0, or a fraction such as 30000/1001");
  EXPECT_EQ(refused_by({{"epoch", "1"}}), "epoch: found '1', wanted a time of ISO 8601 such as 2024-02-29T12:30:00Z");
  EXPECT_EQ(refused_by({{"sorted", ""}}), "unknown option 'sorted'; did you mean 'sort'?");
}

TEST(WritingOptions, TakeTheFormatOfTheNameUnlessOneIsStated) {
  EXPECT_EQ(columns_of_output("a.TUM", {})->format, &tum_format);
  EXPECT_EQ(columns_of_output("a.npy", {{"output_format", "euroc"}})->format, &euroc_format);
  EXPECT_EQ(columns_of_output("a", {})->format, &csv_format);
  EXPECT_EQ(columns_of_output("-", {})->format, &csv_format);
  const auto foreign = columns_of_output("a.parquet", {});
  ASSERT_FALSE(foreign);
  EXPECT_EQ(describe(foreign.error()),
            "path: found 'a.parquet', wanted a name that ends in .csv, .tum, .npy or .txt; "
            "`output_format` writes any name");
  EXPECT_EQ(columns_of_output("a.parquet", {{"output_format", "csv"}})->format, &csv_format);
  EXPECT_EQ(columns_of_output("", {}).error().code, ErrorCode::bad_argument);
}

TEST(WritingOptions, AreLikeTheFileThatWasReadWhereTheNameSaysNothing) {
  const auto format = [](const char* path, const FormatInfo& input, const StatedOptions& stated, int derivatives = 0) {
    SampleColumns columns = columns_of_output(path, stated).value();
    columns.derivatives = derivatives;
    return columns_like(input, columns, path, stated).format;
  };
  EXPECT_EQ(format("a.txt", tum_format, {}), &tum_format);
  EXPECT_EQ(format("a.csv", tum_format, {}), &csv_format);
  EXPECT_EQ(format("a.txt", tum_format, {{"output_format", "csv"}}), &csv_format);
  EXPECT_EQ(format("a.txt", tum_format, {}, 1), &csv_format);
  EXPECT_EQ(format("a.txt", tum_format, {{"output_orientation", "matrix"}}), &csv_format);
  EXPECT_EQ(format("a.txt", euroc_format, {}), &csv_format);
}

TEST(WritingOptions, AskForAnglesByTheirOrderOrTheirUnitAlone) {
  const auto by_order = columns_of_output("a.csv", {{"output_euler", "xyz"}});
  EXPECT_EQ(by_order->form.representation, Representation::euler);
  EXPECT_EQ(columns_of_output("a.csv", {{"output_angle_unit", "rad"}})->form.unit, AngleUnit::radians);
  const auto torn = columns_of_output("a.csv", {{"output_orientation", "matrix"}, {"output_angle_unit", "rad"}});
  ASSERT_FALSE(torn);
  EXPECT_EQ(describe(torn.error()), "output_orientation: found 'matrix', wanted euler with `output_angle_unit`");
  EXPECT_EQ(describe(columns_of_output("a.tum", {{"output_euler", "xyz"}}).error()),
            "output_euler: a TUM file holds orientations as quaternions only, wanted CSV or NumPy");
  EXPECT_EQ(columns_of_output("a.csv", {{"output_conjugate", ""}})->turning, Turning::world_to_body);
}

}}  // namespace orispline::io
