// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh_text.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_blank(char c) noexcept { return c == ' ' || ('\t' <= c && c <= '\r'); }
bool is_brace(char c) noexcept { return c == '{' || c == '}'; }
char small(char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

}  // namespace

bool is_word(std::string_view word, std::string_view keyword) noexcept {
  return std::ranges::equal(word, keyword, {}, small, small);
}

Text::Text(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(&path) {
  if (bytes_.starts_with(byte_order_mark)) bytes_.remove_prefix(byte_order_mark.size());
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

std::string_view Text::rest_of_line() noexcept {
  const auto ends = [](char c) { return c == '\n' || c == '\r' || is_brace(c); };
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

}}}  // namespace orispline::scenes::bvh
