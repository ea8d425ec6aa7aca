// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

using Json = nlohmann::json;

/// A document that is nested deeper is refused: what walks it and what writes it calls itself at each level.
inline constexpr std::size_t deepest_nesting = 512;

/// A document of more values is refused: each takes some 50 bytes of memory, however short it is written.
inline constexpr std::size_t most_values = std::size_t{1} << 24;

/// Whether a text that begins so can be JSON. Errors (bad_data).
[[nodiscard]] Expected<void> check_start_of_json(std::string_view start);
/// A document of any content. Errors (bad_data): text that is not JSON, is nested too deeply, or has too many values.
[[nodiscard]] Expected<Json> parsed(std::string_view text);

/// A value as messages show it: `'text'`, `-1.5`, `a list`.
[[nodiscard]] std::string shown(const Json& value);

/// The error with the place where it was found before its message, and with the key behind that.
[[nodiscard]] Error within(std::string_view place, Error error);

/// An object of a document, with the name that messages call it by. Every getter checks what it finds; their errors are
/// bad_data.
class Object {
 public:
  [[nodiscard]] static Expected<Object> of(const Json& value, std::string name);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const Json* find(const char* key) const;
  [[nodiscard]] bool has(const char* key) const { return find(key) != nullptr; }

  /// A whole number below `size`.
  [[nodiscard]] Expected<std::size_t> index(const char* key, std::size_t size) const;
  /// A whole number of at most `largest_scene_file`, so that products of two do not overflow.
  [[nodiscard]] Expected<std::size_t> count(const char* key) const;
  [[nodiscard]] Expected<std::size_t> count_or(const char* key, std::size_t absent) const;
  [[nodiscard]] Expected<std::string> text(const char* key) const;
  [[nodiscard]] Expected<std::string> text_or(const char* key, std::string absent) const;
  [[nodiscard]] Expected<bool> flag(const char* key) const;  ///< false where absent
  [[nodiscard]] Expected<Object> object(const char* key) const;
  /// A list, empty where absent.
  [[nodiscard]] Expected<const Json*> list(const char* key) const;
  /// Whole numbers below `size`; none where absent.
  [[nodiscard]] Expected<std::vector<std::size_t>> indices(const char* key, std::size_t size) const;
  /// The object at a place of a list of this one: `accessor 3` of `accessors`.
  [[nodiscard]] Expected<Object> entry(const char* key, std::string_view noun, std::size_t index) const;
  template <std::size_t n>
  [[nodiscard]] Expected<std::optional<std::array<double, n>>> numbers(const char* key) const;

  /// A failure that names the object.
  [[nodiscard]] tl::unexpected<Error> fault(std::string_view message) const;

 private:
  Object(const Json& json, std::string name) : json_(&json), name_(std::move(name)) {}

  [[nodiscard]] tl::unexpected<Error> wrong(const char* key, const Json* value, std::string_view wanted) const;
  [[nodiscard]] Expected<const Json*> list_of_numbers(const char* key, std::size_t size) const;

  const Json* json_;
  std::string name_;
};

template <std::size_t n>
Expected<std::optional<std::array<double, n>>> Object::numbers(const char* key) const {
  if (!has(key)) return std::nullopt;
  const auto list = list_of_numbers(key, n);
  if (!list) return tl::unexpected(list.error());
  std::array<double, n> values{};
  for (std::size_t i = 0; i < n; ++i) values[i] = (**list)[i].template get<double>();
  return values;
}

}}}  // namespace orispline::scenes::gltf
