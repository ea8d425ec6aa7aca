// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

struct SceneFormat;

/// What a file holds beside skeleton and clips. Writing in the same format passes it on; each format has its own.
class SceneSource {
 public:
  virtual ~SceneSource() = default;
};

/// A skeleton with its clips, as a file holds them.
struct Scene {
  std::string name{};  ///< of the file
  Skeleton skeleton{};
  std::vector<Clip> clips{};
  std::vector<Warning> warnings{};              ///< of reading
  const SceneFormat* format = nullptr;          ///< of the file; null for a scene that was made
  std::shared_ptr<const SceneSource> source{};  ///< null likewise
};

}}}  // namespace orispline::scenes
