// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/clip_edits.hpp>

#include <orispline/fields/field.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
std::span<const FieldInfo> fields_of<ClipEdits>() noexcept {
  static constexpr std::array fields{
      field<&ClipEdits::from>({.name = "from",
                               .sentence = "Keep the clip from this time on",
                               .quantity = &quantities::time,
                               .absent = "from its start"}),
      field<&ClipEdits::to>({.name = "to",
                             .sentence = "Keep the clip up to this time",
                             .quantity = &quantities::time,
                             .absent = "to its end"}),
      field<&ClipEdits::reverse>({.name = "reverse", .sentence = "Let it go backwards"}),
      field<&ClipEdits::speed>({.name = "speed", .sentence = "Let it go so many times as fast", .range = positive}),
      field<&ClipEdits::blend>({.name = "blend",
                                .sentence = "How long the clip goes over into the appended one",
                                .quantity = &quantities::duration,
                                .range = positive,
                                .example = "0.1s",
                                .absent = "0.2s"}),
      field<&ClipEdits::loop>({.name = "loop", .sentence = "Close it, so that it goes on from its end at its start"}),
      field<&ClipEdits::period_from>(
          {.name = "period_from",
           .sentence = "With a loop: keep the part of at least this length whose ends are most alike",
           .quantity = &quantities::duration,
           .range = positive,
           .example = "0.8s",
           .absent = "the whole clip is closed"}),
      field<&ClipEdits::period_to>(
          {.name = "period_to",
           .sentence = "With a loop: keep the part of at most this length whose ends are most alike",
           .quantity = &quantities::duration,
           .range = positive,
           .example = "1.4s",
           .absent = "the whole clip is closed"}),
      field<&ClipEdits::up>({.name = "up", .sentence = "The axis of the world that points up"}),
      field<&ClipEdits::rate>({.name = "rate",
                               .sentence = "Keys at so many even times per second, and one at the end",
                               .quantity = &quantities::frequency,
                               .range = positive,
                               .absent = "the keys stay"}),
      field<&ClipEdits::shift>({.name = "shift",
                                .sentence = "Let it start at this time",
                                .quantity = &quantities::time,
                                .absent = "its times stay"}),
  };
  return fields;
}

}}  // namespace orispline
