// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>
#include <orispline/fields/words.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How the keys of a glTF file are compressed.
enum class KeyCompression {
  none,
  meshopt  ///< by EXT_meshopt_compression
};

/// Whether this build has meshoptimizer, which reads and writes what is compressed by it.
[[nodiscard]] ORISPLINE_EXPORT bool has_meshopt() noexcept;
/// What a build without it says, with what helps.
[[nodiscard]] ORISPLINE_EXPORT std::string without_meshopt();

/// Of its word. Errors (bad_argument): another one.
[[nodiscard]] ORISPLINE_EXPORT Expected<KeyCompression> key_compression_in(std::string_view text);

/// Errors (bad_argument): a compression that this build does not have.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(KeyCompression compression);

template <>
inline constexpr std::array words<KeyCompression>{
    word("none", KeyCompression::none, "The numbers are floats"),
    word("meshopt", KeyCompression::meshopt,
         "By the extension EXT_meshopt_compression, with values rounded within the tolerances")};

}}  // namespace orispline
