// SPDX-License-Identifier: Apache-2.0
#include "output/rows_file.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"

namespace orispline::cli {

namespace {

/// Rows on their way to a file.
class RowsFile final : public jobs::RowSink {
 public:
  RowsFile(const std::string& path, const io::SampleColumns& columns, const RowWriting& writing)
      : path_(path), columns_(columns), writing_(writing) {}

  void clear(std::size_t buffers) override {
    buffers_.resize(buffers, io::SampleRows(columns_, writing_.missing));
    for (io::SampleRows& rows : buffers_) rows.clear();
  }
  [[nodiscard]] Expected<void> add(std::size_t buffer, const TimeOrigin& origin, const jobs::SampleBlock& samples,
                                   std::size_t k) override {
    return buffers_[buffer].append(
        origin, samples.offset(k),
        {.motion = samples.motion(k), .linear_motion = samples.linear_motion(k), .band = samples.band(k)});
  }
  void add_empty(std::size_t buffer, const TimeOrigin& origin, double offset) override {
    buffers_[buffer].append_empty(origin, offset);
  }
  [[nodiscard]] Expected<void> write(std::size_t buffer, const jobs::SampleSource& source) override {
    return open(source).and_then([&] { return file_->file.write(buffers_[buffer]); });
  }
  void written(std::size_t samples) override {
    if (writing_.written) writing_.written(samples);
  }

  [[nodiscard]] Expected<void> open(const jobs::SampleSource& source) {
    if (file_) return {};
    return open_samples(path_, columns_, static_cast<std::size_t>(source.size().value_or(0)))
        .map([this](Noted<io::SampleWriter> file) { file_ = std::move(file); });
  }
  [[nodiscard]] Expected<void> finish() { return put_in_place(std::move(*file_)); }

 private:
  const std::string& path_;
  const io::SampleColumns& columns_;
  const RowWriting& writing_;
  std::vector<io::SampleRows> buffers_;
  std::optional<Noted<io::SampleWriter>> file_;
};

}  // namespace

RowWriting row_writing(const RowRequest& request, bool has_gaps, std::size_t threads) {
  // Only where it was asked for is a sample written that is NaN.
  return {.policy = {.outside = request.outside,
                     .gaps = !has_gaps           ? jobs::GapRows::none
                             : request.mark_gaps ? jobs::GapRows::empty
                                                 : jobs::GapRows::left_out,
                     .threads = threads},
          .missing =
              request.extrapolation == Extrapolation::nan ? io::MissingSamples::written : io::MissingSamples::refused};
}

Expected<jobs::RowCounts> write_rows(const std::string& path, const io::SampleColumns& columns,
                                     jobs::SampleSource& samples, const RowWriting& writing) {
  RowsFile file(path, columns, writing);
  jobs::RowPolicy policy = writing.policy;
  policy.in_turn = columns.form.runs_on();  // such angles know those of the row before
  const jobs::RowColumns wanted{columns.derivatives, columns.positions, columns.position_derivatives, columns.band};
  return jobs::sample_rows(samples, wanted, policy, file).and_then([&](const jobs::RowCounts& counts) {
    return file.open(samples).and_then([&] { return file.finish(); }).map([&] { return counts; });
  });
}

Expected<jobs::RowCounts> write_rows(const std::string& path, const io::SampleColumns& columns, const PoseCurve& curve,
                                     const jobs::SampleTimes& times, const jobs::CurveSampling& sampling,
                                     RowWriting writing, Progress::Show show) {
  Progress progress(times.size(), show);
  writing.written = [&progress](std::size_t samples) { progress.advance_to(samples); };
  jobs::CurveSamples samples(curve, times, sampling);
  return write_rows(path, columns, samples, writing);
}

}  // namespace orispline::cli
