// SPDX-License-Identifier: Apache-2.0
#include "convert.hpp"

#include <cmath>
#include <utility>

#include "convert_report.hpp"
#include "interruption.hpp"
#include "json.hpp"

namespace orispline::cli {
namespace {

/// The keys as they were read, and as they were checked.
struct Source {
  io::KeyFile file;  ///< without the keyframes
  std::vector<Eigen::Quaterniond> as_read;
  Keyframes keys;
};

Expected<Source> open_source(InputRequest request) {
  request.read.keep_exact_times = true;
  auto file = io::read_keys(request.path, request.read);
  if (!file) return tl::unexpected(std::move(file.error()));
  auto as_read = file->data.orientations;
  const auto keys = Keyframes::make(std::exchange(file->data, {}), request.signs);
  if (!keys) return tl::unexpected(located(*file, keys.error()));
  return Source{std::move(*file), std::move(as_read), *keys};
}

/// The digits of the file, with the sign that was asked for, where they are those of a unit quaternion.
Eigen::Quaterniond written_quaternion(const Source& source, std::size_t key) {
  const Eigen::Quaterniond &as_read = source.as_read[key], &checked = source.keys.orientations()[key];
  if (std::abs(as_read.norm() - 1.0) > unit_norm_tolerance) return checked;
  return as_read.dot(checked) < 0.0 ? Eigen::Quaterniond(-as_read.coeffs()) : as_read;
}

io::Sample sample_at(const Source& source, const io::SampleColumns& columns, std::size_t key) {
  const bool keeps_digits = columns.form.representation == io::Representation::quaternion;
  io::Sample sample{
      .motion = {.orientation = keeps_digits ? written_quaternion(source, key) : source.keys.orientations()[key]}};
  if (columns.positions) sample.linear_motion.position = source.keys.positions()[key];
  if (columns.derivatives > 0) sample.motion.angular_velocity = source.keys.angular_velocities()[key];
  return sample;
}

Expected<void> write_keys(io::SampleWriter& writer, const Source& source, const io::SampleColumns& columns) {
  for (std::size_t i = 0; i < source.keys.size(); ++i) {
    auto written = writer.write(source.file.exact_times[i], sample_at(source, columns, i));
    if (written) continue;
    if (written.error().code != ErrorCode::bad_data) return written;
    written.error().where.key = i;
    return tl::unexpected(located(source.file, std::move(written.error())));
  }
  return writer.finish();
}

ConvertReport report_on(const Source& source, const ConvertOptions& options, const io::SampleColumns& columns) {
  ConvertReport report{.input = options.input.path,
                       .output = options.output.path,
                       .input_format = source.file.format,
                       .output_format = columns.format,
                       .repairs = source.file.repairs,
                       .keyframes = source.keys.report(),
                       .keys = source.keys.size(),
                       .start = source.file.exact_times.front(),
                       .end = source.file.exact_times.back(),
                       .dropped_columns = source.file.ignored_columns};
  if (columns.derivatives == 0 && !source.keys.angular_velocities().empty())
    report.dropped_columns.emplace_back("angular velocities");
  if (!columns.positions)
    report.positions =
        io::holds_all_columns(columns.format) ? ConvertReport::Positions::absent : ConvertReport::Positions::zero;
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
  const auto source = open_source(std::move(*request));
  if (!source) return tl::unexpected(source.error());
  columns.positions = !source->keys.positions().empty();
  columns.derivatives = io::holds_all_columns(columns.format) && !source->keys.angular_velocities().empty() ? 1 : 0;
  const ConvertReport report = report_on(*source, options, columns);
  return io::SampleWriter::open(options.output.path, columns, source->keys.size())
      .and_then([&](io::SampleWriter writer) {
        const RemovedWhenInterrupted unfinished(writer.part());
        return write_keys(writer, *source, columns);
      })
      .and_then([&] { return summarise(options.summary, report); });
}

}  // namespace orispline::cli
