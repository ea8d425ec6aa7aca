// SPDX-License-Identifier: Apache-2.0
// arm_page HTML: a report of clips of an arm that were reduced, for the tests of the page.
#include <cmath>
#include <cstdio>

#include <orispline/io/output_file.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { namespace {

constexpr double pi = 3.14159265358979323846;

/// 1.2 m of bones along x, on a foot 1 m above the floor; the foot walks, and carries a name that is hostile to HTML.
Skeleton arm() {
  const auto at = [](double x, double y) { return JointPose{.translation = Eigen::Vector3d(x, y, 0.0)}; };
  return Skeleton::make({{.name = "foot"},
                         {.name = "shoulder", .parent = 0, .rest = at(0.0, 1.0)},
                         {.name = "elbow", .parent = 1, .rest = at(0.5, 0.0)},
                         {.name = "</script><b>hand", .parent = 2, .rest = at(0.4, 0.0)},
                         {.name = "tip", .parent = 3, .rest = at(0.3, 0.0)}})
      .value();
}

Eigen::Quaterniond about(const Eigen::Vector3d& axis, double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

/// At 30 keys a second from `start` on: every joint swings the wider the larger its index.
Clip swing(std::string name, double start, std::size_t keys, double size) {
  Clip clip{.name = std::move(name), .translations = {{.joint = 0}}};
  for (std::size_t joint = 1; joint < 4; ++joint) clip.rotations.push_back({.joint = joint});
  for (std::size_t i = 0; i < keys; ++i) {
    const double passed = static_cast<double>(i) / 30.0, wave = std::sin(2.0 * pi * passed);
    clip.translations[0].times.push_back(start + passed);
    clip.translations[0].values.emplace_back(0.0, 0.0, 1.5 * passed);
    for (RotationChannel& channel : clip.rotations) {
      channel.times.push_back(start + passed);
      const double angle = size * wave * static_cast<double>(channel.joint);
      channel.values.push_back(about(channel.joint % 2 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY(), angle));
    }
  }
  return clip;
}

Expected<report::SkeletonPage> arm_page() {
  const Skeleton skeleton = arm();
  std::vector<Clip> clips;
  for (std::size_t i = 1; i <= 6; ++i)
    clips.push_back(swing("swing " + std::to_string(i), 0.5, 20 * i, 0.1 * static_cast<double>(i)));
  clips.push_back({.name = "still"});
  const ClipReduceOptions options{.tolerance = 0.5 * pi / 180.0, .world_tolerance = 0.02};
  return reduce_clips(skeleton, clips, options).map([&](const std::vector<ClipReduction>& reductions) {
    return pages::reduced_clips_page(
        {"arm.glb", skeleton, clips}, "small.glb", reductions, options, {},
        {.command = "orispline reduce arm.glb --tolerance 0.5deg -o small.glb", .date = "2026-01-02 03:04"});
  });
}

}}  // namespace orispline

int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape): then the test fails
  if (argc != 2) return std::fputs("usage: arm_page HTML\n", stderr), 2;
  const auto written = orispline::arm_page().and_then([&](const orispline::report::SkeletonPage& page) {
    return orispline::io::OutputFile::open(argv[1]).and_then([&](orispline::io::OutputFile file) {
      return file.write(orispline::report::skeleton_document(page)).and_then([&] { return file.finish(); });
    });
  });
  if (!written) return std::fprintf(stderr, "%s\n", orispline::describe(written.error()).c_str()), 1;
}
