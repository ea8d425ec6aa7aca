// SPDX-License-Identifier: Apache-2.0
#include "commands/align/align_options.hpp"

#include <orispline/fields.hpp>

namespace orispline::cli {

namespace {

constexpr auto align_footer = R"(Examples:
  orispline align estimate.csv truth.csv
  orispline align estimate.csv truth.csv -o aligned.csv
  orispline align headset.csv mocap.csv --offset 0
  orispline align camera.tum truth.tum --no-body-turn --no-scale -o aligned.tum
  orispline align imu.csv robot.csv --json
  orispline align gyro.csv poses.csv
  orispline align gyro.csv other_gyro.csv -o aligned_rates.csv

INPUT and REFERENCE are two recordings of one motion, at least as far as they overlap. What is found turns the world and
the body of INPUT, shifts its clock, and moves and scales its positions where both have some. A file with wx, wy, wz and
no orientations is the recording of a gyro: beside another gyro or orientations the turn of the body, the clock and the
bias are found. A tenth of bad rows in
either file does no harm. What the motion cannot tell, such as which of two sides turns where all turns have one axis, is
said. The reading options hold for REFERENCE too as far as they fit. docs/align.md says more.)";

}  // namespace

void add_align_options(Command& app, AlignArguments& o) {
  add_input_options(app, o.input);
  app.add_option("REFERENCE", o.reference,
                 "Recording of the same motion, or gyro of the same body, which stays as it is")
      ->required()
      ->type_name(file_type);
  add_fields(app, o.alignment, fields_of<orispline::AlignOptions>(), "Alignment");
  add_made_output(
      app, o.output, o.summary,
      "File to write INPUT into as it is beside REFERENCE; it appears complete or not at all [what was found is "
      "printed]");
  app.footer = align_footer;
}

}  // namespace orispline::cli
