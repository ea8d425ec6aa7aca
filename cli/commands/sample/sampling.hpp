// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/analysis.hpp>
#include <orispline/curve/extrapolation.hpp>
#include <orispline/io/sample_writer.hpp>

#include "commands/sample/sample_buffer.hpp"
#include "options/method_options.hpp"
#include "options/sample_times.hpp"
#include "output/progress.hpp"

namespace orispline::cli {

/// What is sampled, and on how many threads.
struct Sampling {
  const PoseCurve& curve;
  const SampleTimes& times;
  io::SampleColumns columns;
  Extrapolation extrapolation = Extrapolation::hold;
  LeftOut outside = LeftOut::no;
  GapRows gaps = GapRows::none;
  std::size_t threads = 1;
  const BandInStretches* band = nullptr;  ///< where the columns have one
};

/// Writes every sample, the same on any number of threads; the number of those outside the curve and in gaps.
///
/// Memory does not grow with the number of samples.
[[nodiscard]] Expected<RowCounts> write_samples(io::SampleWriter& writer, const Sampling& sampling,
                                                Progress::Show show);

}  // namespace orispline::cli
