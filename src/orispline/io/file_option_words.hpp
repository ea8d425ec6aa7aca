// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/suggestion.hpp>
#include <orispline/io/file_option.hpp>

// What is stated of options of files, understood.

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

template <class T>
using OptionWord = std::pair<std::string_view, T>;

inline constexpr std::array representation_words{OptionWord<Representation>{"quaternion", Representation::quaternion},
                                                 OptionWord<Representation>{"euler", Representation::euler},
                                                 OptionWord<Representation>{"matrix", Representation::matrix},
                                                 OptionWord<Representation>{"rotvec", Representation::rotation_vector}};
inline constexpr std::array order_words{OptionWord<QuaternionOrder>{"wxyz", QuaternionOrder::wxyz},
                                        OptionWord<QuaternionOrder>{"xyzw", QuaternionOrder::xyzw}};
inline constexpr std::array sign_words{OptionWord<Signs>{"shortest", Signs::shortest},
                                       OptionWord<Signs>{"as-given", Signs::as_given}};
inline constexpr std::array space_words{OptionWord<SceneTrack::Space>{"local", SceneTrack::Space::local},
                                        OptionWord<SceneTrack::Space>{"world", SceneTrack::Space::world}};
inline constexpr auto angle_unit_words = [] {
  std::array<OptionWord<AngleUnit>, angle_units.size()> words;
  std::ranges::transform(angle_units, words.begin(), [](const auto& info) {
    return OptionWord<AngleUnit>{info.word, info.unit};
  });
  return words;
}();

[[nodiscard]] inline tl::unexpected<Error> not_wanted(std::string_view option, std::string_view text,
                                                      std::string_view wanted) {
  return bad_option(option, formatted("found '{}', wanted {}", text, wanted));
}

/// `csv|tum`
[[nodiscard]] inline std::string list_of(std::span<const FormatInfo* const> formats) {
  std::vector<std::string_view> ids;
  for (const FormatInfo* const format : formats) ids.push_back(format->id);
  return joined(ids, "|");
}

template <const auto& Words>
[[nodiscard]] std::string list_of() {
  std::vector<std::string_view> list;
  for (const auto& [word, value] : Words) list.push_back(word);
  return joined(list, "|");
}

template <const auto& Words>
[[nodiscard]] auto word_in(std::string_view option, std::string_view text) -> Expected<decltype(Words.front().second)> {
  const auto found = std::ranges::find_if(Words, [&](const auto& word) { return word.first == text; });
  if (found == Words.end()) return not_wanted(option, text, list_of<Words>());
  return found->second;
}

[[nodiscard]] inline Expected<const FormatInfo*> format_in(std::string_view option, std::string_view text,
                                                           std::span<const FormatInfo* const> formats) {
  const auto found = std::ranges::find(formats, text, &FormatInfo::id);
  if (found == formats.end()) return not_wanted(option, text, list_of(formats));
  return *found;
}

[[nodiscard]] inline Expected<EulerOrder> euler_in(std::string_view option, std::string_view text) {
  if (const auto order = euler_order_of(text)) return *order;
  return not_wanted(option, text,
                    "three axes such as ZYX (those of the body) or zyx (of the world), none twice in a row");
}

/// Takes a value over, unless there is none.
[[nodiscard]] inline auto into(auto& target) {
  return [&target](auto value) { target = std::move(value); };
}

/// Takes over what is stated of these options.
template <class Target>
[[nodiscard]] Expected<void> take_all(Target& target, std::span<const FileOption<Target>> options,
                                      const StatedOptions& stated) {
  for (const auto& [name, text] : stated) {
    const FileOption<Target>* const option = option_named(options, name);
    if (!option) {
      std::vector<std::string_view> names;
      for (const FileOption<Target>& known : options) names.push_back(known.name);
      return failure(ErrorCode::bad_argument, unknown_word("option", name, names));
    }
    if (auto taken = option->take(target, text); !taken) return taken;
  }
  return {};
}

}}}  // namespace orispline::io
