// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <orispline/base/decimal.hpp>
#include <orispline/base/expected.hpp>

// What is wrong with the order of rows, of keys and of rates, with the option that mends it.

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Of the time of a row that is the time of an earlier one, too.
[[nodiscard]] std::string duplicate_time(std::string_view time, std::size_t earlier_line);
/// Of a time that comes after a later one; `begins`: a recording begins there.
[[nodiscard]] tl::unexpected<Error> falling_time(std::string_view time, const Decimal& before, bool begins,
                                                 Where where);
/// Of a recording that is asked for in a file which has so many others.
[[nodiscard]] tl::unexpected<Error> no_such_session(std::size_t session, std::size_t count);
/// Of so many recordings that sorting would mix; where the second one begins.
[[nodiscard]] tl::unexpected<Error> mixed_sessions(std::size_t count, Where second);

}}}  // namespace orispline::io
