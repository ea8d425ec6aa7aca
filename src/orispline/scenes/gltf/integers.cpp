// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/integers.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

template <class T>
std::optional<std::string> bytes_of(std::span<const float> numbers) {
  constexpr double most = std::numeric_limits<T>::max();
  std::string bytes(numbers.size() * sizeof(T), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double scaled = std::round(static_cast<double>(numbers[i]) * most);
    if (!(std::abs(scaled) <= most) || static_cast<float>(scaled / most) != numbers[i]) return std::nullopt;
    const auto integer = static_cast<T>(scaled);
    std::memcpy(bytes.data() + i * sizeof(T), &integer, sizeof(T));
  }
  return bytes;
}

}  // namespace

std::optional<std::string> bytes_in(ComponentType type, std::span<const float> numbers) {
  if (type == ComponentType::i16) return bytes_of<std::int16_t>(numbers);
  if (type == ComponentType::i8) return bytes_of<std::int8_t>(numbers);
  return std::nullopt;
}

}}}  // namespace orispline::scenes::gltf
