// SPDX-License-Identifier: Apache-2.0
// From file to file: keys are read and checked, their curve is sampled at 50 Hz, and the samples appear complete or not
// at all.

#include <cstdio>
#include <fstream>
#include <orispline/files.hpp>
#include <orispline/orispline.hpp>
#include <orispline/streams.hpp>
#include <string>

/// How many samples of the keys in one file were written into another one.
orispline::Expected<std::uint64_t> resample(const std::string& input, const std::string& output, double rate) {
  const auto file = orispline::io::read_track(input, {.sort = true});  // CSV, TUM or EuRoC
  if (!file) return tl::unexpected(file.error());
  const orispline::Track& track = file->track;
  const auto curve = orispline::make_curve("auto", track.keys);
  if (!curve) return tl::unexpected(track.located(curve.error()));

  const auto [start, end] = curve->domain();
  const auto grid = orispline::SampleGrid::make({.spacing = orispline::SampleGrid::Rate{rate}}, start, end);
  if (!grid) return tl::unexpected(grid.error());
  const orispline::TimeOrigin origin(track.epoch);  // exact, so that times of 1.7e9 s keep their nanoseconds
  auto writer = orispline::io::SampleWriter::open(output, {.derivatives = 2});
  if (!writer) return tl::unexpected(writer.error());
  for (std::uint64_t k = 0; k < *grid->size(); ++k) {
    const orispline::Instant instant = (*grid)[k];
    if (auto written = writer->write(origin.plus(instant.offset), {.motion = curve->motion(instant.t)}); !written)
      return tl::unexpected(written.error());
  }
  return writer->finish().map([&] { return *grid->size(); });
}

int main() {
  std::ofstream("keys.csv") << "t,qw,qx,qy,qz\n"
                               "1700000000.25,1,0,0,0\n"
                               "1700000000.75,0.8,0.6,0,0\n"
                               "1700000002,0,1,0,0\n";
  const auto count = resample("keys.csv", "motion.csv", 50.0);
  if (!count) return std::fprintf(stderr, "%s\n", describe(count.error()).c_str()), 1;
  std::printf("%llu samples\n", static_cast<unsigned long long>(*count));
  std::ifstream motion("motion.csv");
  std::string header, row;
  std::getline(std::getline(motion, header), row);
  std::printf("%s\nfirst at %s s\n", header.c_str(), row.substr(0, row.find(',')).c_str());

  std::ofstream("torn.csv") << "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,x\n";
  std::printf("%s\n", describe(resample("torn.csv", "motion.csv", 50.0).error()).c_str());
  std::ifstream kept("motion.csv");
  std::printf("still there: %s\n", std::getline(kept, header) ? header.c_str() : "nothing");
}
