// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/document.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// Zeros that no byte of the file stands for are made up to this many.
constexpr std::size_t most_zeros = 65536;

struct Shape {
  std::string_view name;
  std::size_t rows, columns;
};
constexpr std::array<Shape, 7> shapes{
    {{"SCALAR", 1, 1}, {"VEC2", 2, 1}, {"VEC3", 3, 1}, {"VEC4", 4, 1}, {"MAT2", 2, 2}, {"MAT3", 3, 3}, {"MAT4", 4, 4}}};

std::size_t size_of(ComponentType type) {
  switch (type) {
    case ComponentType::i8:
    case ComponentType::u8:
      return 1;
    case ComponentType::i16:
    case ComponentType::u16:
      return 2;
    case ComponentType::u32:
    case ComponentType::f32:
      break;
  }
  return 4;
}

Expected<ComponentType> component_type_of(const Object& object) {
  return object.count("componentType").and_then([&](std::size_t number) -> Expected<ComponentType> {
    if (number >= 5120 && number <= 5126 && number != 5124) return static_cast<ComponentType>(number);
    return object.fault(formatted("found componentType {}, wanted 5120 to 5126 without 5124", number));
  });
}

Expected<Shape> shape_of(const Object& object) {
  return object.text("type").and_then([&](const std::string& name) -> Expected<Shape> {
    const auto found = std::ranges::find(shapes, std::string_view(name), &Shape::name);
    if (found != shapes.end()) return *found;
    return object.fault(
        formatted("found type {}, wanted one of {}", in_quotes(name), "SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4"));
  });
}

struct ViewRange {
  View view{};
  std::size_t offset = 0;  ///< within the view
};

/// The view that an object refers to, and its own offset there.
Expected<ViewRange> range_of(const Document& document, const Object& object) {
  const auto index = object.index("bufferView", document.views.size());
  if (!index) return tl::unexpected(index.error());
  const auto offset = object.count_or("byteOffset", 0);
  if (!offset) return tl::unexpected(offset.error());
  const auto& view = document.views[*index];
  if (!view) return object.fault(formatted("found bufferView {} without data, wanted uncompressed data", *index));
  return ViewRange{*view, *offset};
}

/// Where `extent` bytes of a range begin in the binary.
Expected<std::size_t> start_of(const Object& object, const ViewRange& range, std::size_t extent) {
  if (range.offset + extent > range.view.length)
    return object.fault(formatted("found {} bytes from byte {}, wanted them within the {} of its bufferView", extent,
                                  range.offset, range.view.length));
  return range.view.offset + range.offset;
}

Expected<std::size_t> packed_start(const Document& document, const Object& object, std::size_t extent) {
  return range_of(document, object).and_then([&](const ViewRange& range) { return start_of(object, range, extent); });
}

Expected<Sparse> sparse_of(const Document& document, const Object& object, const Accessor& accessor) {
  const auto count = object.count("count");
  if (!count) return tl::unexpected(count.error());
  if (*count == 0 || *count > accessor.count)
    return object.fault(formatted("found a count of {}, wanted 1 to the {} of the accessor", *count, accessor.count));
  const auto indices = object.object("indices"), values = object.object("values");
  if (!indices) return tl::unexpected(indices.error());
  if (!values) return tl::unexpected(values.error());
  const auto type = component_type_of(*indices);
  if (!type) return tl::unexpected(type.error());
  if (*type != ComponentType::u8 && *type != ComponentType::u16 && *type != ComponentType::u32)
    return indices->fault(formatted("found componentType {}, wanted 5121, 5123 or 5125", static_cast<int>(*type)));
  const auto indices_start = packed_start(document, *indices, *count * size_of(*type));
  if (!indices_start) return tl::unexpected(indices_start.error());
  const auto values_start = packed_start(document, *values, *count * accessor.element_size);
  if (!values_start) return tl::unexpected(values_start.error());
  return Sparse{*count, *indices_start, *values_start, *type};
}

/// What is said of the elements, without where they lie.
Expected<Accessor> elements_of(const Object& object) {
  const auto count = object.count("count");
  if (!count) return tl::unexpected(count.error());
  const auto type = component_type_of(object);
  if (!type) return tl::unexpected(type.error());
  const auto shape = shape_of(object);
  if (!shape) return tl::unexpected(shape.error());
  const auto is_normalised = object.flag("normalized");
  if (!is_normalised) return tl::unexpected(is_normalised.error());
  if (*count == 0) return object.fault("found no elements, wanted one at least");
  const std::size_t column = shape->rows * size_of(*type);
  const std::size_t size = shape->columns == 1 ? column : (column + 3) / 4 * 4 * shape->columns;
  return Accessor{.count = *count,
                  .components = shape->rows * shape->columns,
                  .type = *type,
                  .is_normalised = *is_normalised,
                  .element_size = size,
                  .stride = size};
}

Expected<Accessor> placed(const Document& document, const Object& object, Accessor accessor) {
  if (!object.has("bufferView")) {
    if (accessor.count > most_zeros)
      return object.fault(
          formatted("found {} elements without a bufferView, wanted {} at most", accessor.count, most_zeros));
    return accessor;
  }
  const auto range = range_of(document, object);
  if (!range) return tl::unexpected(range.error());
  accessor.is_strided = range->view.stride != 0;
  if (accessor.is_strided) accessor.stride = range->view.stride;
  if (accessor.stride < accessor.element_size)
    return object.fault(formatted("found elements of {} bytes every {} bytes, wanted them apart", accessor.element_size,
                                  accessor.stride));
  const auto start = start_of(object, *range, accessor.extent());
  if (!start) return tl::unexpected(start.error());
  accessor.offset = *start;
  return accessor;
}

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
  T number{};
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

template <class T>
double integer_at(std::string_view bytes, std::size_t at, bool is_normalised) {
  const auto number = static_cast<double>(number_at<T>(bytes, at));
  return is_normalised ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : number;
}

double component_at(std::string_view bytes, std::size_t at, ComponentType type, bool is_normalised) {
  switch (type) {
    case ComponentType::i8:
      return integer_at<std::int8_t>(bytes, at, is_normalised);
    case ComponentType::u8:
      return integer_at<std::uint8_t>(bytes, at, is_normalised);
    case ComponentType::i16:
      return integer_at<std::int16_t>(bytes, at, is_normalised);
    case ComponentType::u16:
      return integer_at<std::uint16_t>(bytes, at, is_normalised);
    case ComponentType::u32:
      return integer_at<std::uint32_t>(bytes, at, is_normalised);
    case ComponentType::f32:
      break;
  }
  return static_cast<double>(number_at<float>(bytes, at));
}

/// Reads the element at a byte. Padding is of matrices alone, which are not read.
void read_element(std::string_view bytes, std::size_t at, const Accessor& accessor, double* to) {
  for (std::size_t c = 0; c < accessor.components; ++c)
    to[c] = component_at(bytes, at + c * size_of(accessor.type), accessor.type, accessor.is_normalised);
}

Expected<std::vector<double>> with_sparse(std::vector<double> values, std::string_view bytes,
                                          const Accessor& accessor) {
  const Sparse& sparse = *accessor.sparse;
  for (std::size_t i = 0, next = 0; i < sparse.count; ++i) {
    const std::size_t at = sparse.indices + i * size_of(sparse.index_type);
    const auto index = static_cast<std::size_t>(component_at(bytes, at, sparse.index_type, false));
    if (index < next || index >= accessor.count)
      return failure(ErrorCode::bad_data,
                     formatted("found sparse index {}, wanted {} to {}", index, next, accessor.count - 1));
    read_element(bytes, sparse.values + i * accessor.element_size, accessor, &values[index * accessor.components]);
    next = index + 1;
  }
  return values;
}

}  // namespace

Expected<Accessor> accessor_of(const Document& document, std::size_t index) {
  const auto object = document.root().entry("accessors", "accessor", index);
  if (!object) return tl::unexpected(object.error());
  auto accessor = elements_of(*object).and_then([&](const Accessor& read) { return placed(document, *object, read); });
  if (!accessor || !object->has("sparse")) return accessor;
  const auto sparse =
      object->object("sparse").and_then([&](const Object& read) { return sparse_of(document, read, *accessor); });
  if (!sparse) return tl::unexpected(sparse.error());
  accessor->sparse = *sparse;
  return accessor;
}

Expected<std::vector<double>> values_of(const Document& document, const Accessor& accessor) {
  std::vector<double> values(accessor.count * accessor.components);
  if (accessor.offset)
    for (std::size_t i = 0; i < accessor.count; ++i)
      read_element(document.binary, *accessor.offset + i * accessor.stride, accessor, &values[i * accessor.components]);
  if (!accessor.sparse) return values;
  return with_sparse(std::move(values), document.binary, accessor);
}

double first_component(const Document& document, const Accessor& accessor, std::size_t element) {
  return component_at(document.binary, *accessor.offset + element * accessor.stride, accessor.type,
                      accessor.is_normalised);
}

}}}  // namespace orispline::scenes::gltf
