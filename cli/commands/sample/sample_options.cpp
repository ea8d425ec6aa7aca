// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_options.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/jobs/sample_steps.hpp>

#include "options/method_options.hpp"

namespace orispline::cli {

namespace {

constexpr auto sample_footer = R"(Examples:
  orispline sample keys.csv --rate 100 -o motion.csv
  orispline sample keys.csv --method quintic --tension=0.4 --ends natural --count 500 | head
  orispline sample flight.csv --method timed-c2 --start-rate=0,0,0.5 --times frames.csv -o motion.csv
  orispline sample keys.csv --method squad-timed --set variant=boyle --rate 100 -o motion.csv
  orispline sample robot.csv --set hold=1 --rate 100 -o motion.csv
  orispline sample loop.csv --method timed-c2 --closed --rate 100 -o lap.csv
  orispline sample trajectory.tum --drop-duplicates --rate 200 -o smooth.tum
  orispline sample data.csv --rate 200 --output-orientation euler -o motion.csv
  orispline sample keys.csv --rate 100000 -o motion.npy
  orispline sample joints --rate 100 --output-folder motions
  orispline sample recording.csv --method measured --band 0.9 --rate 100 -o motion.csv
  orispline sample smoothed.csv --band 0.9 --rate 100 -o motion.csv
  orispline sample mage.glb --clip Walking_A --joint hand.r --space world --rate 240 -o hand.csv
  orispline sample mage.glb --rate 30 --output-folder joints
  orispline sample flight.csv --tolerance 0.03deg -o flight.glb
  orispline sample ck.csv --columns t=sclk,qw=q0,qx=q1,qy=q2,qz=q3 --conjugate --rate 10 --frame world

INPUT has the columns t,qw,qx,qy,qz and optionally px,py,pz, wx,wy,wz[,ax,ay,az[,jx,jy,jz]] (for methods that take
rates) and one column per parameter of the method (a value per key); a parameter on the command line wins over its
column. Instead of the quaternion: roll,pitch,yaw; e1,e2,e3 with --euler; r11,r12,...,r33; rx,ry,rz.
'-' is standard input or output.
Columns out: t,qw,qx,qy,qz[,px,py,pz][,wx,wy,wz[,ax,ay,az[,jx,jy,jz]]][,vx,vy,vz[,apx,apy,apz]][,band]
in s, m, rad/s, rad/s^2, rad/s^3, m/s, m/s^2; angular rates in the body frame, positions and theirs in the world frame.
TUM and EuRoC files always have positions: zeros when the keys have none.
At a --rate a method whose segments depend on a few keys is sampled while INPUT is read: memory grows neither with the
keys nor with the samples, and rows before a bad one are on standard output before it is found. All keys are held for
the other methods and for squad-timed, shoemake and tcb, with --count, --times, --truth, --band, --sort, --session,
--gap, --closed or --period, and for NumPy into a pipe.
A NumPy file (-o motion.npy) is one array of doubles, shape (samples, columns), with the columns of the CSV.
Without -o the samples go to standard output as CSV; summaries and warnings go to standard error.)";

}  // namespace

void add_sample_options(Command& app, SampleArguments& o) {
  add_several_inputs(app, o.inputs, "samples");
  add_reading_options(app, o.input);
  app.add_option("--method", o.method,
                 formatted("Method [the one named in INPUT; else {} of a file of skeletons, else {}]; see 'orispline "
                           "methods'",
                           jobs::stored_method, default_method))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_loop_options(app, o.shape);
  add_time_options(app, o.rows, "Times (one of --rate, --count, --times)",
                   "Samples per second, such as 100 or 30000/1001, from the start up to the end; or --fps");
  o.output.scenes = {&scenes::gltf_format};
  add_output_options(app, o.output);
  add_gltf_options(app, o.output);
  const std::string group = "Output";
  add_row_options(app, o.rows);
  app.add_option("--tolerance", o.tolerance,
                 "Largest angle between the curve and the cubics of a glTF file, in the place of --rate [0.01deg]")
      ->type_name("ANGLE")
      ->group(group);
  app.add_option("--position-tolerance", o.position_tolerance,
                 "Largest distance between the path and the cubics of a glTF file [1mm]")
      ->type_name("LENGTH")
      ->group(group);
  add_band_option(app, o.rows);
  app.add_option("--threads", o.inputs.threads,
                 "Threads that make the samples, which are the same on any number [all cores]")
      ->type_name("N")
      ->group(group);
  app.add_option("--truth", o.truth, "Key file that the curve is compared with, in the summary")
      ->type_name(file_type)
      ->group(group);
  app.add_flag("--align", o.align, "Bring the file of --truth onto the keys first: axes and clock; with --truth")
      ->group(group);
  app.add_flag("--json", o.summary.json, "Print the summary as JSON on standard output; needs -o")->group(group);
  app.add_flag("--quiet", o.summary.quiet, "No summary, no progress bar")->group(group);
  app.usual = {"--rate", "--count", "--times", "--from", "--to", "--include-end", "--derivatives"};
  app.footer = sample_footer;
}

}  // namespace orispline::cli
