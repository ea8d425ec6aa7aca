// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/state_bytes.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t word_bytes = 8;

/// FNV-1a of 64 bits.
std::uint64_t checksum_of(std::span<const std::byte> bytes) noexcept {
  std::uint64_t sum = 0xcbf29ce484222325u;
  for (const std::byte b : bytes) sum = (sum ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3u;
  return sum;
}

std::uint64_t word_of(std::span<const std::byte> bytes) noexcept {
  std::uint64_t number = 0;
  for (std::size_t i = word_bytes; i-- > 0;) number = number << 8U | std::to_integer<std::uint64_t>(bytes[i]);
  return number;
}

}  // namespace

void StateWriter::whole(std::uint64_t number) {
  for (std::size_t i = 0; i < word_bytes; ++i) bytes_.push_back(static_cast<std::byte>(number >> 8U * i & 0xffU));
}

void StateWriter::text(std::string_view text) {
  whole(text.size());
  for (const char c : text) bytes_.push_back(static_cast<std::byte>(c));
}

void StateWriter::reals(std::span<const double> numbers) {
  whole(numbers.size());
  for (const double number : numbers) real(number);
}

void StateWriter::vector(const Eigen::Vector3d& v) {
  for (const double component : v) real(component);
}

std::vector<std::byte> StateWriter::sealed() && {
  whole(checksum_of(bytes_));
  return std::move(bytes_);
}

StateReader::StateReader(std::span<const std::byte> bytes) noexcept : rest_(bytes), sound_(bytes.size() >= word_bytes) {
  if (!sound_) return;
  rest_ = bytes.first(bytes.size() - word_bytes);
  sound_ = checksum_of(rest_) == word_of(bytes.last(word_bytes));
}

std::uint64_t StateReader::whole() noexcept {
  sound_ = sound_ && rest_.size() >= word_bytes;
  if (!sound_) return 0;
  const std::uint64_t number = word_of(rest_);
  rest_ = rest_.subspan(word_bytes);
  return number;
}

std::size_t StateReader::count() noexcept { return static_cast<std::size_t>(below(rest_.size() / word_bytes + 1)); }

std::uint64_t StateReader::below(std::uint64_t end) noexcept {
  const std::uint64_t number = whole();
  sound_ = sound_ && number < end;
  return sound_ ? number : 0;
}

std::string StateReader::text() {
  const auto size = static_cast<std::size_t>(below(rest_.size() + 1));
  sound_ = sound_ && size <= rest_.size();
  std::string text;
  for (std::size_t i = 0; sound_ && i < size; ++i) text.push_back(static_cast<char>(rest_[i]));
  rest_ = rest_.subspan(text.size());
  return text;
}

std::vector<double> StateReader::reals() {
  std::vector<double> numbers(count());
  for (double& number : numbers) number = real();
  return numbers;
}

Eigen::Vector3d StateReader::vector() noexcept {
  const double x = real(), y = real(), z = real();
  return {x, y, z};
}

}}  // namespace orispline
