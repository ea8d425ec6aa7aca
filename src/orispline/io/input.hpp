// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What is read: a file, standard input, or bytes in memory.
class ORISPLINE_EXPORT Input {
 public:
  /// The file at a path; `-` is standard input.
  template <std::convertible_to<std::string> Path>
  Input(Path path) : name_(std::move(path)) {}  // not explicit: a path is an input
  /// Bytes as those of a file of that name, whose extension says what they are. Copies share them.
  ///
  /// `beside`: files in memory that these bytes may refer to by their names, such as the buffers of a glTF file.
  [[nodiscard]] static Input in_memory(std::string name, std::string bytes, std::vector<Input> beside = {});

  /// The path as it was given, or the name of the bytes.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] bool is_in_memory() const noexcept { return memory_ != nullptr; }
  [[nodiscard]] bool is_standard_input() const noexcept;
  /// Of an input in memory.
  [[nodiscard]] std::string_view bytes() const noexcept;
  /// Of an input in memory, by its name; null where there is none.
  [[nodiscard]] const Input* beside(std::string_view name) const noexcept;

 private:
  struct Memory;

  std::string name_;
  std::shared_ptr<const Memory> memory_;  // null: of a file
};

}}}  // namespace orispline::io
