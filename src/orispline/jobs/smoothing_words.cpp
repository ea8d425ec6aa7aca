// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/smoothing_words.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr std::size_t samples_shown = 10;

/// `0.1 s (cut-off 1.59 Hz), by …`
std::string choice_text(double smoothing_time, double cutoff, std::optional<SmoothingCriterion> criterion,
                        std::size_t chosen_on, std::size_t all) {
  const std::string text = formatted("{:.4g} s (cut-off {:.4g} Hz), ", smoothing_time, cutoff);
  if (!criterion) return text + "as stated";
  const std::span<const Word> criteria = words<SmoothingCriterion>;
  const std::string reason = formatted("by {}", criteria[static_cast<std::size_t>(*criterion)].sentence);
  return text + reason + (chosen_on < all ? formatted(", on {} of {} samples", chosen_on, all) : "");
}

std::string choice_of_positions(const Smoothing& smoothing) {
  const PositionSmoothing& found = *smoothing.positions;
  if (!found.smoothing_time) return "as they were, for hardly any noise was found beside their motion";
  return "smoothing time " +
         choice_text(*found.smoothing_time, *found.cutoff(), found.criterion, found.chosen_on, smoothing.keys.size());
}

/// `: line 4 (1.2 s), line 9 (…), …`
template <class TimeText>
std::string text_of_places(const std::vector<std::size_t>& samples, std::span<const std::uint32_t> lines,
                           TimeText time_text) {
  std::string text;
  for (std::size_t i = 0; i < std::min(samples.size(), samples_shown); ++i)
    text += formatted("{}{} ({})", i == 0 ? ": " : ", ",
                      lines.empty() ? formatted("key {}", samples[i]) : formatted("line {}", lines[samples[i]]),
                      time_text(samples[i]));
  return text + (samples.size() > samples_shown ? ", …" : "");
}

}  // namespace

std::string places_text(const std::vector<std::size_t>& samples, const Places& places) {
  return text_of_places(samples, places.lines, [&](std::size_t i) { return places.time(i).to_string() + " s"; });
}

std::string places_text(const std::vector<std::size_t>& samples, const Track& recording) {
  return text_of_places(samples, recording.lines,
                        [&](std::size_t i) { return recording.time_text(recording.time_of(i)); });
}

std::string choice_line(const Smoothing& smoothing) {
  std::string line =
      formatted("smoothing time  {}\n", choice_text(smoothing.smoothing_time, smoothing.cutoff(), smoothing.criterion,
                                                    smoothing.chosen_on, smoothing.keys.size()));
  if (smoothing.smoothing_times.empty()) return line;
  return line + formatted("  in time       it varies from {:.4g} s to {:.4g} s about this mean\n",
                          *smoothing.shortest_smoothing_time(), *smoothing.longest_smoothing_time());
}

std::string position_choice_line(const Smoothing& smoothing) {
  return smoothing.positions ? formatted("positions       {}\n", choice_of_positions(smoothing)) : "";
}

}}}  // namespace orispline::jobs
