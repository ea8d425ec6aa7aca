// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline::scenes::test {

/// What a text holds as a file `walk.bvh`.
inline Expected<Scene> read_bvh(std::string_view text) { return bvh_format.read(text, "folder/walk.bvh", {}); }

/// The scene of a text that is sound.
inline Scene scene_of(std::string_view text) {
  auto scene = read_bvh(text);
  if (!scene) {
    ADD_FAILURE() << describe(scene.error());
    return {};
  }
  scene->format = &bvh_format;
  return std::move(*scene);
}

inline Expected<SceneWritten> write_bvh(const Scene& scene, const SceneWriting& writing = {}) {
  return bvh_format.write(scene, "folder/out.bvh", writing);
}

/// The text of a scene that can be written.
inline std::string text_of(const Scene& scene, const SceneWriting& writing = {}) {
  const auto written = write_bvh(scene, writing);
  if (!written) ADD_FAILURE() << describe(written.error());
  return written ? written->bytes : std::string();
}

/// One joint that turns, with these words after its OFFSET and these lines of frames.
inline std::string one_joint(std::string_view channels, std::string_view frames,
                             std::string_view head = "Frames: 1\n") {
  std::string text = "HIERARCHY\nROOT hip\n{\n\tOFFSET 1 2 3\n\t";
  text.append(channels).append("\n}\nMOTION\n").append(head).append("Frame Time: .0083333\n").append(frames);
  return text;
}

/// The lines of the frames, as numbers.
inline std::vector<std::vector<double>> frames_of(const std::string& text) {
  std::istringstream lines(text.substr(text.find('\n', text.find("Frame Time:")) + 1));
  std::vector<std::vector<double>> frames;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    frames.emplace_back();
    for (double number = 0; numbers >> number;) frames.back().push_back(number);
  }
  return frames;
}

inline Eigen::Quaterniond turn_about(double angle, const Eigen::Vector3d& axis) {
  return exp<double>(Eigen::Vector3d(angle * axis));
}

/// A scene that was made.
inline Scene made_scene(std::vector<Joint> joints, Clip clip) {
  Scene scene;
  scene.skeleton = Skeleton::make(std::move(joints)).value();
  clip.name = "made";
  scene.clips.push_back(std::move(clip));
  return scene;
}

/// One joint that turns.
inline Scene turning(std::vector<double> times, std::vector<Eigen::Quaterniond> values) {
  return made_scene({{.name = "a"}}, {.rotations = {{.times = std::move(times), .values = std::move(values)}}});
}

}  // namespace orispline::scenes::test
