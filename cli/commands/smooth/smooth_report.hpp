// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <orispline/io/key_file.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline::cli {

/// What `orispline smooth` did.
struct SmoothReport {
  Track recording{};  ///< as it was read
  io::RepairReport repairs{};
  std::string output{};
  orispline::Penalty penalty{};
  orispline::Loss loss{};
  bool positions = false, samples = false;
  std::size_t rows = 0;  ///< written
  orispline::Smoothing smoothing{};
};

/// The frequency at which the smoother's gain is one half [Hz].
[[nodiscard]] double cutoff_of(const orispline::Smoothing& smoothing);

/// Whether the curve through the keys at these times is one through a stretch at this time [s], and neither over a gap
/// nor beside all of them. Logarithmic time.
[[nodiscard]] bool covers(const orispline::Smoothing& smoothing, std::span<const double> times, double t);

/// `: line 6 (5.2 s), line 9 (5.8 s)`, some of the samples, with their lines and times in the file.
[[nodiscard]] std::string places_text(const std::vector<std::size_t>& samples, const std::vector<std::uint32_t>& lines,
                                      const std::vector<Decimal>& times);

/// `smoothing time  0.1 s (cut-off 1.59 Hz), by …`
[[nodiscard]] std::string choice_line(const orispline::Smoothing& smoothing);

/// What is noteworthy about the choice of the smoothing time, the outliers or the iteration, as a sentence; empty when
/// nothing.
[[nodiscard]] std::string remark_on(const orispline::Smoothing& smoothing);

/// A page for people.
[[nodiscard]] std::string text_of(const SmoothReport& report);

/// One JSON document, described in docs/inspect-json.md.
[[nodiscard]] std::string json_of(const SmoothReport& report);

}  // namespace orispline::cli
