// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include <orispline/io/sample_writer.hpp>
#include <orispline/jobs/sample_rows.hpp>

#include "options/row_options.hpp"
#include "output/progress.hpp"

namespace orispline::cli {

/// How samples become rows of a file.
struct RowWriting {
  jobs::RowPolicy policy{};
  io::MissingSamples missing = io::MissingSamples::refused;
  std::function<void(std::size_t)> written{};  ///< told how many samples have been written; null: nobody is
};

/// As it was asked for, of keys with gaps or without.
[[nodiscard]] RowWriting row_writing(const RowRequest& request, bool has_gaps, std::size_t threads);

/// Writes samples into a file that appears complete or not at all, also when the command is interrupted; it is opened
/// when the first ones have been made. What became of them.
[[nodiscard]] Expected<jobs::RowCounts> write_rows(const std::string& path, const io::SampleColumns& columns,
                                                   jobs::SampleSource& samples, const RowWriting& writing);
/// The samples of a curve, with a bar of progress.
[[nodiscard]] Expected<jobs::RowCounts> write_rows(const std::string& path, const io::SampleColumns& columns,
                                                   const PoseCurve& curve, const jobs::SampleTimes& times,
                                                   const jobs::CurveSampling& sampling, RowWriting writing,
                                                   Progress::Show show);

}  // namespace orispline::cli
