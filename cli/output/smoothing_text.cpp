// SPDX-License-Identifier: Apache-2.0
#include "output/smoothing_text.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>

namespace orispline::cli {
namespace {

using orispline::Smoothing;
using orispline::SmoothingCriterion;
using orispline::SmoothingWarning;

constexpr std::size_t places_shown = 10;

std::string reason_of(const Smoothing& smoothing) {
  if (!smoothing.criterion) return "as stated";
  std::string reason = *smoothing.criterion == SmoothingCriterion::gcv    ? "by generalised cross-validation"
                       : *smoothing.criterion == SmoothingCriterion::ubre ? "by the stated noise (UBRE)"
                                                                          : "by restricted likelihood (REML)";
  const std::size_t all = smoothing.keys.size();
  if (smoothing.chosen_on < all) reason += formatted(", on {} of {} samples", smoothing.chosen_on, all);
  return reason;
}

std::string text_of(const SmoothingWarning& warning) {
  switch (warning.code) {
    case SmoothingWarning::Code::least_smoothing:
      return "hardly any noise was found beside the motion: the least smoothing was taken; state --smoothing-time for "
             "more or less";
    case SmoothingWarning::Code::most_smoothing:
      return "no change of the rates was found beside the noise: the most smoothing was taken; state --smoothing-time "
             "to have less";
    case SmoothingWarning::Code::rejected_run:
      return formatted(
          "{} samples in a row do not count, which is rather motion than outliers: wanted --loss robust, "
          "which keeps them",
          warning.count);
    case SmoothingWarning::Code::unfinished:
      break;
  }
  return formatted("the last step of the iteration still moved by {:.2g} rad", warning.step);
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

std::optional<std::string> remark_on(const Smoothing& smoothing) {
  if (smoothing.warnings.empty()) return std::nullopt;
  return text_of(smoothing.warnings.front());
}

}  // namespace orispline::cli
