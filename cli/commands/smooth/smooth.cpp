// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/smooth.hpp"

#include <memory>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/smooth.hpp>

#include "commands/smooth/gyro_input.hpp"
#include "commands/smooth/smooth_scene.hpp"
#include "options/file_places.hpp"
#include "options/method_options.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/each_input.hpp"
#include "output/gathered_output.hpp"
#include "output/keys_file.hpp"
#include "output/noted_output.hpp"
#include "output/repairs_text.hpp"
#include "output/rows_file.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  orispline::SmoothOptions smoothing;
  io::SampleColumns columns;
  std::optional<RowRequest> rows;  ///< of samples
  std::size_t threads = 1;         ///< that make them
};

/// A file of the gyro asks for it.
SmoothnessOptions with_gyro(const SmoothArguments& options) {
  SmoothnessOptions smoothness = options.smoothness;
  if (options.gyro_file) smoothness.fields["gyro"] = "true";
  return smoothness;
}

Expected<Request> request_in(const SmoothArguments& options) {
  if (auto agreed = check_files(options); !agreed) return tl::unexpected(std::move(agreed.error()));
  const bool are_samples = options.rows.names_times();
  if (const auto given = first_given(options.rows); !are_samples && !given.empty())
    return usage_failure(formatted("{}: wanted --rate as well", given));
  if (are_samples && is_given(options.smoothness.fields, "sigma"))
    return usage_failure("--sigma: found --rate as well, wanted keys: standard deviations are those of keys");
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .smoothing = checked(smoothing_in(with_gyro(options))),
                  .columns = checked(output_columns(options.output)),
                  .rows = {}};
  if (are_samples) {
    request.rows = checked(row_request(options.rows, options.input, options.output, {}));
    request.threads = checked(threads_in(options.inputs.threads));
  }
  const bool reads_rates = request.smoothing.gyro && !options.gyro_file;
  request.input.read.rate_orders = reads_rates ? 1 : 0;
  request.input.read.world_rates = true;
  request.input.read.free_rates = io::FreeRates::lenient;
  request.input.read.unposed_rows = reads_rates ? io::UnposedRows::set_aside : io::UnposedRows::refused;
  request.input.read.parameters.assign(noise_columns.begin(), noise_columns.end());
  request.input.read.keep_exact_times = true;
  return std::move(checked).or_else(std::move(request));
}

/// Samples of the curve that the keys have when their file is read again, but none between two stretches; how many
/// rows there are.
Expected<std::size_t> write_samples(const std::string& path, const Request& request,
                                    const orispline::Smoothing& smoothed) {
  const auto keys = jobs::as_read_again(smoothed.track);
  if (!keys) return tl::unexpected(keys.error());
  const auto curve = jobs::curve_through(smoothed.method, *keys);
  if (!curve) return tl::unexpected(curve.error());
  const RowRequest& rows = *request.rows;
  const auto wanted = jobs::times_on_curve(rows.times, keys->epoch, curve->orientation.domain(), rows.extrapolation);
  if (!wanted) return tl::unexpected(wanted.error());
  warn(wanted->warnings);
  const RowWriting writing = row_writing(rows, keys->recipe.gap.has_value(), request.threads);
  return write_rows(path, with_positions(rows.columns, curve->position.has_value()), *curve, wanted->times,
                    {rows.extrapolation}, writing, Progress::Show::never)
      .map([&](const jobs::RowCounts& counts) { return counts.rows(writing.policy); });
}

/// The keys, with their standard deviations behind all other columns.
Track written_keys(const orispline::Smoothing& smoothed) {
  Track track = smoothed.track;
  if (!smoothed.sigmas) return track;
  const auto add = [&track](std::string_view letters, const std::vector<Eigen::Vector3d>& vectors) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      std::vector<double>& column = track.settings[formatted("sigma_{}{}", letters, "xyz"[axis])];
      column.clear();
      for (const Eigen::Vector3d& v : vectors) column.push_back(v[axis]);
    }
  };
  add("", smoothed.sigmas->orientations);
  add("w", smoothed.sigmas->angular_velocities);
  return track;
}

/// Whether the file can hold what was asked for.
Expected<void> check_format(const io::FormatInfo& format, const orispline::SmoothOptions& smoothing) {
  if (!smoothing.sigma || format.holds.settings) return {};
  return bad_option("sigma", formatted("{} has no columns for standard deviations, wanted a CSV file", format.file));
}

/// The keys, or samples of the curve through them.
Expected<void> write(const std::string& path, const Request& request, jobs::SmoothOutcome& outcome) {
  const orispline::Smoothing& smoothed = outcome.smoothing;
  if (request.rows)
    return write_samples(path, request, smoothed).map([&](std::size_t rows) { outcome.samples = rows; });
  io::SampleColumns columns = request.columns;
  columns.derivatives = columns.format->holds.rates ? 2 : 0;
  return write_keys(path, written_keys(smoothed), columns);
}

Expected<void> smooth_one(const SmoothArguments& options) {
  if (is_scene(options.output.path)) return smooth_scene(options);
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  auto file = io::read_track(request->input.path, request->input.read, request->input.signs);
  if (!file) return tl::unexpected(or_all_of_them(file.error(), "an output such as all.glb"));
  warn(file->warnings);
  request->columns = columns_like(*file->format, request->columns, options.output);
  if (request->rows) request->rows->columns = columns_for(options.rows, options.output, {}, *file->format);
  if (auto fits = check_format(*request->columns.format, request->smoothing); !fits) return fits;
  std::shared_ptr<const GyroRates> gyro;
  if (request->smoothing.gyro) {
    auto read = gyro_input(*file, options.gyro_file, request->input.read);
    if (!read) return tl::unexpected(std::move(read.error()));
    gyro = std::move(*read);
  }
  auto outcome = jobs::smooth({.recording = std::make_shared<const Track>(std::move(file->track)),
                               .options = request->smoothing,
                               .gyro = std::move(gyro)});
  if (!outcome) return tl::unexpected(said_of_cutoff(options.smoothness, std::move(outcome.error())));
  outcome->mended = text_of(file->repairs);
  for (Warning& warning : outcome->warnings) warning = with_flags(std::move(warning));
  warn(outcome->warnings);
  if (request->rows && !request->columns.format->holds.rates)
    warn({{.code = "rates_not_written",
           .message = "this format holds no rates: wx,wy,wz,ax,ay,az are not written, wanted a CSV file for them"}});
  return page->write([&](const auto& head) { return page_of(*outcome, head); })
      .and_then([&] { return write(options.output.path, *request, *outcome); })
      .and_then([&] { return page->finish(); })
      .and_then([&] {
        const std::string recording = outcome->request.recording->name, written = outcome->result();
        return summarise(options.summary, Written{recording, options.output.path, written, std::move(*outcome)});
      });
}

}  // namespace

Expected<void> check_files(const SmoothArguments& options) {
  const OutputOptions& output = options.output;
  std::vector<OtherFile> read{{"INPUT", options.input.path}};
  if (const auto& list = options.rows.list) {
    read.push_back({"that of --times", *list});
    if (*list == io::standard_stream && (options.inputs.folder || options.input.path == io::standard_stream))
      return usage_failure("--times: found '-', wanted a file, since standard input is read once only");
  }
  return check_output_apart(output.option, output.path, read)
      .and_then([&] { return check_summary(options.summary, output.path, "keys"); })
      .and_then([&] {
        return check_report(options.report, {{place_of_output(output), output.path}, {"INPUT", options.input.path}});
      });
}

Expected<void> smooth(const SmoothArguments& options) {
  const auto check = [](const SmoothArguments& one) {
    return is_scene(one.output.path) ? check_smooth_scene(one) : request_in(one).map([](const Request&) {});
  };
  return on_inputs(options, {.written = "keys", .check = check, .work = smooth_one, .scenes = SceneOutputs::same});
}

}  // namespace orispline::cli
