// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace orispline::testing_support {

/// FNV-1a over the bits of numbers.
class BitsHash {
 public:
  void add(std::span<const double> values) {
    for (const double value : values) add_bits(__builtin_bit_cast(std::uint64_t, value), 8);
  }
  void add(std::span<const float> values) {
    for (const float value : values) add_bits(__builtin_bit_cast(std::uint32_t, value), 4);
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  void add_bits(std::uint64_t bits, int bytes) {
    for (int k = 0; k < bytes; ++k) state_ = (state_ ^ ((bits >> (8 * k)) & 0xffU)) * 0x100000001b3U;
  }
  std::uint64_t state_ = 0xcbf29ce484222325U;
};

}  // namespace orispline::testing_support
