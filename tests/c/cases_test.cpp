// SPDX-License-Identifier: Apache-2.0
// cases.json, which bindings of other languages are held to as well, is what this library gives: make_cases.py.
#include <cstring>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "c/handles.hpp"
#include "support/places.hpp"

namespace orispline { namespace {

using namespace testing_support;
using Document = nlohmann::json;

const Document& stated_cases() {
  static const Document read = Document::parse(std::ifstream(in_project("tests/c/cases.json")));
  return read;
}

/// Numbers, of which null is NaN.
std::vector<double> numbers_of(const Document& list) {
  std::vector<double> numbers;
  for (const Document& one : list) numbers.push_back(one.is_null() ? nan : one.get<double>());
  return numbers;
}

struct Made {
  Result result;
  KeysHandle keys;
};

Made made(const Document& stated) {
  const auto times = numbers_of(stated["times"]), orientations = numbers_of(stated["orientations"]);
  std::map<std::string, std::vector<double>> held;
  for (const auto& [name, numbers] : stated["columns"].items()) held[name] = numbers_of(numbers);
  std::vector<orispline_column> columns;
  for (const auto& [name, numbers] : held) columns.push_back(column(name.c_str(), numbers));
  orispline_keys* keys = nullptr;
  Result result = call(orispline_keys_make, times.data(), orientations.data(), times.size(), ORISPLINE_WXYZ,
                       ORISPLINE_SHORTEST, static_cast<const orispline_column*>(columns.data()), columns.size(), &keys);
  return {std::move(result), KeysHandle(keys)};
}

/// Bit for bit, but that a NaN is one.
void expect_same(const std::vector<double>& found, const std::vector<double>& wanted, const std::string& what) {
  ASSERT_EQ(found.size(), wanted.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_TRUE(found[i] == wanted[i] || (found[i] != found[i] && wanted[i] != wanted[i]))
        << what << ", number " << i << ": found " << found[i] << ", wanted " << wanted[i];
}

std::vector<double> motion_of(const orispline_curve* curve, double time, orispline_side side) {
  orispline_motion motion;
  expect_ok(call(orispline_curve_motion, curve, time, side, ORISPLINE_WXYZ, &motion));
  std::vector<double> numbers(25);
  std::memcpy(numbers.data(), &motion, sizeof motion);
  return numbers;
}

/// All quantities, asked for at once, by their names in the order of the header.
std::map<std::string, std::vector<double>> samples_of(const orispline_curve* curve, const std::vector<double>& times) {
  const std::array names{"orientation",
                         "angular_velocity",
                         "angular_acceleration",
                         "angular_jerk",
                         "angular_velocity_world",
                         "angular_acceleration_world",
                         "angular_jerk_world",
                         "position",
                         "velocity",
                         "acceleration"};
  std::map<std::string, std::vector<double>> samples;
  std::vector<orispline_output> outputs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto& numbers = samples[names[i]];
    numbers.resize((i == 0 ? 4 : 3) * times.size());
    outputs.push_back({static_cast<orispline_quantity>(i), ORISPLINE_DOUBLE, numbers.data(), 0});
  }
  expect_ok(call(orispline_sample_at, curve, times.data(), times.size(), ORISPLINE_WXYZ,
                 static_cast<const char*>(nullptr), 1u, static_cast<const orispline_output*>(outputs.data()),
                 outputs.size()));
  return samples;
}

TEST(CasesOfC, AreWhatCurvesGive) {
  const Made keys = made(stated_cases()["keys"]);
  expect_ok(keys.result);
  const auto times = numbers_of(stated_cases()["times"]);
  ASSERT_GT(stated_cases()["curves"].size(), 30u);
  for (const Document& wanted : stated_cases()["curves"]) {
    const std::string method = wanted["method"];
    const CurveHandle owned = curve_through(keys.keys, method.c_str());
    const orispline_curve* const curve = owned.get();
    for (std::size_t i = 0; i < times.size(); ++i)
      expect_same(motion_of(curve, times[i], ORISPLINE_RIGHT), numbers_of(wanted["motions"][i]), method);
    expect_same(motion_of(curve, times[0], ORISPLINE_LEFT), numbers_of(wanted["left"]), method);
    for (const auto& [name, numbers] : samples_of(curve, times))
      expect_same(numbers, numbers_of(wanted["samples"][name]), method + ", " + name);
  }
}

TEST(CasesOfC, AreWhatIsRefused) {
  const KeysHandle keys = made(stated_cases()["keys"]).keys;
  for (const Document& one : stated_cases()["faults"]) {
    orispline_curve* curve = nullptr;
    const Result result = one.contains("keys")
                              ? made(one["keys"]).result
                              : call(orispline_curve_make, static_cast<const orispline_keys*>(keys.get()),
                                     one["method"].get_ref<const std::string&>().c_str(), &curve);
    EXPECT_EQ(result.code, one["error"]["code"]) << one;
    EXPECT_EQ(orispline_error_key(result.error.get()), one["error"]["key"]) << one;
    EXPECT_EQ(result.message(), one["error"]["message"].get<std::string>());
    EXPECT_EQ(result.option(), one["error"]["option"].get<std::string>());
    EXPECT_EQ(orispline_error_remedy(result.error.get()), one["error"]["remedy"]);
  }
}

}}  // namespace orispline
