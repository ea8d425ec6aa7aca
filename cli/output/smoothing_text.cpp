// SPDX-License-Identifier: Apache-2.0
#include "output/smoothing_text.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/smooth/smooth_fields.hpp>

namespace orispline::cli {
namespace {

using orispline::Smoothing;
using orispline::SmoothingCriterion;

constexpr std::size_t places_shown = 10;

std::string reason_of(const Smoothing& smoothing) {
  if (!smoothing.criterion) return "as stated";
  const std::span<const Word> criteria = words<SmoothingCriterion>;
  std::string reason = formatted("by {}", criteria[static_cast<std::size_t>(*smoothing.criterion)].sentence);
  const std::size_t all = smoothing.keys.size();
  if (smoothing.chosen_on < all) reason += formatted(", on {} of {} samples", smoothing.chosen_on, all);
  return reason;
}

}  // namespace

std::string places_text(const std::vector<std::size_t>& samples, const std::vector<std::uint32_t>& lines,
                        const std::vector<Decimal>& times) {
  std::string text;
  for (std::size_t i = 0; i < std::min(samples.size(), places_shown); ++i)
    text += formatted("{}line {} ({} s)", i == 0 ? ": " : ", ", lines[samples[i]], times[samples[i]].to_string());
  return text + (samples.size() > places_shown ? ", …" : "");
}

std::string choice_line(const Smoothing& smoothing) {
  return formatted("smoothing time  {:.4g} s (cut-off {:.4g} Hz), {}\n", smoothing.smoothing_time, smoothing.cutoff(),
                   reason_of(smoothing));
}

std::vector<Warning> remark_on(const Smoothing& smoothing, const Track& recording) {
  std::vector<Warning> remarks;
  for (const Warning& warning : smoothing.warnings) remarks.push_back(recording.located(warning));
  return remarks;
}

}  // namespace orispline::cli
