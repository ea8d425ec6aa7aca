// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// Whether a word is a keyword, in any case of letters.
[[nodiscard]] bool is_word(std::string_view word, std::string_view keyword) noexcept;

/// The words of a BVH file, one after the other. Line ends are blanks but for names and for frames.
class Text {
 public:
  /// Neither the bytes nor the path are copied. A UTF-8 byte order mark is skipped, and a Ctrl-Z at the end is
  /// the end.
  Text(std::string_view bytes, const std::string& path);

  /// The next word, a brace being one of its own; empty at the end.
  [[nodiscard]] std::string_view next() noexcept;
  /// That which next() will give.
  [[nodiscard]] std::string_view peek() const noexcept { return Text(*this).next(); }
  /// What is left of the line up to a brace, without the blanks around it.
  [[nodiscard]] std::string_view rest_of_line() noexcept;
  /// Whether the next word is in the line of the last one.
  [[nodiscard]] bool goes_on_in_line() const noexcept;
  /// Skips `Frame Time :` where it comes next, with or without its blanks and its colon.
  [[nodiscard]] Expected<void> label(std::string_view first, std::string_view second = {});

  /// The bytes before the word that next() gave last.
  [[nodiscard]] std::string_view before() const noexcept { return bytes_.substr(0, begin_); }
  /// That are not read yet.
  [[nodiscard]] std::size_t bytes_left() const noexcept { return bytes_.size() - at_; }
  /// 1-based line of the word that next() gave last.
  [[nodiscard]] std::size_t line() const noexcept { return line_; }

  /// An error at the last word: `found 'BONE', wanted JOINT`.
  [[nodiscard]] tl::unexpected<Error> refused(std::string_view word, std::string_view wanted) const;
  [[nodiscard]] tl::unexpected<Error> fault(std::string message) const;

 private:
  void skip_blanks() noexcept;
  bool take(std::string_view word) noexcept;

  std::string_view bytes_;
  const std::string* path_;
  std::size_t at_ = 0, begin_ = 0;
  std::size_t line_ = 1;
};

/// The number that the last word of a text is. Errors (bad_data) name its line: no number, not finite, too large.
[[nodiscard]] Expected<double> number_of_length(const Text& text, std::string_view word);
[[nodiscard]] Expected<double> number_of_degrees(const Text& text, std::string_view word);
/// `wanted` is for the message.
[[nodiscard]] Expected<std::size_t> whole_number(const Text& text, std::string_view word, std::string_view wanted);

}}}  // namespace orispline::scenes::bvh
