// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/io/file_option_words.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

inline constexpr const auto& orientation_choices = io::representation_words;
inline constexpr const auto& angle_unit_choices = io::angle_unit_words;
inline constexpr const auto& sign_choices = io::sign_words;

/// What is typed behind an option, once or each time.
struct TypedTexts {
  std::optional<std::string> once;
  std::vector<std::string> each;

  [[nodiscard]] bool are_given() const noexcept { return once || !each.empty(); }
};

/// How the user wants a file of keyframes to be read, as typed.
struct InputOptions {
  std::string path;
  std::map<std::string_view, TypedTexts, std::less<>> reading;  ///< by the names of io::reading_options()
};

/// The input, and how it is to be read, understood.
struct InputRequest {
  std::string path;
  io::ReadOptions read;
  std::optional<Signs> signs{};  ///< absent: as the file says, else for the shortest way
};

/// What frames and times of ISO 8601 are counted by.
[[nodiscard]] Expected<io::Clock> clock_in(const InputOptions& options);

[[nodiscard]] Expected<InputRequest> input_request(const InputOptions& options);

/// Whether each recording of a file is to be an input of its own.
[[nodiscard]] bool asks_for_all_sessions(const InputOptions& options);
/// How many there are.
[[nodiscard]] Expected<std::size_t> sessions_in(const InputOptions& options);
void choose_session(InputOptions& options, const std::string& session);

/// The one of these formats that is named.
[[nodiscard]] Expected<const io::FormatInfo*> format_in(OptionText option,
                                                        std::span<const io::FormatInfo* const> formats);
/// The names that they are chosen by: `csv|tum`.
[[nodiscard]] std::string one_of(std::span<const io::FormatInfo* const> formats);

}  // namespace orispline::cli
