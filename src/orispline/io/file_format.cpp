// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_format.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/io/formats/formats.hpp>

namespace orispline::inline ORISPLINE_ABI::io {
namespace {

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool ends_in(std::string_view path, std::string_view extension) {
  return path.size() > extension.size() &&
         std::equal(extension.rbegin(), extension.rend(), path.rbegin(), [](char a, char b) { return a == lower(b); });
}

/// The list, to which rooms above add theirs.
std::vector<const FormatInfo*>& known_formats() {
  static std::vector<const FormatInfo*> known(all_formats.begin(), all_formats.end());
  return known;
}

std::vector<const FormatInfo*> formats_that(bool (FormatInfo::*are)() const noexcept) {
  std::vector<const FormatInfo*> some;
  std::ranges::copy_if(formats(), std::back_inserter(some),
                       [are](const FormatInfo* format) { return (format->*are)(); });
  return some;
}

}  // namespace

bool FormatInfo::has_extension_of(std::string_view path) const noexcept {
  return std::ranges::any_of(extensions, [path](std::string_view extension) { return ends_in(path, extension); });
}

std::span<const FormatInfo* const> formats() noexcept { return known_formats(); }
void add_formats(std::span<const FormatInfo* const> more) {
  for (const FormatInfo* const format : more)
    if (std::ranges::find(known_formats(), format) == known_formats().end()) known_formats().push_back(format);
}
std::vector<const FormatInfo*> formats_read() { return formats_that(&FormatInfo::is_read); }
std::vector<const FormatInfo*> formats_written() { return formats_that(&FormatInfo::is_written); }

const FormatInfo* format_of_extension(std::string_view path) noexcept {
  const auto found =
      std::ranges::find_if(formats(), [path](const auto* format) { return format->has_extension_of(path); });
  return found == formats().end() ? nullptr : *found;
}

std::string any_of(std::span<const FormatInfo* const> formats) {
  std::vector<std::string_view> titles;
  for (const FormatInfo* const format : formats) titles.push_back(format->title);
  if (titles.size() < 2) return joined(titles, "");
  const std::string_view last = titles.back();
  titles.pop_back();
  return formatted("{} or {}", joined(titles, ", "), last);
}

}  // namespace orispline::inline ORISPLINE_ABI::io
