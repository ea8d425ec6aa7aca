// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <orispline/scenes/gltf_document.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

enum class ComponentType { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

/// Elements that replace those of an accessor.
struct Sparse {
  std::size_t count = 0, indices = 0, values = 0;  ///< `indices` and `values` begin there in the binary
  ComponentType index_type = ComponentType::u32;
};

/// Where the elements of an accessor lie. What one that accessor_of() gives refers to is within the binary.
struct Accessor {
  std::size_t count = 0, components = 1;
  ComponentType type = ComponentType::f32;
  bool is_normalised = false;
  bool is_strided = false;              ///< whether its view states a stride
  std::optional<std::size_t> offset{};  ///< of its first element in the binary; none where all are zero
  std::size_t element_size = 0, stride = 0;
  std::optional<Sparse> sparse{};

  [[nodiscard]] std::size_t extent() const noexcept { return count == 0 ? 0 : stride * (count - 1) + element_size; }
};

/// Checked against its views. Errors (bad_data) name the accessor.
[[nodiscard]] Expected<Accessor> accessor_of(const Document& document, std::size_t index);

/// All components of all elements: integers as they are or, where they are normalised, within [-1, 1].
///
/// Errors (bad_data): the indices of sparse elements do not rise or are too large.
[[nodiscard]] Expected<std::vector<double>> values_of(const Document& document, const Accessor& accessor);

}}}  // namespace orispline::scenes::gltf
