// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include <orispline/fields/field_info.hpp>

// How a member becomes a FieldInfo. For the sources that state fields; who reads them needs field_info.hpp alone.

namespace orispline { inline namespace ORISPLINE_ABI {

/// How values of a type are those of fields: `type`, `value` and `assign`, which is false for a value of another type.
template <class T>
struct FieldCodec;

/// Of a type that is kept as another one.
template <class T, class Kept, FieldType Type>
struct PlainCodec {
  static constexpr FieldType type = Type;
  static FieldValue value(const T& member) { return static_cast<Kept>(member); }
  static bool assign(T& member, const FieldValue& value) {
    const Kept* kept = std::get_if<Kept>(&value);
    if (kept) member = static_cast<T>(*kept);
    return kept;
  }
};
template <>
struct FieldCodec<bool> : PlainCodec<bool, bool, FieldType::flag> {};
template <>
struct FieldCodec<double> : PlainCodec<double, double, FieldType::number> {};
/// Of any whole number, whichever of them std::size_t and std::uint64_t are. One that the member cannot hold is none of
/// its type.
template <std::integral T>
struct FieldCodec<T> {
  static constexpr FieldType type = FieldType::count;
  static FieldValue value(T member) { return static_cast<std::uint64_t>(member); }
  static bool assign(T& member, const FieldValue& value) {
    const std::uint64_t* count = std::get_if<std::uint64_t>(&value);
    const bool fits = count && std::in_range<T>(*count);
    if (fits) member = static_cast<T>(*count);
    return fits;
  }
};
template <class T>
struct FieldCodec<std::vector<T>> : PlainCodec<std::vector<T>, std::vector<T>,
                                               std::is_same_v<T, std::size_t> ? FieldType::samples : FieldType::names> {
};

template <class E>
requires std::is_enum_v<E>
struct FieldCodec<E> {
  static constexpr FieldType type = FieldType::word;
  static FieldValue value(E member) { return std::string(word_of(member)); }
  static bool assign(E& member, const FieldValue& value) {
    const std::string* text = std::get_if<std::string>(&value);
    const std::span<const Word> vocabulary = words<E>;
    const auto found = std::ranges::find_if(vocabulary, [&](const Word& w) { return text && w.word == *text; });
    if (found != vocabulary.end()) member = static_cast<E>(found->value);
    return found != vocabulary.end();
  }
};

template <class T>
struct FieldCodec<std::optional<T>> {
  static constexpr FieldType type = FieldCodec<T>::type;
  static FieldValue value(const std::optional<T>& member) {
    return member ? FieldCodec<T>::value(*member) : FieldValue();
  }
  static bool assign(std::optional<T>& member, const FieldValue& value) {
    if (std::holds_alternative<std::monostate>(value)) return member.reset(), true;
    T there{};
    const bool fits = FieldCodec<T>::assign(there, value);
    if (fits) member = std::move(there);
    return fits;
  }
};

/// Where a path of pointers to members leads: `at_path<&RetimeOptions::limits, &MotionLimits::rate>(options)`.
template <auto First, auto... Rest>
[[nodiscard]] constexpr decltype(auto) at_path(auto&& object) {
  if constexpr (sizeof...(Rest) == 0) return std::invoke(First, std::forward<decltype(object)>(object));
  else return at_path<Rest...>(std::invoke(First, std::forward<decltype(object)>(object)));
}

template <class T, class Member>
T object_of(Member T::*);  // its type, for decltype
template <class T, class Value>
T object_of(Value (*)(const T&));

template <class T>
struct WordsOf {
  static constexpr std::span<const Word> list{};
};
template <class E>
requires std::is_enum_v<E>
struct WordsOf<E> {
  static constexpr std::span<const Word> list = words<E>;
};
template <class T>
struct WordsOf<std::optional<T>> : WordsOf<T> {
  static constexpr bool is_optional = true;
};

/// The field at a path of pointers to members, the last of which may be one to a function of the object there; with
/// what the path does not say. A count may be stated to be the index of a sample.
template <auto First, auto... Rest>
[[nodiscard]] constexpr FieldInfo field(FieldInfo stated) {
  using Object = decltype(object_of(First));
  using Value = std::remove_cvref_t<decltype(at_path<First, Rest...>(std::declval<Object&>()))>;
  if (stated.type != FieldType::sample) stated.type = FieldCodec<Value>::type;
  stated.words = WordsOf<Value>::list;
  stated.is_optional = requires { WordsOf<Value>::is_optional; };
  stated.get = [](const void* object) {
    return FieldCodec<Value>::value(at_path<First, Rest...>(*static_cast<const Object*>(object)));
  };
  if constexpr (requires(Object & object) {
                  FieldCodec<Value>::assign(at_path<First, Rest...>(object), FieldValue());
                }) {
    stated.set = [](void* object, const FieldValue& value) {
      return FieldCodec<Value>::assign(at_path<First, Rest...>(*static_cast<Object*>(object)), value);
    };
    stated.initial = [] { return FieldCodec<Value>::value(at_path<First, Rest...>(Object{})); };
  }
  return stated;
}

}}  // namespace orispline
