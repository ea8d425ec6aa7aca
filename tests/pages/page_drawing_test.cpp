// SPDX-License-Identifier: Apache-2.0
// What the page draws, rebuilt from the data in its file, beside the curves themselves.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <orispline/base/base64.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/report/page_json.hpp>
#include <orispline/report/page_template.hpp>
#include <pages/page_head.hpp>
#include <support/drawn_as_stated.hpp>
#include <support/places.hpp>

namespace orispline { namespace {

using testing_support::DrawnAsStated;

constexpr double drawn_within = 0.005;  // [deg], or the angle that the page states

template <class Number>
std::vector<Number> unpacked(const nlohmann::json& text) {
  const std::string bytes = bytes_from_base64(text.get<std::string>()).value();
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

/// A list of numbers in any of its forms.
std::vector<double> list_of(const nlohmann::json& list) {
  std::vector<double> numbers;
  const auto take = [&](const auto& values, double start, double unit) {
    for (const auto value : values) numbers.push_back(start + unit * static_cast<double>(value));
  };
  if (list.is_array())
    for (const auto& value : list) numbers.push_back(value.is_null() ? std::nan("") : value.get<double>());
  else if (list.contains("f8")) take(unpacked<double>(list["f8"]), 0.0, 1.0);
  else if (list.contains("f4")) take(unpacked<float>(list["f4"]), 0.0, 1.0);
  else if (list.contains("f2")) take(unpacked<Eigen::half>(list["f2"]), 0.0, list["unit"]);
  else take(unpacked<std::uint32_t>(list["u4"]), list["start"], list["step"]);
  return numbers;
}

DrawnAsStated drawn_of(const nlohmann::json& methods, std::size_t method) {
  const nlohmann::json& samples = methods[method]["samples"];
  const nlohmann::json& times = samples["t"];
  const bool is_like = times.is_object() && times.contains("like");
  DrawnAsStated drawn{.t = list_of(is_like ? methods[times["like"].get<std::size_t>()]["samples"]["t"] : times)};
  const auto q = list_of(samples["q"]), w = list_of(samples["w"]);
  for (std::size_t i = 0; i < drawn.t.size(); ++i) {
    drawn.q.emplace_back(q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]);
    drawn.w.emplace_back(w[3 * i], w[3 * i + 1], w[3 * i + 2]);
  }
  return drawn;
}

/// A part of a recording of the folder beside the project, at rising times; `every`th sample is a key.
struct Recording {
  KeyframeData all{}, keys{};

  [[nodiscard]] RecordedMotion recorded() const { return {all.times, all.orientations}; }
};

std::optional<Recording> recording_of(const std::string& path, std::size_t count, std::size_t every) {
  const auto file = io::read_keys(path);
  if (!file) return std::nullopt;
  Recording recording;
  const auto take = [](KeyframeData& to, double t, const Eigen::Quaterniond& q) {
    to.times.push_back(t);
    to.orientations.push_back(q.normalized());
  };
  for (std::size_t i = 0; i < file->data.times.size() && recording.all.times.size() < count; ++i) {
    const double t = file->data.times[i] - file->data.times[0];
    if (!recording.all.times.empty() && !(t > recording.all.times.back())) continue;
    if (recording.all.times.size() % every == 0) take(recording.keys, t, file->data.orientations[i]);
    take(recording.all, t, file->data.orientations[i]);
  }
  return recording;
}

/// Every method on the keys.
std::vector<ComparedMethod> methods_on(const Recording& recording) {
  std::vector<ComparedMethod> methods;
  const Keyframes keys = Keyframes::make(recording.keys).value();
  for (const FamilyInfo& family : families_info()) {
    const std::string name(family.name);
    methods.push_back({.label = name, .candidate = {name, keys}});
    methods.back().measures = measure(methods.back().candidate, recording.recorded());
  }
  return methods;
}

report::Page page_of(const Recording& recording, const std::vector<ComparedMethod>& methods) {
  return pages::compare_page({.methods = methods,
                              .recording = recording.recorded(),
                              .key_sets = {""},
                              .measures = measures_of({MeasureGroup::distance, MeasureGroup::shape})},
                             head);
}

/// At 1000 Hz, what is drawn of each method is near its curve, and so are angles between the first one and the others.
void expect_drawn(const Recording& recording) {
  const std::vector<ComparedMethod> methods = methods_on(recording);
  const auto data = nlohmann::json::parse(json_of(page_of(recording, methods)));
  EXPECT_EQ(data["data"], 2);
  const AnyCurve reference = curve_of(methods[0].candidate).value().orientation;
  const DrawnAsStated drawn_reference = drawn_of(data["methods"], 0);
  std::size_t shown = 0;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const nlohmann::json& samples = data["methods"][i]["samples"];
    if (!methods[i].measures) continue;
    ++shown;
    const AnyCurve curve = curve_of(methods[i].candidate).value().orientation;
    const DrawnAsStated drawn = drawn_of(data["methods"], i);
    EXPECT_LE(drawn.t.size(), 5000u) << methods[i].label;
    const double stated = std::max(drawn_within, samples["exactness_deg"].get<double>());
    double largest = 0.0, largest_between = 0.0;
    for (double t = curve.domain().start; t < curve.domain().end; t += 1e-3) {
      const Eigen::Quaterniond here = drawn(t);
      largest = std::max(largest, angular_distance(here, curve(t)) * degrees);
      largest_between = std::max(
          largest_between,
          std::abs(angular_distance(here, drawn_reference(t)) - angular_distance(curve(t), reference(t))) * degrees);
    }
    EXPECT_LE(largest, stated) << methods[i].label << ", " << drawn.t.size() << " samples";
    EXPECT_LE(largest_between, std::max(0.02, 2.0 * stated)) << methods[i].label;
  }
  EXPECT_GE(shown, 30u);
}

TEST(PageDrawing, IsNearTheCurvesOfEveryMethodOnRecordings) {
  const std::map<std::string, std::pair<std::size_t, std::size_t>> cut{
      {"data/flight/px4_quad_sample_attitude.csv", {300, 1}},
      {"data/trajectory/tum_fr2_desk_groundtruth.txt", {2400, 8}},
      {"data/spacecraft/mro_ck_sliced_-74000.csv", {60, 4}}};
  for (const auto& [name, part] : cut) {
    const std::string path = testing_support::beside_project(name);
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "without " << path;
    SCOPED_TRACE(name);
    const auto recording = recording_of(path, part.first, part.second);
    ASSERT_TRUE(recording.has_value());
    expect_drawn(*recording);
  }
}

TEST(PageDrawing, OfAllMethodsOn601KeysHasAtMost2Megabytes) {
  const auto recording = recording_of(testing_support::in_project("examples/data/flight_truth.csv"), 4808, 8);
  ASSERT_TRUE(recording.has_value());
  EXPECT_EQ(recording->keys.times.size(), 601u);
  const report::Page page = page_of(*recording, methods_on(*recording));
  EXPECT_GE(page.methods.size(), 39u);
  EXPECT_LE(report::document(page).size(), 2'000'000u);
}

}}  // namespace orispline
