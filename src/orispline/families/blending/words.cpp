// SPDX-License-Identifier: Apache-2.0
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/families/blending/blending_family.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Promise = BlendingFinding::Promise;

constexpr std::array<std::string_view, 8> names{"interpolates",
                                                "sums_to_one",
                                                "continuity_uniform",
                                                "continuity_uneven",
                                                "continuity_of_shape",
                                                "keeps_constant_rate_uniform",
                                                "keeps_constant_rate_uneven",
                                                "rests_at_zero"};

/// What is kept, by its order.
std::string kept(const BlendingFinding& found) {
  switch (found.promise) {
    case Promise::interpolates:
      return "It passes through every key";
    case Promise::sums_to_one:
      return "Its blending functions sum to 1";
    case Promise::continuity_even:
      return formatted("It is C{} in time on evenly spaced keys", found.order);
    case Promise::continuity_uneven:
      return formatted("It is C{} in time on uneven keys", found.order);
    case Promise::shape:
      return formatted("Its path is G{} on any keys, whatever the speed", found.order);
    case Promise::steady_even:
      return "A constant rate stays constant on evenly spaced keys";
    case Promise::steady_uneven:
      return "A constant rate stays constant on uneven keys";
    case Promise::rests_at_zero:
      return "";  // as the condition of the shape says
  }
  return "";
}

std::string missed(const BlendingFinding& found) {
  switch (found.promise) {
    case Promise::interpolates:
      return "It does not pass through its keys";
    case Promise::sums_to_one:
      return "Its blending functions do not sum to 1";
    case Promise::continuity_even:
      return "It jumps at evenly spaced keys";
    case Promise::continuity_uneven:
      return "It jumps at uneven keys";
    case Promise::shape:
      return "Its path jumps at keys";
    case Promise::steady_even:
      return "A constant rate does not stay constant on evenly spaced keys";
    case Promise::steady_uneven:
      return "A constant rate does not stay constant on uneven keys";
    case Promise::rests_at_zero:
      return "";
  }
  return "";
}

bool is_continuity(Promise promise) {
  return promise == Promise::continuity_even || promise == Promise::continuity_uneven || promise == Promise::shape;
}

}  // namespace

std::string_view promise_name(BlendingFinding::Promise promise) noexcept {
  return names[static_cast<std::size_t>(promise)];
}

std::string sentence_of(const BlendingFinding& found) {
  const bool is_order = is_continuity(found.promise);
  const bool is_kept = is_order ? found.order >= 0 : found.order > 0;
  std::string text = is_kept ? kept(found) : missed(found);
  if (text.empty()) return text;
  if (found.is_undefined) text = "There is no curve on evenly spaced keys";
  if (is_kept && !found.provided.empty()) text += formatted(", wherever {}", found.provided);
  if (is_kept && !found.provided.empty() && found.promise == Promise::shape)
    text += "; elsewhere the body rests or turns back at the key, and its path may have a corner there";
  if (!found.why.empty())
    text += is_order && is_kept ? formatted("; one order more fails: {}", found.why) : formatted(": {}", found.why);
  if (!found.where.empty()) text += formatted("; it would hold where {}", found.where);
  return text + ".";
}

}}  // namespace orispline
