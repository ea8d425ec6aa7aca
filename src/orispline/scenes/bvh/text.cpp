// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh/text.hpp>

#include <charconv>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr char ctrl_z = '\x1A';

bool is_blank(char c) noexcept { return c == ' ' || ('\t' <= c && c <= '\r'); }
bool ends_line(char c) noexcept { return c == '\n' || c == '\r'; }
bool is_brace(char c) noexcept { return c == '{' || c == '}'; }
char small(char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

/// Where the text ends: before Ctrl-Z, with which DOS ended texts, if only blanks and more of it follow.
std::size_t end_of(std::string_view bytes) noexcept {
  std::size_t end = bytes.size();
  for (std::size_t i = end; i-- > 0 && (is_blank(bytes[i]) || bytes[i] == ctrl_z);)
    if (bytes[i] == ctrl_z) end = i;
  return end;
}

constexpr double greatest_length = 1e100;  // so that squares and sums of them are finite
constexpr double greatest_angle = 1e9;     // [°], beyond which little is left of the fraction of a turn

Expected<double> number_below(double limit, const Text& text, std::string_view word) {
  if (word.empty()) return text.refused(word, "a number");
  const Expected<double> number = io::number_of(word);
  if (!number) return text.fault(number.error().message);
  if (!std::isfinite(*number)) return text.refused(word, "a finite number");
  if (std::abs(*number) > limit) return text.refused(word, formatted("a number of at most {:g} in size", limit));
  return *number;
}

}  // namespace

bool is_word(std::string_view word, std::string_view keyword) noexcept {
  return std::ranges::equal(word, keyword, {}, small, small);
}

Text::Text(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(&path) {
  if (bytes_.starts_with(byte_order_mark)) bytes_.remove_prefix(byte_order_mark.size());
  bytes_ = bytes_.substr(0, end_of(bytes_));
}

void Text::skip_blanks() noexcept {
  for (; at_ < bytes_.size() && is_blank(bytes_[at_]); ++at_) {
    const bool is_lone_return = bytes_[at_] == '\r' && !(at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '\n');
    if (bytes_[at_] == '\n' || is_lone_return) ++line_;
  }
}

std::string_view Text::next() noexcept {
  skip_blanks();
  begin_ = at_;
  if (at_ < bytes_.size() && is_brace(bytes_[at_])) return bytes_.substr(at_++, 1);
  while (at_ < bytes_.size() && !is_blank(bytes_[at_]) && !is_brace(bytes_[at_])) ++at_;
  return bytes_.substr(begin_, at_ - begin_);
}

bool Text::goes_on_in_line() const noexcept {
  const auto rest = bytes_.substr(at_);
  const auto next = std::ranges::find_if(rest, [](char c) { return !is_blank(c) || ends_line(c); });
  return next != rest.end() && !ends_line(*next);
}

std::string_view Text::rest_of_line() noexcept {
  const auto ends = [](char c) { return ends_line(c) || is_brace(c); };
  const auto rest = bytes_.substr(at_);
  std::string_view line(rest.begin(), std::ranges::find_if(rest, ends));
  at_ += line.size();
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

bool Text::take(std::string_view word) noexcept {
  if (!is_word(bytes_.substr(at_, word.size()), word)) return false;
  at_ += word.size();
  return true;
}

Expected<void> Text::label(std::string_view first, std::string_view second) {
  skip_blanks();
  const auto before = at_;
  bool found = take(first);
  if (found && !second.empty()) {
    skip_blanks();
    found = take(second);
  }
  if (!found) {
    at_ = before;
    return refused(next(), formatted("{}{}{}:", first, second.empty() ? "" : " ", second));
  }
  skip_blanks();
  take(":");
  return {};
}

tl::unexpected<Error> Text::refused(std::string_view word, std::string_view wanted) const {
  return fault(formatted("found {}, wanted {}", word.empty() ? "the end of the file" : in_quotes(word), wanted));
}

tl::unexpected<Error> Text::fault(std::string message) const {
  return failure(ErrorCode::bad_data, std::move(message), {.file = *path_, .line = line_});
}

Expected<double> number_of_length(const Text& text, std::string_view word) {
  return number_below(greatest_length, text, word);
}

Expected<double> number_of_degrees(const Text& text, std::string_view word) {
  return number_below(greatest_angle, text, word);
}

Expected<std::size_t> whole_number(const Text& text, std::string_view word, std::string_view wanted) {
  std::size_t number = 0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (status != std::errc() || end != word.data() + word.size()) return text.refused(word, wanted);
  return number;
}

}}}  // namespace orispline::scenes::bvh
