// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <fuzz/fuzzed_keys.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>

namespace orispline::fuzz {

/// Its default, its bounds, zero, or within ±4 of zero in steps of 1/16.
[[nodiscard]] inline double fuzzed_value(FuzzInput& input, const Parameter& parameter) {
  const bool is_whole = parameter.name == "degree" || parameter.name == "order";
  if (is_whole)
    return parameter.lowest +
           static_cast<double>(input.below(static_cast<std::size_t>(parameter.highest - parameter.lowest) + 1));
  const std::uint8_t choice = input.byte();
  if (choice == 0) return parameter.initial;
  if (choice == 1) return parameter.lowest;
  if (choice == 2) return parameter.highest;
  return std::clamp(static_cast<double>(static_cast<std::int8_t>(choice)) / 32.0, parameter.lowest, parameter.highest);
}

[[nodiscard]] inline End fuzzed_end(FuzzInput& input, const FamilyInfo& family) {
  End end;
  if (family.ends.empty()) return end;
  end.rule = family.ends[input.below(family.ends.size())];
  if (end.rule == EndRule::clamped) {
    const double size = std::pow(10.0, static_cast<double>(input.below(7)) - 3.0);
    end.angular_velocity = size * input.vector();
  }
  return end;
}

/// Which of its settings a method is given.
enum class Given { for_all, for_all_or_per_key };

/// A method of the registry with settings for so many keys.
[[nodiscard]] inline Method fuzzed_method(FuzzInput& input, const FamilyInfo& family, const FuzzedKeys& keys,
                                          Given given = Given::for_all_or_per_key) {
  Method method(family.name);
  Flags flags(input);
  const bool parameters = flags.next(), per_key = flags.next() && given == Given::for_all_or_per_key;
  const bool choices = flags.next(), ends = flags.next(), loop = flags.next();
  const std::size_t count = keys.data.times.size();
  if (parameters)
    for (const Parameter& parameter : family.parameters) {
      auto& values = method.options.parameters[std::string(parameter.name)];
      for (std::size_t i = 0; i < (per_key && parameter.per_key ? count : 1); ++i)
        values.push_back(fuzzed_value(input, parameter));
    }
  if (choices)
    for (const Choice& choice : family.choices)
      method.options.choices.emplace(choice.name, choice.words[input.below(choice.words.size())]);
  if (loop && family.closes) {
    const double step = fuzzed_step(input, Steps::moderate);
    method.options.loop = Loop{keys.data.times.back() - keys.data.times.front() + step};
  } else if (ends) {
    method.options.start = fuzzed_end(input, family);
    method.options.end = fuzzed_end(input, family);
  }
  return method;
}

/// What tells a broken claim from others: the method and the keys, as the command takes them.
[[nodiscard]] inline std::string told(const Method& method, const FuzzedKeys& keys) {
  return fmt::format("method {}\nsigns {}\n{}", text_of(method),
                     keys.signs == Signs::shortest ? "shortest" : "as-given", csv_of(keys.data));
}

}  // namespace orispline::fuzz
