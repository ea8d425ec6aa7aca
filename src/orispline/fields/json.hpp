// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A JSON value, whose members stay in the order in which they are documented. Each binding writes it in its own way.
class ORISPLINE_EXPORT Json {
 public:
  using Array = std::vector<Json>;
  using Member = std::pair<std::string, Json>;
  using Object = std::vector<Member>;

  Json(std::nullptr_t = nullptr);
  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(const Json& other);
  Json& operator=(Json&& other) noexcept;
  ~Json();

  template <class T>
  requires std::is_arithmetic_v<T> Json(T number) : value_(kept(number)) {}
  template <class T>
  requires std::convertible_to<T, std::string_view> Json(const T& text) : value_(std::string(std::string_view(text))) {}
  /// An array.
  template <std::ranges::input_range List>
  requires(!std::convertible_to<List, std::string_view>) Json(const List& list)
      : value_(Array(list.begin(), list.end())) {}
  /// An object.
  Json(std::initializer_list<Member> members);

  [[nodiscard]] static Json array() { return Array(); }

  void push_back(Json value);
  /// The member of that name, at the end of the object where it is new.
  Json& operator[](std::string_view name);
  /// Takes over the members of another object.
  void update(Json other);

  [[nodiscard]] const auto& value() const noexcept { return value_; }

 private:
  template <class T>
  [[nodiscard]] static auto kept(T number) {
    if constexpr (std::is_same_v<T, bool> || std::is_floating_point_v<T>) return number;
    else if constexpr (std::is_signed_v<T>) return static_cast<std::int64_t>(number);
    else return static_cast<std::uint64_t>(number);
  }

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> value_;
};

}}  // namespace orispline
