// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/clock.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/iso_time.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr char frame_mark = 'f';

Expected<Decimal> time_of_frame(std::string_view text, const Clock& clock) {
  const auto frame = Decimal::parse(text.substr(0, text.size() - 1));
  if (!frame)
    return failure(ErrorCode::bad_data,
                   formatted("found {}, wanted a frame such as 12{}", in_quotes(text), frame_mark));
  if (!clock.frames_per_second)
    return mended_by("fps", formatted("found the frame {}, wanted the frames per second as well", in_quotes(text)));
  return clock.frames_per_second->inverse().time_of(*frame);
}

}  // namespace

Expected<Decimal> time_in(std::string_view text, const Clock& clock) {
  if (looks_like_iso_time(text))
    return parse_iso_time(text).map([&](const Decimal& time) { return time - clock.zero; });
  if (text.ends_with(frame_mark)) return time_of_frame(text, clock);
  if (const auto seconds = Fraction::parse(text)) return seconds->time_of(Decimal::power_of_ten(0));
  return failure(ErrorCode::bad_data,
                 formatted("found {}, wanted a number of seconds, a fraction such as 1/24, a frame "
                           "such as 12{}, or a time such as 2024-02-29T12:30:00Z",
                           in_quotes(text), frame_mark));
}

}}}  // namespace orispline::io
