// SPDX-License-Identifier: Apache-2.0
#include "options/input_options.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view session_option = "session";

Expected<io::Reading> reading_in(const InputOptions& options) {
  io::Reading reading;
  for (const auto& option : io::reading_options()) {
    const auto typed = options.reading.find(option.name);
    if (typed == options.reading.end()) continue;
    std::vector<std::string> texts = typed->second.each;
    if (typed->second.once) texts.push_back(*typed->second.once);
    for (const std::string& text : texts)
      if (auto taken = option.take(reading, text); !taken) return tl::unexpected(with_flags(std::move(taken.error())));
  }
  return reading;
}

}  // namespace

Expected<const io::FormatInfo*> format_in(OptionText option, std::span<const io::FormatInfo* const> formats) {
  const auto found = std::ranges::find(formats, option.text, &io::FormatInfo::id);
  if (found == formats.end()) return wanted(option, one_of(formats));
  return *found;
}

std::string one_of(std::span<const io::FormatInfo* const> formats) {
  std::vector<std::string_view> ids;
  for (const io::FormatInfo* const format : formats) ids.push_back(format->id);
  return joined(ids, "|");
}

Expected<io::Clock> clock_in(const InputOptions& options) {
  return reading_in(options).map([](const io::Reading& reading) { return reading.options.clock; });
}

/// Of files that are no tables most options have nothing to say.
Expected<void> check_reading(const InputOptions& options, const io::Reading& reading) {
  const io::FormatInfo* const format =
      reading.options.format ? reading.options.format : io::format_of_extension(options.path);
  if (!format || !format->reading.tracks) return {};
  constexpr std::array<std::string_view, 12> fitting{
      "input_format", "clip",       "joint",      "space",     "signs",          "drop_duplicates",
      "salvage",      "rest_frame", "world_axes", "body_axes", "world_rotation", "body_rotation"};
  for (const auto& [name, typed] : options.reading)
    if (typed.are_given() && std::ranges::find(fitting, name) == fitting.end())
      return usage_failure(
          formatted("{}: found {}, which is no table and takes no such option", flag_of(name), format->file));
  return {};
}

Expected<InputRequest> input_request(const InputOptions& options) {
  if (options.path.empty()) return usage_failure("INPUT: found an empty name, wanted FILE or -");
  return reading_in(options).and_then([&](io::Reading reading) {
    return check_reading(options, reading).map([&] {
      return InputRequest{.path = options.path, .read = std::move(reading.options), .signs = reading.signs};
    });
  });
}

bool asks_for_all_sessions(const InputOptions& options) {
  const auto typed = options.reading.find(session_option);
  return typed != options.reading.end() && typed->second.once == "all";
}

Expected<std::size_t> sessions_in(const InputOptions& options) {
  InputOptions one = options;
  choose_session(one, "1");
  return input_request(one).and_then(
      [](const InputRequest& request) { return io::sessions_in(request.path, request.read); });
}

void choose_session(InputOptions& options, const std::string& session) {
  options.reading.find(session_option)->second.once = session;
}

}  // namespace orispline::cli
