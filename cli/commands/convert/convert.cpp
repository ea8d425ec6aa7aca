// SPDX-License-Identifier: Apache-2.0
#include "commands/convert/convert.hpp"

#include <utility>

#include <orispline/io/track_file.hpp>

#include "commands/convert/convert_report.hpp"
#include "output/keys_file.hpp"

namespace orispline::cli {
namespace {

/// Digits are those of quaternions: other forms are those of a unit quaternion.
Expected<io::TrackFile> open_source(InputRequest request, const io::OrientationForm& form) {
  request.read.keep_exact_times = true;
  request.read.keep_as_read = form.representation == io::Representation::quaternion;
  return io::read_track(request.path, request.read, request.signs);
}

ConvertReport report_on(const io::TrackFile& source, const ConvertOptions& options, const io::SampleColumns& columns) {
  ConvertReport report{.input = options.input.path,
                       .output = options.output.path,
                       .input_format = source.format,
                       .output_format = columns.format,
                       .repairs = source.repairs,
                       .keyframes = source.track.keys.report(),
                       .keys = source.track.keys.size(),
                       .start = source.track.exact_times.front(),
                       .end = source.track.exact_times.back(),
                       .dropped_columns = source.ignored_columns};
  if (columns.derivatives == 0 && !source.track.keys.angular_velocities().empty())
    report.dropped_columns.emplace_back("angular velocities");
  if (!columns.positions)
    report.positions =
        columns.format->holds.always_positions ? ConvertReport::Positions::zero : ConvertReport::Positions::absent;
  return report;
}

}  // namespace

Expected<void> convert(const ConvertOptions& options) {
  FirstError checked;
  auto input = checked(input_request(options.input, Signs::as_given));
  auto columns = checked(output_columns(options.output));
  auto request = std::move(checked).or_else(std::move(input));
  if (!request) return tl::unexpected(std::move(request.error()));
  if (auto fits = check_summary(options.summary, options.output.path, "keys"); !fits) return fits;
  const auto source = open_source(std::move(*request), columns.form);
  if (!source) return tl::unexpected(source.error());
  columns.positions = !source->track.keys.positions().empty();
  columns.derivatives = columns.format->holds.rates && !source->track.keys.angular_velocities().empty() ? 1 : 0;
  const ConvertReport report = report_on(*source, options, columns);
  return write_keys(options.output.path, source->track, columns).and_then([&] {
    return summarise(options.summary, report);
  });
}

}  // namespace orispline::cli
