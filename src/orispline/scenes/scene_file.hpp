// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/clip/key_compression.hpp>
#include <orispline/clip/motion_file.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/io/input.hpp>
#include <orispline/math/euler.hpp>

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
  std::size_t bytes = 0;    ///< of the files that were read; 0 for a scene that was made
  std::string next_tool{};  ///< of those that compress glTF, by which the file was written or is to be read; else empty
  bool has_integer_keys = false;                ///< in the file, where they take fewer bytes than floats do
  std::vector<Warning> warnings{};              ///< of reading
  const SceneFormat* format = nullptr;          ///< of the file; null for a scene that was made
  std::shared_ptr<const SceneSource> source{};  ///< null for a scene that was made
};

/// What the tasks on skeletons take.
[[nodiscard]] ORISPLINE_EXPORT MotionFile motion_file_of(const Scene& scene);

/// A scene with what a task made of it, and what else its file holds. In another unit of length it is one that was
/// made.
[[nodiscard]] ORISPLINE_EXPORT Scene with_motion(Scene scene, const MotionFile& made);

/// How a scene is to be read.
struct SceneReading {
  bool drop_duplicates = false;         ///< of keys of a channel at equal times keep the first
  std::optional<Signs> signs{};         ///< of `cubicspline` rotations; absent: as given, with a warning of long ways
  const SceneFormat* format = nullptr;  ///< of the file; null: that of its extension
  bool salvage = false;                 ///< of a BVH file that was cut off take the whole frames that are there
  std::optional<std::size_t> rest_frame{};  ///< of a BVH file: its pose is the rest pose; absent: that of the offsets
};

/// How a scene is to be written.
struct SceneWriting {
  std::optional<EulerOrder> euler{};  ///< of BVH: absent is the input's, else ZYX about the axes of the body
  std::optional<double> rate{};  ///< of BVH: frames per second [Hz]; absent is that of the keys, which must be even
  /// Of glTF: metres in the unit of length of a scene whose file states none; its lengths are written in metres.
  /// Absent: they are written as they are.
  std::optional<double> position_scale{};
  KeyCompression compression = KeyCompression::none;  ///< of glTF, in which no number becomes another one
  bool bones = true;  ///< of glTF: whether a skeleton without a mesh gets one bone of a few triangles per joint
};

/// How many keys, or frames of joints, there are in a file.
struct WrittenKeys {
  std::size_t rotations = 0, translations = 0, scales = 0;
};

/// What became of a scene that was written.
struct SceneWritten {
  std::string bytes{};              ///< of the file
  WrittenKeys keys{};               ///< in the file
  std::vector<Warning> warnings{};  ///< of what the format has no room for
};

/// A format of files of skeletons and clips: all that is known of it elsewhere.
struct ORISPLINE_EXPORT SceneFormat : ClipFormat {
  std::string_view id;                             ///< the word that it is chosen by: `bvh`
  std::string_view summary;                        ///< what it is, in a few words
  std::span<const std::string_view> extensions{};  ///< in small letters, with their dots

  /// Whether a file of so many bytes that begins with `start` can be one of the format, before all of it is read: the
  /// errors are those of `read`. Null: only `read` tells.
  Expected<void> (*check_start)(std::string_view start, std::size_t size, const std::string& path) = nullptr;
  /// From the bytes of a file; where they are from is for messages and for files beside it. Errors name the file, and
  /// the line or clip, joint and key: bad_data, bad_access.
  Expected<Scene> (*read)(std::string_view bytes, const io::Input& from, const SceneReading&) = nullptr;
  /// The path tells what the extension asks for. Errors: bad_data for what the format cannot hold, bad_argument.
  /// Null: files of the format are read only.
  Expected<SceneWritten> (*write)(const Scene&, const std::string& path, const SceneWriting&) = nullptr;

  /// Whether a path ends in one of the extensions, in any case of letters.
  [[nodiscard]] bool has_extension_of(std::string_view path) const noexcept;
};

// THE list of formats. Each is stated by the file of this folder that has its name.
extern const SceneFormat bvh_format, gltf_format;

/// All formats, in the order in which they are shown.
[[nodiscard]] ORISPLINE_EXPORT std::span<const SceneFormat* const> scene_formats() noexcept;
/// The format of that word, and that with the extension of the path; null if there is none.
[[nodiscard]] ORISPLINE_EXPORT const SceneFormat* scene_format_named(std::string_view id) noexcept;
[[nodiscard]] ORISPLINE_EXPORT const SceneFormat* scene_format_of(std::string_view path) noexcept;

/// A file larger than this is not read [bytes].
inline constexpr std::size_t largest_scene_file = std::size_t{2} << 30;

/// The bytes of a file, `most` of them from its beginning. Of a large one the format is asked first whether it can be
/// one of its files. Errors: bad_access where it cannot be read or is larger than `largest_scene_file`; those of
/// check_start().
[[nodiscard]] ORISPLINE_EXPORT Expected<std::string> bytes_of_file(const std::string& path,
                                                                   const SceneFormat* format = nullptr,
                                                                   std::size_t most = largest_scene_file + 1);

/// Reads the skeleton and the clips of a file, in the format of its extension, and checks them by check_clip().
///
/// Errors name the file: bad_access; bad_data; bad_argument for an extension of no format.
[[nodiscard]] ORISPLINE_EXPORT Expected<Scene> read_scene(const io::Input& input, const SceneReading& reading = {});

/// The bytes of a file in the format of the extension of `path`; what the scene's file held besides is passed on where
/// that is the same format.
///
/// Errors: bad_argument for an extension of no format; bad_data for what the format cannot hold.
[[nodiscard]] ORISPLINE_EXPORT Expected<SceneWritten> written_scene(const Scene& scene, const std::string& path,
                                                                    const SceneWriting& writing = {});

/// Writes a scene in the format of the extension of `path`; what the scene's file held besides is passed on where that
/// is the same format. The file appears complete or not at all. Returns what the format had no room for.
///
/// Errors: bad_access; bad_argument for an extension of no format; bad_data for what the format cannot hold.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<Warning>> write_scene(const Scene& scene, const std::string& path,
                                                                          const SceneWriting& writing = {});

}}}  // namespace orispline::scenes
