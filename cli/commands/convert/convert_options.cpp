// SPDX-License-Identifier: Apache-2.0
#include "commands/convert/convert_options.hpp"

namespace orispline::cli {

namespace {

constexpr auto convert_footer = R"(Examples:
  orispline convert data.csv -o trajectory.tum
  orispline convert trajectory.tum -o data.csv --output-format euroc
  orispline convert attitude.csv --euler ZXZ --angle-unit deg -o keys.csv
  orispline convert keys.csv --output-orientation matrix -o matrices.csv
  orispline convert walk.bvh -o walk.glb
  orispline convert mage.glb --clip Walking_A --output-euler ZXY -o walk.bvh

Times stay exact; EuRoC alone rounds them to whole nanoseconds. Quaternions keep their digits and signs; those whose norm
is off are scaled to 1 and counted. Positions are kept, and angular velocities where the output is CSV or NumPy. Other
columns are left out, and the summary names them.)";

}  // namespace

void add_convert_options(Command& app, ConvertArguments& o) {
  add_input_options(app, o.input, "as-given");
  o.output.scenes = scenes_written();
  add_output_options(app, o.output);
  add_gltf_options(app, o.output);
  app.add_option("--rate", o.rate, "Frames per second of a BVH file [those of the keys, where they are even]")
      ->type_name("HZ")
      ->group("Output");
  app.add_flag("--no-bones", o.no_bones, "Leave out the bones that show a skeleton without a mesh, in a glTF file")
      ->group("Output");
  add_summary_options(app, o.summary);
  app.usual = {"--euler",     "--angle-unit",    "--conjugate",         "--world-axes",
               "--body-axes", "--output-format", "--output-orientation"};
  app.footer = convert_footer;
}

}  // namespace orispline::cli
