// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_columns.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// How a user wants a file of keys to be read.
struct Reading {
  ReadOptions options{};
  std::optional<Signs> signs{};  ///< absent: as the file says, else for the shortest way
};

/// An option of reading or of writing files as people state it: all that bindings know of it.
template <class Target>
struct FileOption {
  std::string_view name;      ///< as a program writes it: `angle_unit`
  std::string_view sentence;  ///< for people, with what holds where it is not stated
  /// What is stated: `deg|rad`. Null: nothing, it is a flag.
  std::string (*argument)() = nullptr;
  /// Takes over what is stated; of a flag, that it is. Error (bad_argument, of this option): it is no such thing.
  Expected<void> (*take)(Target& target, std::string_view text) = nullptr;
  std::string_view member{};  ///< of the struct, by which errors name it; empty: they do not
  std::string_view use{};     ///< what it does about errors that it would mend: `keeps the first`
  bool is_repeated = false;   ///< several texts say more than one
};

/// All options of reading keys, in the order in which they are shown.
[[nodiscard]] ORISPLINE_EXPORT std::span<const FileOption<Reading>> reading_options() noexcept;

/// The option that errors name by a member of ReadOptions; null if there is none.
[[nodiscard]] ORISPLINE_EXPORT const FileOption<Reading>* reading_option_of(std::string_view member) noexcept;

/// All options of writing samples and keys, in the order in which they are shown. The format is the first; where it is
/// not stated it is that of the extension of the file.
[[nodiscard]] ORISPLINE_EXPORT std::span<const FileOption<SampleColumns>> writing_options() noexcept;

/// An option by its name; null if there is none.
template <class Target>
[[nodiscard]] const FileOption<Target>* option_named(std::span<const FileOption<Target>> options,
                                                     std::string_view name) noexcept {
  for (const FileOption<Target>& option : options)
    if (option.name == name) return &option;
  return nullptr;
}

/// What is stated of options: their names, with texts.
using StatedOptions = std::vector<std::pair<std::string, std::string>>;

/// Takes over what is stated. Errors (bad_argument): an option that there is not; those of the options.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> take_options(Reading& reading, const StatedOptions& stated);

/// The format and the form of orientations of a file of that name, by what is stated of writing_options(). Euler angles
/// may be asked for by their order or their unit alone.
///
/// Errors (bad_argument): those of the options; a form that the format does not hold; of `path`, a name that ends as
/// other files do where no format is stated.
[[nodiscard]] ORISPLINE_EXPORT Expected<SampleColumns> columns_of_output(const std::string& path,
                                                                         const StatedOptions& stated);

/// The columns where keys were read from a file of that format: a name such as `keys.txt`, which says nothing of the
/// format, means that one if it holds what is asked for.
[[nodiscard]] ORISPLINE_EXPORT SampleColumns columns_like(const FormatInfo& input, SampleColumns columns,
                                                          const std::string& path, const StatedOptions& stated);

}}}  // namespace orispline::io
