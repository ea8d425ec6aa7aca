// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <orispline/math/eigen.hpp>

namespace orispline::fuzz {

/// Takes the bytes of a fuzzer apart from front to back. Bytes that are not there are zeros, so that every input means
/// something and a shorter one means something simpler.
class FuzzInput {
 public:
  FuzzInput(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  [[nodiscard]] std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  /// A number below `count`, which is at most 256.
  [[nodiscard]] std::size_t below(std::size_t count) { return byte() % count; }
  /// -1 … 1 in steps of 1/127; 0 for the byte 0.
  [[nodiscard]] double signed_unit() {
    const int value = (byte() ^ 0x80) - 0x80;  // the two's complement
    return value < -127 ? -1.0 : value / 127.0;
  }
  /// Numbers from -1 to 1.
  [[nodiscard]] Eigen::Vector3d vector() {
    const double x = signed_unit(), y = signed_unit(), z = signed_unit();
    return {x, y, z};
  }
  /// The next bytes as an input of their own.
  [[nodiscard]] FuzzInput part(std::size_t size) {
    const auto first = bytes_.first(std::min(size, bytes_.size()));
    bytes_ = bytes_.subspan(first.size());
    return {first.data(), first.size()};
  }
  /// All that is left.
  [[nodiscard]] std::string_view rest() {
    const std::string_view text(reinterpret_cast<const char*>(bytes_.data()), bytes_.size());
    bytes_ = {};
    return text;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// Several yes or no of one byte, from the lowest bit on.
class Flags {
 public:
  explicit Flags(FuzzInput& input) : bits_(input.byte()) {}
  [[nodiscard]] bool next() { return next(2) == 1; }
  /// One of `count`, a power of two.
  [[nodiscard]] unsigned next(unsigned count) {
    const unsigned value = bits_ % count;
    bits_ /= count;
    return value;
  }

 private:
  unsigned bits_;
};

}  // namespace orispline::fuzz
