// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/order_errors.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

std::string duplicate_time(std::string_view time, std::size_t earlier_line) {
  return formatted("duplicate time {}, as in line {}, wanted increasing times", time, earlier_line);
}

tl::unexpected<Error> falling_time(std::string_view time, const Decimal& before, bool begins, Where where) {
  const std::string later = formatted("time {} comes after {}", time, before.to_string());
  if (!begins) return mended_by("sort", later + ", wanted increasing times", std::move(where));
  return mended_by("session",
                   later +
                       ", and the rows go on from there: a second recording begins, wanted one, or "
                       "`unwrap` if the clock came round",
                   std::move(where));
}

tl::unexpected<Error> no_such_session(std::size_t session, std::size_t count) {
  return bad_option("session",
                    formatted("found {}, wanted {}{}", session == all_sessions ? "all" : std::to_string(session),
                              count == 1 ? "1" : formatted("1 to {}", count),
                              count == 1 ? ": the file has one recording" : ", which the file has"));
}

tl::unexpected<Error> mixed_sessions(std::size_t count, Where second) {
  return mended_by("session",
                   formatted("found {} recordings one behind the other, the second from here on, which sorting would "
                             "mix; wanted one of them, or `unwrap` if the clock came round",
                             count),
                   std::move(second));
}

}}}  // namespace orispline::io
