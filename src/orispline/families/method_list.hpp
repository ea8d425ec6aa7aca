// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The texts of the methods in a list with commas between them: all of it where that is one method, whose settings may
/// have commas, else its pieces. Whether a piece is a method is left to its reader. A name may be one of `own`.
///
/// Error (bad_argument): a piece that can only be the value of a setting.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<std::string>> method_texts_in(
    std::string_view list, std::span<const std::shared_ptr<const OwnFamily>> own = {});

/// What tells these methods from each other: the name, or the text form where another one has the name too.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::string> labels_of(std::span<const Method> methods);

}}  // namespace orispline
