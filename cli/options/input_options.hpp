// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/io/key_file.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

inline constexpr std::array orientation_choices{
    Choice<io::Representation>{"quaternion", io::Representation::quaternion},
    Choice<io::Representation>{"euler", io::Representation::euler},
    Choice<io::Representation>{"matrix", io::Representation::matrix},
    Choice<io::Representation>{"rotvec", io::Representation::rotation_vector}};
inline constexpr auto angle_unit_choices = [] {
  std::array<Choice<io::AngleUnit>, io::angle_units.size()> choices;
  std::ranges::transform(io::angle_units, choices.begin(), [](const auto& unit) {
    return Choice<io::AngleUnit>{unit.word, unit.unit};
  });
  return choices;
}();
inline constexpr std::array order_choices{Choice<io::QuaternionOrder>{"wxyz", io::QuaternionOrder::wxyz},
                                          Choice<io::QuaternionOrder>{"xyzw", io::QuaternionOrder::xyzw}};
inline constexpr std::array sign_choices{Choice<Signs>{"shortest", Signs::shortest},
                                         Choice<Signs>{"as-given", Signs::as_given}};

/// How the user wants a file of keyframes to be read, as typed.
struct InputOptions {
  std::string path;
  std::optional<std::string> format, order, orientation, euler, angle_unit, time_scale, fps, epoch, signs;
  std::vector<std::string> columns;
  bool conjugate = false, drop_duplicates = false, drop_invalid = false, sort = false, ignore_recipe = false,
       normalise = false;
};

/// The same, understood.
struct InputRequest {
  std::string path;
  io::ReadOptions read;
  std::optional<Signs> signs{};  ///< absent: as the file says, else for the shortest way
};

/// What frames and times of ISO 8601 are counted by.
[[nodiscard]] Expected<io::Clock> clock_in(const InputOptions& options);

[[nodiscard]] Expected<InputRequest> input_request(const InputOptions& options);

/// The one of these formats that is named.
[[nodiscard]] Expected<const io::FormatInfo*> format_in(OptionText option,
                                                        std::span<const io::FormatInfo* const> formats);
/// The names that they are chosen by: `csv|tum`.
[[nodiscard]] std::string one_of(std::span<const io::FormatInfo* const> formats);

/// The order of three turns: `ZYX`, `zyx`.
[[nodiscard]] Expected<EulerOrder> euler_order_in(OptionText option);

}  // namespace orispline::cli
