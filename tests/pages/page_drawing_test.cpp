// SPDX-License-Identifier: Apache-2.0
// What the page draws, rebuilt from the data in its file, beside the curves themselves.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

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
std::vector<double> unpacked(std::string_view text, double start, double unit) {
  const std::string bytes = bytes_from_base64(text).value();
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  std::vector<double> values;
  values.reserve(numbers.size());
  for (const Number number : numbers) values.push_back(start + unit * static_cast<double>(number));
  return values;
}

/// The number that a member has in the JSON; `otherwise` where there is no such member.
double number_in(const std::string& json, const std::string& name, double otherwise) {
  const std::size_t at = json.find('"' + name + "\":");
  return at == std::string::npos ? otherwise : std::stod(json.substr(at + name.size() + 3));
}

/// The JSON of a list of numbers, the first of that name from a place on.
std::string list_json(const std::string& json, const std::string& name, std::size_t from) {
  const std::size_t start = json.find('"' + name + "\":", from) + name.size() + 3;
  return json.substr(start, json.find(json[start] == '[' ? ']' : '}', start) + 1 - start);
}

/// Its numbers, whatever its form.
std::vector<double> list_of(const std::string& json) {
  std::vector<double> numbers;
  if (json[0] == '[') {
    for (std::size_t at = 1; at + 1 < json.size(); at = json.find_first_of(",]", at) + 1)
      numbers.push_back(json[at] == 'n' ? std::nan("") : std::stod(json.substr(at)));
    return numbers;
  }
  const std::string kind = json.substr(2, 2);
  const std::size_t begin = json.find(":\"") + 2;
  const std::string_view text = std::string_view(json).substr(begin, json.find('"', begin) - begin);
  if (kind == "f8") return unpacked<double>(text, 0.0, 1.0);
  if (kind == "f4") return unpacked<float>(text, 0.0, 1.0);
  if (kind == "f2") return unpacked<Eigen::half>(text, 0.0, number_in(json, "unit", 1.0));
  return unpacked<std::uint32_t>(text, number_in(json, "start", 0.0), number_in(json, "step", 0.0));
}

/// Where the samples of each method begin.
std::vector<std::size_t> places_of_samples(const std::string& json) {
  std::vector<std::size_t> places;
  for (std::size_t at = json.find("\"samples\":{"); at != std::string::npos; at = json.find("\"samples\":{", at + 1))
    places.push_back(at);
  return places;
}

DrawnAsStated drawn_of(const std::string& json, const std::vector<std::size_t>& places, std::size_t method) {
  std::string times = list_json(json, "t", places[method]);
  if (times.starts_with(R"({"like")"))
    times = list_json(json, "t", places[static_cast<std::size_t>(number_in(times, "like", 0.0))]);
  DrawnAsStated drawn{.t = list_of(times),
                      .q = {},
                      .w = {},
                      .is_straight = json.substr(json.find("\"straight\":", places[method]) + 11, 4) == "true"};
  const auto q = list_of(list_json(json, "q", places[method])), w = list_of(list_json(json, "w", places[method]));
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
  io::ReadOptions options;
  options.drop_duplicates = options.drop_invalid = true;
  if (path.find("broad") != std::string::npos)
    options.columns = {{"qw", "opt_qw"}, {"qx", "opt_qx"}, {"qy", "opt_qy"}, {"qz", "opt_qz"}};
  const auto file = io::read_keys(path, options);
  if (!file) return ADD_FAILURE() << describe(file.error()), std::nullopt;
  Recording recording;
  const auto take = [](KeyframeData& to, double t, const Eigen::Quaterniond& q) {
    to.times.push_back(t);
    to.orientations.push_back(q.normalized());
  };
  for (std::size_t i = 0; i < file->data.times.size() && recording.all.times.size() < count; ++i) {
    const double t = file->data.times[i] - file->data.times[0];
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
  const std::string json = json_of(page_of(recording, methods));
  const std::vector<std::size_t> places = places_of_samples(json);
  ASSERT_EQ(places.size(), methods.size());
  const AnyCurve reference = curve_of(methods[0].candidate).value().orientation;
  const DrawnAsStated drawn_reference = drawn_of(json, places, 0);
  std::size_t shown = 0;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (!methods[i].measures) continue;
    ++shown;
    const AnyCurve curve = curve_of(methods[i].candidate).value().orientation;
    const DrawnAsStated drawn = drawn_of(json, places, i);
    EXPECT_LE(drawn.t.size(), 5000u) << methods[i].label;
    const double stated = std::max(
        drawn_within,
        number_in(json.substr(places[i], json.find("\"keys\":", places[i]) - places[i]), "exactness_deg", 0.0));
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
      {"data/imu/broad_06_undisturbed_fast_rotation_A_40s.csv", {3000, 20}}};
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
