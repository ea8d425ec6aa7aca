// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/baked_motion.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <ranges>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::string_view magic = "ORIBAKED";

/// Files with positions have a version of their own, so that players that know nothing of them refuse them.
std::uint32_t version_of(const BakedMotion& motion) { return motion.path ? 2 : 1; }

/// Those of the pieces; a single key, which has one piece, is where that starts and ends.
std::vector<double> ends_of(const Knots& knots) {
  const std::span<const double> times = knots.times();
  if (times.size() == 1) return {times.front(), times.front()};
  return {times.begin(), times.end()};
}

/// In the order of the files: those of one component after the other.
std::vector<float> coefficients_of(const batch::BakedRecord<float>& piece) {
  std::vector<float> all;
  for (const auto& component : piece.coefficients) all.insert(all.end(), std::begin(component), std::end(component));
  return all;
}

std::string numbers_of(const batch::BakedRecord<float>& piece) { return joined(coefficients_of(piece), ","); }
std::string numbers_of(const BakedPath::Piece& piece) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < 3; ++k)
    all.push_back(formatted("{},{}", piece.first[k], joined(std::span(piece.others[k]), ",")));
  return joined(all, ",");
}

template <class Baked>
std::string pieces_json(const Baked& baked) {
  std::vector<std::string> pieces;
  for (const auto& piece : baked.pieces()) pieces.push_back(formatted("[{}]", numbers_of(piece)));
  return joined(pieces, ",");
}

/// Little-endian, one number after another.
class Bytes {
 public:
  void append(std::unsigned_integral auto number) {
    for (std::size_t k = 0; k < sizeof(number); ++k) bytes_.push_back(static_cast<char>(number >> (8 * k) & 0xff));
  }
  void append(double number) { append(std::bit_cast<std::uint64_t>(number)); }
  void append(float number) { append(std::bit_cast<std::uint32_t>(number)); }
  void append(std::string_view characters) { bytes_ += characters; }
  template <std::ranges::range Numbers>
  requires(!std::convertible_to<Numbers, std::string_view>) void append(const Numbers& numbers) {
    for (const auto number : numbers) append(number);
  }

  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace

Expected<BakedMotion> bake_motion(const PoseCurve& curve, double tolerance, double position_tolerance,
                                  const Progress& progress) {
  const auto about = [](std::string option) {
    return [option = std::move(option)](Error error) {
      if (error.code == ErrorCode::bad_argument) error.option = option;
      return error;
    };
  };
  auto baked = bake<float>(curve.orientation, tolerance, {}, progress).map_error(about("tolerance"));
  if (!baked) return tl::unexpected(std::move(baked.error()));
  if (!curve.position) return BakedMotion{std::move(*baked)};
  return bake_path(*curve.position, position_tolerance, {}, progress)
      .map_error(about("position_tolerance"))
      .map([&](BakedPath path) {
        return BakedMotion{std::move(*baked), std::move(path)};
      });
}

std::string baked_json(const BakedMotion& motion, const Decimal& epoch) {
  const BakedCurve<float>& curve = motion.curve;
  const std::optional<BakedPath>& path = motion.path;
  const std::string of_path =
      path ? formatted(
                 ",\"largest_position_difference\":{},\"position_ends\":[{}],"
                 "\"position_pieces\":[{}]",
                 path->largest_difference(), joined(ends_of(path->knots()), ","), pieces_json(*path))
           : "";
  return formatted(
      "{{\"orispline\":\"baked\",\"version\":{},\"order\":\"xyzw\",\"epoch\":{},\"largest_difference\":{},"
      "\"ends\":[{}],\"pieces\":[{}]{}}}\n",
      version_of(motion), epoch.to_string(), curve.largest_difference(), joined(ends_of(curve.knots()), ","),
      pieces_json(curve), of_path);
}

std::string baked_bytes(const BakedMotion& motion, const Decimal& epoch) {
  const BakedCurve<float>& curve = motion.curve;
  Bytes bytes;
  bytes.append(magic);
  bytes.append(version_of(motion));
  bytes.append(static_cast<std::uint32_t>(curve.pieces().size()));
  bytes.append(epoch.to_double());
  bytes.append(curve.largest_difference());
  bytes.append(ends_of(curve.knots()));
  for (const auto& piece : curve.pieces()) bytes.append(coefficients_of(piece));
  if (!motion.path) return bytes.take();
  const BakedPath& path = *motion.path;
  bytes.append(static_cast<std::uint32_t>(path.pieces().size()));
  bytes.append(std::uint32_t{0});  // so that what follows lies at a multiple of 8
  bytes.append(path.largest_difference());
  bytes.append(ends_of(path.knots()));
  for (const auto& piece : path.pieces()) bytes.append(std::span(piece.first));
  for (const auto& piece : path.pieces())
    for (const auto& component : piece.others) bytes.append(std::span(component));
  return bytes.take();
}

}}  // namespace orispline
