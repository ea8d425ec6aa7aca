// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/scene_file.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/scenes/cubic_signs.hpp>
#include <orispline/scenes/scene_units.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

namespace {

Expected<const SceneFormat*> format_for(const std::string& path) {
  if (const SceneFormat* format = scene_format_of(path)) return format;
  std::string wanted;
  for (const SceneFormat* format : scene_formats())
    for (const std::string_view extension : format->extensions)
      wanted += formatted("{}{}", wanted.empty() ? "" : ", ", extension);
  return failure(ErrorCode::bad_argument,
                 formatted("found a file of no format that holds a skeleton, wanted one of {}", wanted),
                 {.file = path});
}

tl::unexpected<Error> unreadable(const std::string& path) {
  return failure(ErrorCode::bad_access, formatted("cannot read: {}", std::strerror(errno)), {.file = path});
}

/// How large a file is that has a size, as pipes have none; whatever it says, reading goes to its end.
std::size_t size_of(std::FILE* file) {
  const long size = std::fseek(file, 0, SEEK_END) == 0 ? std::ftell(file) : -1;
  std::rewind(file);
  return size > 0 ? static_cast<std::size_t>(size) : 0;
}

tl::unexpected<Error> too_large(const std::string& path) {
  return failure(ErrorCode::bad_access, "found more than 2 GiB, wanted a smaller file", {.file = path});
}

Expected<void> check_compression(const SceneWriting& writing, const SceneFormat& format) {
  if (writing.compression != KeyCompression::none && &format != &gltf_format)
    return bad_option("compress", formatted("found an output that is {}, wanted glTF", format.file));
  return check(writing.compression);
}

Expected<Scene> checked(Scene scene) {
  for (const Clip& clip : scene.clips)
    if (auto sound = check_clip(scene.skeleton, clip); !sound) return tl::unexpected(std::move(sound.error()));
  return scene;
}

}  // namespace

MotionFile motion_file_of(const Scene& scene) {
  return {.name = scene.name,
          .skeleton = scene.skeleton,
          .clips = scene.clips,
          .format = scene.format ? ClipFormat(*scene.format) : ClipFormat(),
          .next_tool = scene.next_tool};
}

Scene with_motion(Scene scene, const MotionFile& made) {
  const bool had_no_unit = scene.format && scene.format->has_no_unit;
  scene.skeleton = made.skeleton;
  scene.clips = made.clips;
  if (had_no_unit && !made.format.has_no_unit) {
    scene.format = nullptr;
    scene.source.reset();
  }
  return scene;
}

Expected<std::string> bytes_of_file(const std::string& path, const SceneFormat* format, std::size_t most) {
  if (path == io::standard_stream)
    return failure(ErrorCode::bad_argument, "found standard input for a file of skeletons, wanted the name of a file");
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  if (!file) return unreadable(path);
  constexpr std::size_t piece = std::size_t{1} << 20;
  const std::size_t size = size_of(file.get());
  if (size > largest_scene_file) return too_large(path);
  std::string bytes;
  for (std::size_t got = piece; got == piece && bytes.size() < most;) {
    const std::size_t had = bytes.size();
    bytes.resize(had + piece);
    got = std::fread(bytes.data() + had, 1, piece, file.get());
    bytes.resize(had + got);
    if (had > 0 || size <= got) continue;
    if (format != nullptr && format->check_start != nullptr)
      if (auto sound = format->check_start(bytes, size, path); !sound) return tl::unexpected(std::move(sound.error()));
    bytes.reserve(std::min(size, most) + piece);
  }
  if (std::ferror(file.get())) return unreadable(path);
  bytes.resize(std::min(bytes.size(), most));
  if (bytes.size() > largest_scene_file) return too_large(path);  // of a file that did not state its size
  return bytes;
}

Expected<Scene> read_scene(const io::Input& input, const SceneReading& reading) {
  const std::string& path = input.name();
  const auto format = reading.format ? Expected<const SceneFormat*>(reading.format) : format_for(path);
  if (!format) return tl::unexpected(format.error());
  const auto in_this_file = [&](Error error) {
    if (error.where.file.empty()) error.where.file = path;
    return error;
  };
  const auto file = input.is_in_memory() ? Expected<std::string>() : bytes_of_file(path, *format);
  if (!file) return tl::unexpected(in_this_file(file.error()));
  if (reading.rest_frame && *format != &bvh_format)
    return bad_option("rest_frame", formatted("found {}, which states its rest pose, wanted BVH", (*format)->file));
  const std::string_view bytes = input.is_in_memory() ? input.bytes() : *file;
  if (bytes.empty()) return failure(ErrorCode::bad_data, "empty: no skeleton", {.file = path});
  auto scene = (*format)->read(bytes, input, reading).and_then(checked).map_error(in_this_file);
  if (!scene) return scene;
  scene->name = path;
  scene->bytes += bytes.size();
  scene->format = *format;
  return with_cubic_signs(*std::move(scene), reading.signs);
}

Expected<SceneWritten> written_scene(const Scene& scene, const std::string& path, const SceneWriting& writing) {
  const auto format = format_for(path);
  if (!format) return tl::unexpected(format.error());
  if (!(*format)->write)
    return failure(ErrorCode::bad_argument,
                   formatted("{} files are read only, wanted another format, such as glTF", (*format)->title),
                   {.file = path});
  for (const Clip& clip : scene.clips)
    if (auto sound = check_clip(scene.skeleton, clip); !sound) return tl::unexpected(std::move(sound.error()));
  if (auto known = check_compression(writing, **format); !known) return tl::unexpected(std::move(known.error()));
  const auto with_height = [&](SceneWritten written) {
    if (scene.format && !(*format)->has_no_unit)
      for (Warning& warning :
           warnings_of_height(scene.skeleton, *scene.format, writing.position_scale.value_or(1.0), path))
        written.warnings.push_back(std::move(warning));
    return written;
  };
  if (!writing.position_scale) return (*format)->write(scene, path, writing).map(with_height);
  if ((*format)->has_no_unit)
    return bad_option("position_scale",
                      formatted("found an output that is {}, which has no unit of length and keeps that "
                                "of the input, wanted glTF",
                                (*format)->file));
  return in_metres(scene, *writing.position_scale).and_then([&](const Scene& scaled) {
    return (*format)->write(scaled, path, writing).map(with_height);
  });
}

Expected<std::vector<Warning>> write_scene(const Scene& scene, const std::string& path, const SceneWriting& writing) {
  auto written = written_scene(scene, path, writing);
  if (!written) return tl::unexpected(std::move(written.error()));
  return io::OutputFile::open(path).and_then([&](io::OutputFile file) {
    return file.write(written->bytes).and_then([&] { return file.finish(); }).map([&] {
      return std::move(written->warnings);
    });
  });
}

}}}  // namespace orispline::scenes
