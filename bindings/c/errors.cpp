// SPDX-License-Identifier: Apache-2.0
#include "errors.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>

#include <orispline/base/version.hpp>

namespace orispline::c {

namespace {

orispline_code code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_argument:
      return ORISPLINE_BAD_ARGUMENT;
    case ErrorCode::not_converged:
      return ORISPLINE_NOT_CONVERGED;
    case ErrorCode::bad_access:
      return ORISPLINE_BAD_ACCESS;
    case ErrorCode::cancelled:
      return ORISPLINE_CANCELLED;
    case ErrorCode::bad_data:
      break;
  }
  return ORISPLINE_BAD_DATA;
}

/// Made while there is memory; it is never freed.
Shell& no_memory() noexcept {
  static ToldError told{ORISPLINE_NO_MEMORY, {.message = "no memory left"}, "no memory left"};
  static Shell shell{Kind::error, &told, nullptr};
  return shell;
}
[[maybe_unused]] const Shell& made_early = no_memory();

std::int64_t number_or_none(const std::optional<std::size_t>& number) {
  return number ? static_cast<std::int64_t>(*number) : -1;
}

template <class Of>
auto field_of(const orispline_error* error, Of of) {
  static const ToldError none;
  const ToldError* const told = body_of(error);
  return of(told ? *told : none);
}

}  // namespace

orispline_code tell(Error error, orispline_error** to) {
  const orispline_code code = code_of(error.code);
  if (!to) return code;
  std::string text = describe(error);
  *to = handle_of<orispline_error>({code, std::move(error), std::move(text)});
  return code;
}

orispline_code tell_no_memory(orispline_error** to) noexcept {
  if (to) *to = reinterpret_cast<orispline_error*>(&no_memory());
  return ORISPLINE_NO_MEMORY;
}

orispline_code tell_fault(std::string_view what, orispline_error** to) noexcept {
#ifdef __cpp_exceptions
  try {
#endif
    ToldError told;
    told.code = ORISPLINE_FAULT;
    told.error.message.append("found a fault of the library, please report it: ").append(what);
    told.text = told.error.message;
    if (to) *to = handle_of<orispline_error>(std::move(told));
    return ORISPLINE_FAULT;
#ifdef __cpp_exceptions
  } catch (const std::bad_alloc&) {
    return tell_no_memory(to);
  }
#endif
}

char* text_of_c(std::string_view text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (!copy) {
#ifdef __cpp_exceptions
    throw std::bad_alloc();
#else
    std::abort();
#endif
  }
  std::copy(text.begin(), text.end(), copy);
  copy[text.size()] = '\0';
  return copy;
}

Expected<std::span<const char* const>> texts_in(const char* const* texts, std::size_t count, std::string_view name) {
  if (count == 0) return std::span<const char* const>();
  if (auto there = check_pointer(texts, name); !there) return tl::unexpected(std::move(there.error()));
  const std::span all(texts, count);
  if (std::ranges::find(all, nullptr) == all.end()) return all;
  return bad_option(name, "found null among them, wanted texts");
}

}  // namespace orispline::c

using namespace orispline::c;

int32_t orispline_abi(void) { return ORISPLINE_C_ABI; }

const char* orispline_version(void) { return orispline::version.data(); }

void orispline_text_free(char* text) { std::free(text); }

orispline_code orispline_error_code(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return told.code; });
}
const char* orispline_error_message(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return told.error.message.c_str(); });
}
const char* orispline_error_text(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return told.text.c_str(); });
}
const char* orispline_error_option(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return told.error.option.c_str(); });
}
const char* orispline_error_remedy(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return told.error.remedy.c_str(); });
}
const char* orispline_error_file(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return told.error.where.file.c_str(); });
}
int64_t orispline_error_line(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return number_or_none(told.error.where.line); });
}
int64_t orispline_error_column(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return number_or_none(told.error.where.column); });
}
int64_t orispline_error_key(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return number_or_none(told.error.where.key); });
}
int64_t orispline_error_time(const orispline_error* error) {
  return field_of(error, [](const ToldError& told) { return number_or_none(told.error.where.time_index); });
}

void orispline_error_free(orispline_error* error) {
  if (error != reinterpret_cast<orispline_error*>(&no_memory())) free_handle(error);
}
