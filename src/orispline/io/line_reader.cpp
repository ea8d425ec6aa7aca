// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/line_reader.hpp>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <orispline/io/other_kinds.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::size_t chunk = std::size_t{64} << 10;  // [bytes] read at a time
constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

tl::unexpected<Error> no_access(const std::string& path, const std::string& what, int system_error) {
  return failure(ErrorCode::bad_access, what + ": " + std::generic_category().message(system_error), {.file = path});
}

bool begins_as_utf16(std::string_view text) { return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"); }

}  // namespace

void LineReader::Close::operator()(std::FILE* file) const noexcept {
  if (file != stdin) std::fclose(file);
}

Expected<LineReader> LineReader::open(Input input) {
  if (input.is_in_memory()) return LineReader(std::move(input), nullptr);
  if (input.is_standard_input()) return LineReader(std::move(input), stdin);
  errno = 0;
  std::FILE* const file = std::fopen(input.name().c_str(), "rb");
  if (!file) return no_access(input.name(), "cannot open", errno);
  return LineReader(std::move(input), file);
}

Expected<std::optional<std::string_view>> LineReader::next() {
  std::size_t searched = 0;
  for (;;) {
    const std::string_view text = std::string_view(buffer_).substr(begin_);
    const std::size_t end = text.find('\n', searched);
    if (end != std::string_view::npos) return give(text.substr(0, end), end + 1);
    searched = text.size();
    const Expected<bool> more = fill();
    if (!more) return tl::unexpected(more.error());
    if (*more) continue;
    if (searched == 0) return std::nullopt;
    return give(std::string_view(buffer_).substr(begin_), searched);
  }
}

Expected<std::string> LineReader::bytes() && {
  std::string all;
  for (;;) {
    const std::size_t had = all.size();
    all.resize(had + chunk);
    const auto count = read(std::span(all).subspan(had));
    if (!count) return tl::unexpected(count.error());
    all.resize(had + *count);
    bytes_ += *count;
    if (*count == 0) return all;
  }
}

void LineReader::rewind() noexcept {
  begin_ = line_ = 0;
  keeps_ = false;
}

/// Appends the next chunk to the text that was not given out yet; false at the end of the file.
Expected<bool> LineReader::fill() {
  if (buffer_.size() - begin_ > longest_line)
    return failure(ErrorCode::bad_data, "the line is longer than 16 MiB, wanted a text file", {path(), line_ + 1});
  if (!keeps_) buffer_.erase(0, std::exchange(begin_, 0));
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + chunk);
  const auto count = read(std::span(buffer_).subspan(kept));
  if (!count) return tl::unexpected(count.error());
  buffer_.resize(kept + *count);
  bytes_ += *count;
  return *count > 0;
}

/// How many bytes there are for the room; none at the end of the file.
Expected<std::size_t> LineReader::read(std::span<char> room) {
  if (!file_) {
    const std::string_view bytes = input_.bytes().substr(bytes_, room.size());
    std::ranges::copy(bytes, room.begin());
    return bytes.size();
  }
  errno = 0;
  const std::size_t count = std::fread(room.data(), 1, room.size(), file_.get());
  if (count == 0 && std::ferror(file_.get())) return no_access(path(), "cannot read", errno);
  return count;
}

/// Takes `used` bytes from the buffer; gives the line in them once it is found to be text.
Expected<std::optional<std::string_view>> LineReader::give(std::string_view line, std::size_t used) {
  begin_ += used;
  ++line_;
  if (line_ == 1 && begins_as_utf16(line))
    return failure(ErrorCode::bad_data, "the file is UTF-16 text, wanted UTF-8", {path(), line_});
  if (line_ == 1 && line.starts_with(utf8_mark)) line.remove_prefix(utf8_mark.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.find('\0') != std::string_view::npos) {
    if (auto kind = line_ == 1 ? other_kind(line) : std::nullopt)
      return failure(ErrorCode::bad_data, std::move(*kind), {.file = path()});
    return failure(ErrorCode::bad_data, "found a NUL byte, wanted a text file", {path(), line_});
  }
  if (line.find('\r') != std::string_view::npos)
    return failure(ErrorCode::bad_data, "found a carriage return within the line, wanted lines that end in LF or CRLF",
                   {path(), line_});
  return line;
}

}}}  // namespace orispline::io
