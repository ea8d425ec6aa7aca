// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/baked_file.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr std::string_view magic = "ORIBAKED";
constexpr std::uint32_t baked_version = 1;

/// Those of the pieces; a single key, which has one piece, is where that starts and ends.
std::vector<double> ends_of(const BakedCurve<float>& curve) {
  const std::span<const double> times = curve.knots().times();
  if (times.size() == 1) return {times.front(), times.front()};
  return {times.begin(), times.end()};
}

std::vector<float> coefficients_of(const batch::BakedRecord<float>& piece) {
  std::vector<float> all;
  for (const auto& component : piece.coefficients) all.insert(all.end(), std::begin(component), std::end(component));
  return all;
}

void append_little_endian(std::string& bytes, std::unsigned_integral auto number) {
  for (std::size_t k = 0; k < sizeof(number); ++k) bytes.push_back(static_cast<char>(number >> (8 * k) & 0xff));
}

}  // namespace

std::string baked_json(const BakeOutcome& outcome) {
  const BakedCurve<float>& curve = outcome.curve;
  std::vector<std::string> pieces;
  for (const auto& piece : curve.pieces()) pieces.push_back(formatted("[{}]", joined(coefficients_of(piece), ",")));
  return formatted(
      "{{\"orispline\":\"baked\",\"version\":{},\"order\":\"xyzw\",\"epoch\":{},\"largest_difference\":{},\"ends\":[{}]"
      ","
      "\"pieces\":[{}]}}\n",
      baked_version, outcome.request.keys->epoch.to_string(), curve.largest_difference(), joined(ends_of(curve), ","),
      joined(pieces, ","));
}

std::string baked_bytes(const BakeOutcome& outcome) {
  const BakedCurve<float>& curve = outcome.curve;
  std::string bytes(magic);
  const auto append = [&](double number) { append_little_endian(bytes, std::bit_cast<std::uint64_t>(number)); };
  append_little_endian(bytes, baked_version);
  append_little_endian(bytes, static_cast<std::uint32_t>(curve.pieces().size()));
  append(outcome.request.keys->epoch.to_double());
  append(curve.largest_difference());
  for (const double end : ends_of(curve)) append(end);
  for (const auto& piece : curve.pieces())
    for (const float c : coefficients_of(piece)) append_little_endian(bytes, std::bit_cast<std::uint32_t>(c));
  return bytes;
}

}}}  // namespace orispline::jobs
