// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_lists.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include <orispline/base/abi.hpp>
#include <orispline/base/base64.hpp>
#include <orispline/report/page_numbers.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr std::size_t most_in_array = 16;
constexpr int significant_digits = 7;

enum class Digits { few, all };

void append(std::string& json, double value, Digits digits) {
  if (!std::isfinite(value)) json += "null";
  else if (digits == Digits::all) fmt::format_to(std::back_inserter(json), "{}", value + 0.0);
  else fmt::format_to(std::back_inserter(json), "{:.{}g}", value, significant_digits);
}

std::string array_json(std::span<const double> values, Digits digits) {
  std::string json = "[";
  for (const double value : values) {
    if (json.size() > 1) json += ',';
    append(json, value, digits);
  }
  return json + ']';
}

/// The bits of all values in base64, of each the lowest byte first.
template <class BitsOf>
std::string packed(std::span<const double> values, BitsOf bits_of) {
  using Bits = std::invoke_result_t<BitsOf, double>;
  std::string bytes;
  bytes.reserve(values.size() * sizeof(Bits));
  for (const double value : values) {
    const Bits bits = bits_of(value);
    for (std::size_t byte = 0; byte < sizeof(Bits); ++byte) bytes += static_cast<char>(bits >> (8 * byte) & 0xFF);
  }
  return base64_of(bytes);
}

/// Each list has one word for what is not finite.
double finite_or_nan(double value) { return std::isfinite(value) ? value : std::nan(""); }

std::vector<double> flat(std::span<const Eigen::Vector3d> vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Eigen::Vector3d& v : vectors) numbers.insert(numbers.end(), v.data(), v.data() + 3);
  return numbers;
}

std::vector<double> flat(std::span<const Eigen::Quaterniond> orientations) {
  std::vector<double> numbers;
  numbers.reserve(4 * orientations.size());
  for (const Eigen::Quaterniond& q : orientations) numbers.insert(numbers.end(), {q.w(), q.x(), q.y(), q.z()});
  return numbers;
}

}  // namespace

std::string number_json(double value) {
  std::string json;
  append(json, value, Digits::few);
  return json;
}

std::string doubles_json(std::span<const double> values) {
  if (values.size() <= most_in_array) return array_json(values, Digits::all);
  return fmt::format(R"({{"f8":"{}"}})",
                     packed(values, [](double v) { return std::bit_cast<std::uint64_t>(finite_or_nan(v)); }));
}

std::string floats_json(std::span<const double> values) {
  if (values.size() <= most_in_array) return array_json(values, Digits::few);
  return fmt::format(R"({{"f4":"{}"}})", packed(values, [](double v) {
                       return std::bit_cast<std::uint32_t>(static_cast<float>(finite_or_nan(v)));
                     }));
}

std::string floats_json(std::span<const Eigen::Vector3d> values) { return floats_json(flat(values)); }
std::string floats_json(std::span<const Eigen::Quaterniond> values) { return floats_json(flat(values)); }

std::string halves_json(std::span<const Eigen::Vector3d> values) { return halves_json(flat(values)); }

std::string halves_json(std::span<const double> values) {
  if (values.size() <= most_in_array) return array_json(values, Digits::few);
  double largest = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const HalfFloats halves = HalfFloats::up_to(largest);
  const auto bits = [&](double v) { return halves.bits(finite_or_nan(v)); };
  return fmt::format(R"({{"f2":"{}","unit":{}}})", packed(values, bits), halves.unit);
}

std::string steps_json(std::span<const double> times) {
  if (times.size() <= most_in_array) return array_json(times, Digits::all);
  const TimeSteps steps = TimeSteps::of(times.front(), times.back());
  if (!std::isfinite(steps.step) || std::ranges::any_of(times, [](double t) { return !std::isfinite(t); }))
    return doubles_json(times);
  return fmt::format(R"({{"u4":"{}","start":{},"step":{}}})", packed(times, [&](double t) { return steps.nearest(t); }),
                     steps.start, steps.step);
}

}}}  // namespace orispline::report
