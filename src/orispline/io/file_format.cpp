// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_format.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/expect.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

/// The list, to which rooms above add theirs. It allocates nothing, for reading may have to fail in want of memory.
class KnownFormats {
 public:
  constexpr KnownFormats() { std::ranges::copy(all_formats, formats_.begin()); }

  void add(const FormatInfo* format) {
    if (std::ranges::find(list(), format) != list().end()) return;
    ORISPLINE_EXPECT(count_ < formats_.size());
    formats_[count_++] = format;
  }
  [[nodiscard]] std::span<const FormatInfo* const> list() const noexcept { return {formats_.data(), count_}; }

 private:
  std::array<const FormatInfo*, 32> formats_{};
  std::size_t count_ = all_formats.size();
};

constinit KnownFormats known_formats;

std::vector<const FormatInfo*> formats_that(bool (FormatInfo::*are)() const noexcept) {
  std::vector<const FormatInfo*> some;
  std::ranges::copy_if(formats(), std::back_inserter(some),
                       [are](const FormatInfo* format) { return (format->*are)(); });
  return some;
}

}  // namespace

bool FormatInfo::has_extension_of(std::string_view path) const noexcept {
  return std::ranges::any_of(extensions, [path](std::string_view extension) { return has_extension(path, extension); });
}

std::span<const FormatInfo* const> formats() noexcept { return known_formats.list(); }
void add_formats(std::span<const FormatInfo* const> more) {
  for (const FormatInfo* const format : more) known_formats.add(format);
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

}}}  // namespace orispline::io
