// SPDX-License-Identifier: Apache-2.0
#include "commands/difference/difference_options.hpp"

#include <orispline/fields.hpp>

#include "options/command_options.hpp"

namespace orispline::cli {

namespace {

constexpr auto difference_footer = R"(Examples:
  orispline difference mage.glb small.glb
  orispline difference walk.bvh walk.glb --rate 240
  orispline difference mage.glb small.glb --clip Walking_A --shell 10cm
  orispline difference mage.glb small.glb --report difference.html

The joints of both files go by their place in the tree, then by their names; the clips go by their names, unless each
file has one only. The shell distance
is the largest distance in the world between the same points in both motions: the joint itself, and three points that
are --shell off it along its axes. docs/skeletons.md says more.)";

}  // namespace

void add_difference_options(Command& app, DifferenceArguments& o) {
  app.add_option("FIRST", o.first, "File of a skeleton with its clips, at whose key times the two are compared")
      ->required()
      ->type_name("FILE");
  app.add_option("SECOND", o.second, "File of the same skeleton")->required()->type_name("FILE");
  app.add_option("--clip", o.clips, "Clip to compare, by its name; repeatable [all of them]")
      ->repeated()
      ->type_name("NAME");
  add_field(app, o.shell, field_named(fields_of<orispline::ClipReduceOptions>(), "shell"), "");
  app.add_option("--rate", o.rate, "Compare at so many times per second as well [at the keys of FIRST only]")
      ->type_name("HZ");
  app.add_flag("--json", o.json, "Print one JSON document");
  app.add_option("--report", o.report.path,
                 "Write a page to look at in a browser: both motions in space, and how far they differ")
      ->type_name(file_type);
  app.footer = difference_footer;
}

}  // namespace orispline::cli
