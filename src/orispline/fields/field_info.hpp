// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/interval.hpp>
#include <orispline/fields/quantity.hpp>
#include <orispline/fields/words.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What the value of a field is.
enum class FieldType {
  flag,              ///< bool
  count,             ///< a whole number, std::uint64_t
  number,            ///< double
  word,              ///< of the field's words, std::string
  names,             ///< std::vector<std::string>
  interval,          ///< the lowest and the highest number, std::vector<double>
  vector,            ///< x, y, z, std::vector<double>
  limit,             ///< of a length, double or one number, or of x, y, z, std::vector<double>; or Measured
  symmetric_matrix,  ///< its diagonal and xy, xz, yz, or its diagonal alone, std::vector<double>
  recording,         ///< orientations at times: bindings pass them in their own way
  sample,            ///< the index of a sample of the recording, std::uint64_t
  samples,           ///< several of them, std::vector<std::size_t>
  runs,              ///< of successive samples, std::vector<SampleRun>
};

/// Successive samples: the index of the first one, and their number.
using SampleRun = std::pair<std::size_t, std::size_t>;

/// Numbers in the unit of the library, and the unit that they were stated in; without a name where none was.
struct Measured {
  std::vector<double> numbers{};
  Unit stated_in{"", 1.0};

  [[nodiscard]] friend bool operator==(const Measured&, const Measured&) = default;
};

/// The value of any field; std::monostate where it is absent.
using FieldValue = std::variant<std::monostate, bool, std::uint64_t, double, std::string, std::vector<std::size_t>,
                                std::vector<double>, std::vector<std::string>, std::vector<SampleRun>, Measured>;

/// Finite numbers above 0.
inline constexpr Interval positive{std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()};

/// A member of a struct of options or of results: all that is known of it elsewhere.
///
/// Help, documents, tables and the keywords of other languages are made from lists of them.
struct FieldInfo {
  std::string_view name{};             ///< as a program writes it: `gyro_noise`
  std::string_view sentence{};         ///< for people
  const Quantity* quantity = nullptr;  ///< of numbers, in the unit of the library; null: they have no unit
  Interval range{};                    ///< of a number, as far as it depends on nothing else
  std::string_view example{};          ///< of a number with its unit, where that of the quantity would mislead
  std::string_view absent{};           ///< what holds where nothing is stated, where the value itself does not say it
  std::string_view without{};          ///< of a flag that is set by default: what holds without it, for people
  bool is_required = false;            ///< the caller has to state it
  FieldType type{};
  // What field() finds out by itself, as it does most types:
  std::span<const Word> words{};
  bool is_optional = false;                         ///< it may be absent
  FieldValue (*initial)() = nullptr;                ///< its default
  FieldValue (*get)(const void* object) = nullptr;  ///< of the struct whose field it is
  /// Whether the value is one of that type; if so, it is taken over. Null: the field is computed.
  bool (*set)(void* object, const FieldValue& value) = nullptr;
};

/// The fields of a struct of options or of results. Specialised for each.
template <class T>
[[nodiscard]] ORISPLINE_EXPORT std::span<const FieldInfo> fields_of() noexcept;

/// A field by its name. Precondition: there is one.
[[nodiscard]] ORISPLINE_EXPORT const FieldInfo& field_named(std::span<const FieldInfo> fields, std::string_view name);

/// The name with the unit, as in documents: `noise_rad`.
[[nodiscard]] ORISPLINE_EXPORT std::string name_with_unit(const FieldInfo& field);

/// `flag`, `count`, …
[[nodiscard]] ORISPLINE_EXPORT std::string_view name_of(FieldType type);

/// Whether there is no value: it is absent, or a bound that is infinite.
[[nodiscard]] ORISPLINE_EXPORT bool is_absent(const FieldValue& value) noexcept;

/// For people: `acceleration`, `8`; empty for what is absent and for the false flag.
[[nodiscard]] ORISPLINE_EXPORT std::string text_of(const FieldValue& value);

/// `1e-07 to 0.5 rad`, `more than 0 s`; empty without bounds.
[[nodiscard]] ORISPLINE_EXPORT std::string text_of(Interval range, const Quantity* quantity);

/// Error (bad_argument, with the option): a number out of its range.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_ranges(std::span<const FieldInfo> fields, const void* options);
template <class Options>
[[nodiscard]] Expected<void> check_ranges(const Options& options) {
  return check_ranges(fields_of<Options>(), &options);
}

/// The field of that name. Error (bad_argument): there is none, with the one that is near.
[[nodiscard]] ORISPLINE_EXPORT Expected<const FieldInfo*> find_field(std::span<const FieldInfo> fields,
                                                                     std::string_view name);

/// What a text states for a field: `0.1deg`, `body`, `1,2,2.5`; the flags `true` and `false`. A number whose quantity
/// has units that people type wants one of them. Errors: bad_argument, with the field's name as the option; so for a
/// recording, which is no text.
[[nodiscard]] ORISPLINE_EXPORT Expected<FieldValue> typed_value(const FieldInfo& field, std::string_view text);

/// What a field takes, in words: `a number [rad]`, `body or world`, `a whole number from 1 on`.
[[nodiscard]] ORISPLINE_EXPORT std::string wanted_of(const FieldInfo& field);

}}  // namespace orispline
