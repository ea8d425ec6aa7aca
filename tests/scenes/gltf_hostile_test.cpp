// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include <sys/stat.h>

#include "scenes/gltf_file.hpp"

namespace orispline::scenes { namespace {

using test::bytes_of;
using test::GltfFile;
using test::said_of;

struct Hostile {
  std::string content, message;
};

void expect_refused(const std::vector<Hostile>& files) {
  for (const Hostile& file : files)
    EXPECT_EQ(said_of(file.content), "scene.gltf: " + file.message) << file.content.substr(0, 300);
}

std::string with_nodes(std::string_view nodes) {
  GltfFile file;
  file.nodes = nodes;
  return file.text();
}

/// The turning arm with a text in its document replaced by another.
std::string turning_but(std::string_view found, std::string_view replacement) {
  std::string text = test::turning().text();
  const std::size_t at = text.find(found);
  EXPECT_NE(at, std::string::npos) << found;
  return text.replace(at, found.size(), replacement);
}

std::string with_keys(const std::vector<float>& times, const std::vector<float>& values) {
  GltfFile file;
  const std::size_t input = file.floats("SCALAR", times);
  file.animate(input, file.floats("VEC4", values));
  return file.text();
}

TEST(GltfHostile, Documents) {
  expect_refused({
      {"", "empty: no skeleton"},
      {"{\"asset\":", "found text that is not valid JSON, wanted a glTF document"},
      {"{\"asset\":{\"version\":\"2.0\"},\"a\":1e999}", "found text that is not valid JSON, wanted a glTF document"},
      {"[1]", "found JSON that is no object, wanted a glTF document"},
      {std::string(100000, '['), "found JSON nested deeper than 512 levels, wanted fewer"},
      {"[" + std::string(std::size_t{1} << 24, ',') + "]", "found JSON of more than 16777216 values, wanted fewer"},
      {"{}", "found no asset, wanted an object"},
      {R"({"asset":{"version":2.0}})", "asset: found 2.0 as version, wanted text"},
      {R"({"asset":{"version":"1.0"}})", "asset: found version '1.0', wanted 2.0"},
      {R"({"asset":{"version":"2.0","minVersion":"2.1"}})", "asset: found minVersion '2.1', wanted 2.0"},
      {R"({"asset":{"version":"2.0"},"nodes":{}})", "found an object as nodes, wanted a list"},
      {R"({"asset":{"version":"2.0"},"nodes":[7]})", "node 0: found 7, wanted an object"},
      {R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_accessor_float64"]})",
       "extension KHR_accessor_float64 is required, wanted animations in single precision"},
      {R"({"asset":{"version":"2.0"},"extensionsRequired":[3]})",
       "found 3 in extensionsRequired, wanted names of extensions"},
  });
}

TEST(GltfHostile, Containers) {
  const std::string glb = test::turning().glb();
  const auto with_number = [&](std::size_t at, std::uint32_t number) {
    std::string bytes = glb;
    return bytes.replace(at, 4, bytes_of(std::vector{number}));
  };
  const std::string size = std::to_string(glb.size()), room = std::to_string(glb.size() - 20);
  expect_refused({
      {"glTF", "found 4 bytes, wanted a whole GLB"},
      {with_number(4, 1), "found GLB version 1, wanted 2"},
      {with_number(8, 4000000000U), "found a GLB of " + size + " bytes that states 4000000000, wanted a whole one"},
      {with_number(8, 3), "found a GLB of " + size + " bytes that states 3, wanted a whole one"},
      {glb.substr(0, 100), "found a GLB of 100 bytes that states " + size + ", wanted a whole one"},
      {with_number(12, 4294967295U),
       "found a chunk of 4294967295 bytes at byte 12, wanted at most the " + room + " that follow"},
      {with_number(16, 1), "found a GLB without a JSON chunk, wanted it first"},
      {with_number(8, 12), "found a GLB without a JSON chunk, wanted it first"},
      {with_number(8, 17), "found 5 bytes at byte 12, wanted a chunk of a GLB"},
  });
}

TEST(GltfHostile, Nodes) {
  expect_refused({
      {with_nodes(R"([{"children":[1]},{"children":[0]}])"), "node 0: found among its own ancestors, wanted no circle"},
      {with_nodes(R"([{},{"children":[1]}])"), "node 1: found among its own ancestors, wanted no circle"},
      {with_nodes(R"([{"children":[2]},{"children":[2]},{}])"),
       "node 2: found as a child of node 0 and of node 1, wanted one parent"},
      {with_nodes(R"([{"children":[1]}])"), "node 0: found 1 in children, wanted whole numbers less than 1"},
      {with_nodes(R"([{"children":["a"]}])"), "node 0: found 'a' in children, wanted whole numbers less than 1"},
      {with_nodes(R"([{"children":[-1]}])"), "node 0: found -1 in children, wanted whole numbers less than 1"},
      {with_nodes(R"([{"name":"a\nb","rotation":[0,0,0,0]}])"),
       "node 'a?b': found a quaternion of norm 0, wanted norm 1"},
      {with_nodes(R"([{"rotation":[0,0,1]}])"), "node 0: found a list as rotation, wanted a list of 4 numbers"},
      {with_nodes(R"([{"translation":[0,0,"x"]}])"), "node 0: found a list as translation, wanted a list of 3 numbers"},
      {with_nodes(R"([{"name":5}])"), "node 0: found 5 as name, wanted text"},
      {with_nodes(R"([{"matrix":[1,0,0,0,1,1,0,0,0,0,1,0,0,0,0,1]}])"),
       "node 'node 0': found a matrix with shear, wanted translation, rotation and scale"},
      {with_nodes(R"([{"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]}])"),
       "node 'node 0': found a matrix whose last row is not 0 0 0 1, wanted translation, rotation and scale"},
      {with_nodes(R"([{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"scale":[1,1,1]}])"),
       "node 'node 0': found a matrix and a pose in parts, wanted one of them"},
  });
}

TEST(GltfHostile, Accessors) {
  const std::string place = "clip 'walk', joint 'arm': ", count = R"("count":3,"type":"VEC4")";
  expect_refused({
      {turning_but(R"("byteOffset":12,"byteLength":48)", R"("byteOffset":13,"byteLength":48)"),
       "bufferView 1: found 48 bytes from byte 13, wanted them within the 60 bytes of buffer 0"},
      {turning_but(R"("byteOffset":12)", R"("byteOffset":18446744073709551608)"),
       "bufferView 1: found 18446744073709551608 as byteOffset, wanted 2147483648 at most"},
      {turning_but(R"("buffer":0)", R"("buffer":1)"), "bufferView 0: found 1 as buffer, wanted less than 1"},
      {turning_but(count, R"("count":4,"type":"VEC4")"),
       place + "accessor 1: found 64 bytes from byte 0, wanted them within the 48 of its bufferView"},
      {turning_but(count, R"("count":2147483648,"type":"VEC4")"),
       place + "accessor 1: found 34359738368 bytes from byte 0, wanted them within the 48 of its bufferView"},
      {turning_but(count, R"("count":1152921504606846977,"type":"VEC4")"),
       place + "accessor 1: found 1152921504606846977 as count, wanted 2147483648 at most"},
      {turning_but(count, R"("count":0,"type":"VEC4")"), place + "accessor 1: found no elements, wanted one at least"},
      {turning_but(count, R"("count":"3","type":"VEC4")"),
       place + "accessor 1: found '3' as count, wanted a whole number from 0"},
      {turning_but(count, R"("count":2,"type":"VEC4")"), place + "found 2 outputs in accessor 1 for 3 keys, wanted 3"},
      {turning_but(R"("VEC4")", R"("VEC3")"), place + "accessor 1: found type 'VEC3', wanted VEC4"},
      {turning_but(R"("componentType":5126,"count":3,"type":"VEC4")",
                   R"("componentType":5124,"count":3,"type":"VEC4")"),
       place + "accessor 1: found componentType 5124, wanted 5120 to 5126 without 5124"},
      {turning_but(R"("componentType":5126,"count":3,"type":"VEC4")",
                   R"("componentType":5122,"count":3,"type":"VEC4")"),
       place +
           "accessor 1: found integers of componentType 5122, wanted floats or normalised integers of 8 or 16 bits"},
      {turning_but(R"("bufferView":1)", R"("bufferView":2)"),
       place + "accessor 1: found 2 as bufferView, wanted less than 2"},
      {turning_but(R"({"bufferView":1,"componentType":5126,"count":3)", R"({"componentType":5126,"count":2000000000)"),
       place + "accessor 1: found 2000000000 elements without a bufferView, wanted 65536 at most"},
      {turning_but(R"("byteLength":48)", R"("byteLength":48,"byteStride":8)"),
       place + "accessor 1: found elements of 16 bytes every 8 bytes, wanted them apart"},
      {turning_but(R"("byteLength":48)", R"("byteLength":48,"byteStride":2147483648)"),
       place + "accessor 1: found 4294967312 bytes from byte 0, wanted them within the 48 of its bufferView"},
  });
}

TEST(GltfHostile, SparseElements) {
  const auto with_sparse = [](std::string_view sparse) {
    GltfFile file;
    const std::size_t times = file.floats("SCALAR", {0, 1, 2});
    file.view(bytes_of(std::vector<std::uint8_t>{2, 1, 9}));
    file.animate(times,
                 file.accessor(fmt::format(R"(,"componentType":5126,"count":3,"type":"VEC4","sparse":{})", sparse),
                               bytes_of(test::quarter_turns)));
    return file.text();
  };
  const std::string place = "clip 'walk', joint 'arm': ";
  const std::string values = R"("values":{"bufferView":2})";
  expect_refused({
      {with_sparse("3"), place + "accessor 1: found 3 as sparse, wanted an object"},
      {with_sparse(R"({"count":4})"),
       place + "accessor 1, sparse: found a count of 4, wanted 1 to the 3 of the accessor"},
      {with_sparse(R"({"count":2,"indices":{"bufferView":1,"componentType":5121},)" + values + "}"),
       place + "found sparse index 1, wanted 3 to 2"},
      {with_sparse(R"({"count":1,"indices":{"bufferView":1,"byteOffset":2,"componentType":5121},)" + values + "}"),
       place + "found sparse index 9, wanted 0 to 2"},
      {with_sparse(R"({"count":1,"indices":{"bufferView":1,"componentType":5126},)" + values + "}"),
       place + "accessor 1, sparse, indices: found componentType 5126, wanted 5121, 5123 or 5125"},
      {with_sparse(R"({"count":1,"indices":{"bufferView":1,"componentType":5125},)" + values + "}"),
       place + "accessor 1, sparse, indices: found 4 bytes from byte 0, wanted them within the 3 of its bufferView"},
  });
}

TEST(GltfHostile, Buffers) {
  const auto with_uri = [](std::string_view uri) {
    return test::turning().json(fmt::format(R"({{"byteLength":60,"uri":"{}"}})", uri));
  };
  const auto refused = [](std::string_view uri) {
    return fmt::format("buffer 0: found uri '{}', wanted a file beside the glTF file", uri);
  };
  expect_refused({
      {with_uri("../secret.bin"), refused("../secret.bin")},
      {with_uri("a/../../secret.bin"), refused("a/../../secret.bin")},
      {with_uri("%2e%2e/secret.bin"), refused("%2e%2e/secret.bin")},
      {with_uri("/etc/passwd"), refused("/etc/passwd")},
      {with_uri("%2Fetc/passwd"), refused("%2Fetc/passwd")},
      {with_uri("file:///etc/passwd"), refused("file:///etc/passwd")},
      {with_uri("https://example.org/a.bin"), refused("https://example.org/a.bin")},
      {with_uri("..\\\\secret.bin"), refused("..\\secret.bin")},
      {with_uri(""), refused("")},
      {with_uri("data:text/plain,abc"), "buffer 0: found a data uri that is not base64, wanted one that is"},
      {with_uri("data:;base64,A*A="), "buffer 0: found a data uri that is not base64, wanted one that is"},
      {with_uri("data:;base64,AAAA"), "buffer 0: found 3 bytes, wanted the 60 of its byteLength"},
      {test::turning().json(R"({"byteLength":60})"),
       "clip 'walk', joint 'arm': accessor 0: found bufferView 0 without data, wanted uncompressed data"},
  });
  EXPECT_EQ(said_of(with_uri("missing.bin")), "missing.bin: cannot read: No such file or directory");
}

TEST(GltfHostile, BuffersThatAreNoFilesOrAreElsewhere) {
  namespace fs = std::filesystem;
  const orispline::test::ScratchDirectory folder;
  const auto name = [&](std::string_view in_folder) { return folder.file(in_folder); };
  const GltfFile file = test::turning();
  for (const char* made : {"inside", "inside/below", "outside"}) fs::create_directory(name(made));
  for (const char* copy : {"outside/keys.bin", "inside/below/keys.bin"})
    std::ofstream(name(copy), std::ios::binary) << file.binary;
  fs::create_symlink("../outside/keys.bin", name("inside/away.bin"));
  fs::create_directory_symlink("../outside", name("inside/way"));
  fs::create_symlink("below/keys.bin", name("inside/down.bin"));
  fs::create_symlink("nowhere.bin", name("inside/dangling.bin"));
  fs::create_symlink("/dev/zero", name("inside/zero.bin"));
  ASSERT_EQ(::mkfifo(name("inside/pipe.bin").c_str(), 0600), 0);
  const auto said = [&](std::string_view uri) {
    const std::string path = name("inside/scene.gltf");
    std::ofstream(path, std::ios::binary)
        << file.json(fmt::format(R"({{"byteLength":{},"uri":"{}"}})", file.binary.size(), uri));
    const auto scene = read_scene(path);
    return scene ? fmt::format("{} bytes", scene->bytes - fs::file_size(path)) : scene.error().message;
  };
  const std::string read = fmt::format("{} bytes", file.binary.size());
  EXPECT_EQ(said("below/keys.bin"), read);
  fs::copy_file(name("inside/below/keys.bin"), name("inside/huge.bin"));
  fs::resize_file(name("inside/huge.bin"), std::uintmax_t{1} << 31);  // no more than the buffer is read
  EXPECT_EQ(said("huge.bin"), fmt::format("{} bytes", std::uintmax_t{1} << 31));
  std::ofstream(name("inside/short.bin"), std::ios::binary) << "abc";
  EXPECT_EQ(said("short.bin"),
            fmt::format("buffer 0: found 3 bytes, wanted the {} of its byteLength", file.binary.size()));
  EXPECT_EQ(said("down.bin"), read);
  for (const char* away : {"away.bin", "way/keys.bin"})
    EXPECT_EQ(said(away), fmt::format("buffer 0: found uri '{}', a link to another folder, wanted a file beside the "
                                      "glTF file; copy it there",
                                      away));
  for (const char* other : {"pipe.bin", "below", "zero.bin"})
    EXPECT_EQ(said(other),
              fmt::format("buffer 0: found uri '{}', which is a folder, a pipe or a device, wanted a file", other));
  EXPECT_EQ(said("dangling.bin"), "cannot read: No such file or directory");
  fs::create_directory_symlink("inside", name("linked"));
  EXPECT_TRUE(read_scene(name("linked/scene.gltf")).error().message.starts_with("cannot read"))
      << "a folder that is a link itself is the folder";
}

TEST(GltfHostile, Animations) {
  const std::string place = "clip 'walk', joint 'arm': ";
  const std::string key = "clip 'walk', joint 'arm', key ";
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  expect_refused({
      {turning_but(R"("sampler":0)", R"("sampler":1)"),
       "animation 0, channel 0: found 1 as sampler, wanted less than 1"},
      {turning_but(R"("node":0)", R"("node":1)"),
       "animation 0, channel 0, target: found 1 as node, wanted less than 1"},
      {turning_but(R"("path":"rotation")", R"("path":4)"),
       "animation 0, channel 0, target: found 4 as path, wanted text"},
      {turning_but(R"("input":0)", R"("input":"a")"),
       place + "animation 0, sampler 0: found 'a' as input, wanted a whole number from 0"},
      {turning_but(R"("LINEAR")", R"("SPLINE")"),
       place + "animation 0, sampler 0: found interpolation 'SPLINE', wanted LINEAR, STEP or CUBICSPLINE"},
      {turning_but(R"("LINEAR")", R"("CUBICSPLINE")"), place + "found 3 outputs in accessor 1 for 3 keys, wanted 9"},
      {with_keys({0, 2, 1}, test::quarter_turns), key + "2: found time 1 after 2, wanted increasing times"},
      {with_keys({0, nan, 1}, test::quarter_turns), key + "1: found time nan, wanted a finite number"},
      {with_keys({0, 1}, {0, 0, 0, 1, 0, 0, 0, 0}), key + "1: found a quaternion of norm 0, wanted norm 1"},
      {with_keys({0, 1}, {0, 0, 0, 1, 0, 0, 0, 1.5F}), key + "1: found a quaternion of norm 1.5, wanted norm 1"},
      {with_keys({0, 1}, {0, 0, nan, 1, 0, 0, 0, 1}), key + "0: found a number that is not finite, wanted finite ones"},
      {turning_but(R"("channels":[)", R"("channels":[{"sampler":0,"target":{"node":0,"path":"rotation"}},)"),
       place + "found a second channel of its rotation, wanted one"},
  });
}

TEST(GltfHostile, FewBytesThatStandForManyKeys) {
  GltfFile file;
  const std::size_t times = file.floats("SCALAR", std::vector<float>{0});
  file.accessors.push_back(R"({"componentType":5126,"count":65536,"type":"VEC3"})");
  file.accessors.push_back(R"({"componentType":5126,"count":65536,"type":"SCALAR"})");
  static_cast<void>(times);
  for (int i = 0; i < 1100; ++i) file.animate(2, 1, "LINEAR", "scale");
  const auto scene = test::read(file.text(), {.drop_duplicates = true});
  ASSERT_TRUE(scene) << describe(scene.error());  // the zeros are one key each
  EXPECT_EQ(scene->clips[0].scales[0].size(), 1u);
}

TEST(GltfHostile, ManyAccessorsWithoutDataThatStandForManyKeys) {
  GltfFile file;
  static_cast<void>(file.floats("SCALAR", std::vector<float>{0}));
  for (std::size_t i = 0; i < 80; ++i) {
    for (const char* type : {"SCALAR", "VEC3"})
      file.accessors.push_back(fmt::format(R"({{"componentType":5126,"count":{},"type":"{}"}})", 65536 - i, type));
    file.animate(2 * i + 1, 2 * i + 2, "LINEAR", "scale");
  }
  const auto scene = test::read(file.text(), {.drop_duplicates = true});
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message,
            "clip 'walk', joint 'arm': found more than 4194308 keys in accessors that overlap or have no data, wanted "
            "channels that share accessors");
}

}}  // namespace orispline::scenes
