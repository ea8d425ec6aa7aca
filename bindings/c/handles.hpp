// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include <orispline/base/expected.hpp>

#include "orispline.h"

// What a handle of C stands for in C++.

namespace orispline::c {

enum class Kind : std::uint32_t { none, error, keys, curve, baked, outcome, value };

/// What a handle points to. Shells are kept for good and used again, so that a handle that was freed is known for one.
struct Shell {
  Kind kind = Kind::none;
  void* body = nullptr;
  Shell* next = nullptr;  ///< of those that are free
};

/// A shell with that content.
[[nodiscard]] Shell* filled_shell(Kind kind, void* body);
/// Takes the content out, and the shell back; null where it is of another kind.
[[nodiscard]] void* emptied(Shell* shell, Kind kind) noexcept;

/// The content of the handles of a type: `Body`, its `kind`, and the `name` of a parameter of it.
template <class Handle>
struct HandleOf;

template <class Handle>
using BodyOf = typename HandleOf<Handle>::Body;

/// A new handle.
template <class Handle>
[[nodiscard]] Handle* handle_of(BodyOf<Handle> content) {
  auto body = std::make_unique<BodyOf<Handle>>(std::move(content));
  Shell* const shell = filled_shell(HandleOf<Handle>::kind, body.get());
  body.release();
  return reinterpret_cast<Handle*>(shell);
}

/// Null for what is no such handle.
template <class Handle>
[[nodiscard]] const BodyOf<Handle>* body_of(const Handle* handle) noexcept {
  const auto* const shell = reinterpret_cast<const Shell*>(handle);
  if (!shell || shell->kind != HandleOf<Handle>::kind) return nullptr;
  return static_cast<const BodyOf<Handle>*>(shell->body);
}

/// Error (bad_argument): a handle that is null, of another kind, or freed.
[[nodiscard]] tl::unexpected<Error> no_handle(const void* handle, std::string_view name);
template <class Handle>
[[nodiscard]] Expected<const BodyOf<Handle>*> checked(const Handle* handle) {
  if (const auto* const body = body_of(handle)) return body;
  return no_handle(handle, HandleOf<Handle>::name);
}

template <class Handle>
void free_handle(Handle* handle) noexcept {
  void* const body = emptied(reinterpret_cast<Shell*>(handle), HandleOf<Handle>::kind);
  delete static_cast<BodyOf<Handle>*>(body);
}

/// Error (bad_argument): a null pointer. A result that is a pointer becomes null.
[[nodiscard]] Expected<void> check_pointer(const void* pointer, std::string_view name);
template <class T>
[[nodiscard]] Expected<void> cleared(T** result, std::string_view name) {
  if (result) *result = nullptr;
  return check_pointer(result, name);
}

}  // namespace orispline::c
