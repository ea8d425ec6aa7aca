// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <iterator>
#include <string>

#include <nlohmann/json.hpp>

#include "c/handles.hpp"
#include "support/places.hpp"

namespace orispline { namespace {

using namespace testing_support;

using Options = std::vector<const char*>;

struct Read {
  Result result;
  KeysHandle keys;
};

Read read(const std::string& bytes, const char* name, const Options& options = {}) {
  orispline_keys* keys = nullptr;
  Result result = call(orispline_keys_read, static_cast<const void*>(bytes.data()), bytes.size(), name, options.data(),
                       options.size(), &keys);
  return {std::move(result), KeysHandle(keys)};
}

std::string written(const KeysHandle& keys, const char* name, const Options& options = {}) {
  char* bytes = nullptr;
  std::size_t size = 0;
  expect_ok(call(orispline_keys_write, static_cast<const orispline_keys*>(keys.get()), name, options.data(),
                 options.size(), &bytes, &size, static_cast<char**>(nullptr)));
  const Owned<char, orispline_text_free> owned(bytes);
  return bytes ? std::string(bytes, size) : "";
}

nlohmann::json json_of(const KeysHandle& keys) {
  return nlohmann::json::parse(text_by(orispline_keys_json, static_cast<const orispline_keys*>(keys.get())));
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(FilesOfC, AreReadWithAllThatTheyHave) {
  const Read file = read(
      "# keys.csv\n# method: timed-c2:ends=rest\nt,qw,qx,qy,qz,tension,wx,wy,wz,colour\n"
      "1700000000.5,1,0,0,0,0.5,0,0,1,red\n1700000001.5,0.6,0,0,0.8,1,0,0,1,blue\n",
      "data/keys.csv");
  expect_ok(file.result);
  const auto json = json_of(file.keys);
  EXPECT_EQ(json["count"], 2);
  EXPECT_EQ(json["epoch"], "1700000000.5");
  EXPECT_EQ(json["name"], "data/keys.csv");
  EXPECT_EQ(json["format"], "csv");
  EXPECT_EQ(json["ignored_columns"], nlohmann::json({"colour"}));
  EXPECT_EQ(json["repairs"]["duplicates_dropped"], 0);
  EXPECT_TRUE(json["warnings"].is_array());
  EXPECT_EQ(json["columns"].size(), 4u) << json.dump();
}

TEST(FilesOfC, AreWrittenAndReadAgain) {
  const KeyframeData data = walk(5);
  const std::vector<double> tensions(5, 0.25);
  const KeysHandle keys = keys_of(data, {column("tension", tensions)});
  for (const char* name : {"keys.csv", "keys.tum", "keys.txt"}) {
    const Read again = read(written(keys, name), name);
    ASSERT_EQ(again.result.code, ORISPLINE_OK) << name << ": " << again.result.text();
    std::vector<double> found(20), wanted(20);
    expect_ok(call(orispline_keys_column, static_cast<const orispline_keys*>(again.keys.get()), "orientations",
                   ORISPLINE_WXYZ, found.data(), found.size()));
    expect_ok(call(orispline_keys_column, static_cast<const orispline_keys*>(keys.get()), "orientations",
                   ORISPLINE_WXYZ, wanted.data(), wanted.size()));
    const double sign = found[0] * wanted[0] < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(sign * found[i], wanted[i], 1e-7) << name;
  }
  EXPECT_EQ(written(keys, "keys.csv").substr(0, 14), "t,qw,qx,qy,qz,");
  EXPECT_EQ(written(keys, "keys.csv", {"output_orientation=rotvec"}).substr(0, 5), "t,rx,");
}

TEST(FilesOfC, OfTheExamplesAreThoseOfTheCommand) {
  const Read file = read(bytes_of(in_project("examples/data/flight_keys.csv")), "flight_keys.csv");
  expect_ok(file.result);
  EXPECT_EQ(orispline_keys_count(file.keys.get()), 38u);
  EXPECT_NE(curve_through(file.keys, nullptr), nullptr);
}

TEST(FilesOfC, NameTheLineThatIsWrong) {
  const Read file = read("t,qw,qx,qy,qz\n0,1,0,0,0\n0,1,0,0,0\n", "keys.csv");
  EXPECT_EQ(file.result.code, ORISPLINE_BAD_DATA);
  EXPECT_EQ(file.keys, nullptr);
  EXPECT_EQ(orispline_error_line(file.result.error.get()), 3);
  EXPECT_STREQ(orispline_error_file(file.result.error.get()), "keys.csv");
  EXPECT_STREQ(orispline_error_remedy(file.result.error.get()), "drop_duplicates");
  expect_ok(read("t,qw,qx,qy,qz\n0,1,0,0,0\n0,1,0,0,0\n", "keys.csv", {"drop_duplicates"}).result);
  EXPECT_EQ(read("", "keys.csv").result.code, ORISPLINE_BAD_DATA);
  EXPECT_EQ(read(std::string(10, '\0'), "keys.csv").result.code, ORISPLINE_BAD_DATA);
  EXPECT_EQ(read("{}", "keys.gltf").result.code, ORISPLINE_BAD_DATA);
}

TEST(FilesOfC, OfSkeletonsGiveTheKeysOfAJoint) {
  const std::string arm =
      "HIERARCHY\nROOT hip\n{\n OFFSET 0 0 0\n CHANNELS 3 Zrotation Xrotation Yrotation\n JOINT hand\n {\n"
      "  OFFSET 0 1 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n  End Site\n  {\n   OFFSET 0 1 0\n  }\n }\n}\n"
      "MOTION\nFrames: 3\nFrame Time: 0.5\n0 0 0 0 0 0\n0 0 0 10 0 0\n0 0 0 90 0 0\n";
  const Read hand = read(arm, "arm.bvh", {"joint=hand"});
  expect_ok(hand.result);
  std::vector<double> q(12);
  expect_ok(call(orispline_keys_column, static_cast<const orispline_keys*>(hand.keys.get()), "orientations",
                 ORISPLINE_WXYZ, q.data(), q.size()));
  EXPECT_NEAR(q[8] * q[8], 0.5, 1e-12);
  const Read foot = read(arm, "arm.bvh", {"joint=foot"});
  EXPECT_NE(foot.result.code, ORISPLINE_OK);
  EXPECT_NE(foot.result.text().find("hand"), std::string::npos) << foot.result.text();
}

TEST(FilesOfC, SayWhatIsLeftOut) {
  const std::vector<double> tensions(4, 0.25);
  const KeysHandle keys = keys_of(walk(4), {column("tension", tensions)});
  const auto warned = [&](const char* name) {
    char* bytes = nullptr;
    std::size_t size = 0;
    const std::string warnings = text_by(
        [&](const char* called, char** to, orispline_error** error) {
          return orispline_keys_write(keys.get(), called, nullptr, 0, &bytes, &size, to, error);
        },
        name);
    orispline_text_free(bytes);
    return nlohmann::json::parse(warnings);
  };
  EXPECT_EQ(warned("keys.csv").size(), 0u);
  EXPECT_EQ(warned("keys.tum")[0]["code"], "not_written");
}

TEST(FilesOfC, SayWhatCannotBeWritten) {
  const KeysHandle keys = keys_of(walk(3));
  char* bytes = nullptr;
  std::size_t size = 0;
  const auto fault = [&](const char* name, Options options) {
    Result result = call(orispline_keys_write, static_cast<const orispline_keys*>(keys.get()), name,
                         static_cast<const char* const*>(options.data()), options.size(), &bytes, &size,
                         static_cast<char**>(nullptr));
    EXPECT_EQ(result.code, ORISPLINE_BAD_ARGUMENT);
    EXPECT_EQ(bytes, nullptr);
    return result;
  };
  EXPECT_EQ(fault("keys.glb", {}).option(), "name");
  EXPECT_EQ(fault("keys.csv", {"output_format=xls"}).option(), "output_format");
  EXPECT_EQ(fault("keys.csv", {"rate=3"}).code, ORISPLINE_BAD_ARGUMENT);
}

TEST(FilesOfC, SayWhichOptionsThereAre) {
  const auto json = nlohmann::json::parse(text_by(orispline_files_json));
  EXPECT_GE(json["formats"].size(), 6u);
  EXPECT_GT(json["reading"].size(), 20u);
  EXPECT_GT(json["writing"].size(), 2u);
  const Read file = read("t,qw,qx,qy,qz\n0,1,0,0,0\n", "keys.csv", {"dropduplicates"});
  EXPECT_EQ(file.result.code, ORISPLINE_BAD_ARGUMENT);
  EXPECT_NE(file.result.text().find("drop_duplicates"), std::string::npos) << file.result.text();
}

}}  // namespace orispline
