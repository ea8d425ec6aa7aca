// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Numbers as bytes, the lowest byte first.
class StateWriter {
 public:
  StateWriter() = default;
  /// Goes on behind bytes that are there.
  explicit StateWriter(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}
  void whole(std::uint64_t number);
  void real(double number) { whole(std::bit_cast<std::uint64_t>(number)); }
  void text(std::string_view text);
  void reals(std::span<const double> numbers);
  void vector(const Eigen::Vector3d& v);
  /// The bytes with their checksum behind them.
  [[nodiscard]] std::vector<std::byte> sealed() &&;

 private:
  std::vector<std::byte> bytes_;
};

/// Reads them back: after the first thing that is not there everything is zero or empty, and is_sound() false.
class StateReader {
 public:
  /// Whole bytes are sound when their checksum is theirs.
  explicit StateReader(std::span<const std::byte> bytes) noexcept;

  [[nodiscard]] std::uint64_t whole() noexcept;
  [[nodiscard]] double real() noexcept { return std::bit_cast<double>(whole()); }
  [[nodiscard]] std::string text();
  [[nodiscard]] std::vector<double> reals();
  [[nodiscard]] Eigen::Vector3d vector() noexcept;
  /// How many things follow of which each takes 8 bytes or more.
  [[nodiscard]] std::size_t count() noexcept;
  /// A number below `end`.
  [[nodiscard]] std::uint64_t below(std::uint64_t end) noexcept;

  [[nodiscard]] bool is_sound() const noexcept { return sound_; }
  /// Sound, and nothing is left.
  [[nodiscard]] bool is_complete() const noexcept { return sound_ && rest_.empty(); }

 private:
  std::span<const std::byte> rest_;
  bool sound_;
};

}}  // namespace orispline
