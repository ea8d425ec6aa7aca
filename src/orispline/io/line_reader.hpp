// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>
#include <orispline/io/input.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Streams a text line by line in constant memory.
///
/// Lines end in LF or CRLF, the last one also in nothing; a UTF-8 byte order mark is skipped.
class ORISPLINE_EXPORT LineReader {
 public:
  /// No text of numbers has longer lines; what has is some other kind of file.
  static constexpr std::size_t longest_line = std::size_t{16} << 20;  // [bytes]

  /// Error: bad_access.
  [[nodiscard]] static Expected<LineReader> open(Input input);

  /// The next line without its ending, valid until the next call; nothing at the end of the file.
  ///
  /// Errors: bad_access when reading fails; bad_data for what is no UTF-8 text: NUL bytes, UTF-16, lone carriage
  /// returns, endless lines.
  [[nodiscard]] Expected<std::optional<std::string_view>> next();

  /// All bytes of a reader that gave out nothing yet, whatever they are. Error: bad_access.
  [[nodiscard]] Expected<std::string> bytes() &&;

  /// From the first line on all that is read stays in memory, to be given once more after rewind(), until forget().
  void keep() noexcept { keeps_ = true; }
  void forget() noexcept { keeps_ = false; }
  void rewind() noexcept;

  [[nodiscard]] const Input& input() const noexcept { return input_; }
  [[nodiscard]] const std::string& path() const noexcept { return input_.name(); }
  /// 1-based number of the line that `next` gave last.
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  /// Of the file, which is read ahead.
  [[nodiscard]] std::size_t bytes_read() const noexcept { return bytes_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept;
  };

  LineReader(Input input, std::FILE* file) : input_(std::move(input)), file_(file) {}
  [[nodiscard]] Expected<bool> fill();
  [[nodiscard]] Expected<std::size_t> read(std::span<char> room);
  [[nodiscard]] Expected<std::optional<std::string_view>> give(std::string_view line, std::size_t used);

  Input input_;
  std::unique_ptr<std::FILE, Close> file_;  // null: in memory
  std::string buffer_;
  std::size_t begin_ = 0;  // of the text in the buffer that was not given out yet
  std::size_t line_ = 0, bytes_ = 0;
  bool keeps_ = false;
};

}}}  // namespace orispline::io
