// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "arrays.hpp"
#include "errors.hpp"
#include "files.hpp"
#include "grid.hpp"
#include "text.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

using Text = std::optional<std::string>;

/// A GridText, and where the curve begins and ends.
using StatedGrid = std::tuple<Text, std::optional<std::size_t>, Text, Text, bool, double, double>;

/// What samples have beside orientations, and nothing where they do not: three rates, a position and its two rates.
using Columns = std::array<std::optional<Rows3>, 6>;

/// When samples are, as it is written.
struct Times {
  TimeOrigin epoch;
  TimeOrigin start;
  std::optional<SampleGrid> grid{};
};

Expected<Times> times_of(const std::string& epoch_text, const std::optional<StatedGrid>& stated) {
  const auto epoch = Decimal::parse(epoch_text);
  if (!epoch) return tl::unexpected(epoch.error());
  if (!stated) return Times{TimeOrigin(*epoch), TimeOrigin(*epoch)};
  const auto& [rate, count, start, end, include_end, first, last] = *stated;
  const GridText text{rate, count, start, end, include_end};
  auto grid = text.grid(first, last);
  if (!grid) return tl::unexpected(std::move(grid.error()));
  const Decimal begin = text.begin().value().value_or(Decimal::from_double(first));  // which the grid has read already
  return Times{TimeOrigin(*epoch), TimeOrigin(*epoch + begin), std::move(*grid)};
}

Eigen::Vector3d row(const std::optional<Rows3>& rows, std::size_t k) {
  if (!rows) return Eigen::Vector3d::Zero();
  return Eigen::Vector3d(rows->data() + 3 * k);
}

io::Sample sample_of(const Rows4& orientations, const Columns& columns, std::size_t k) {
  return {.motion = {.orientation = Eigen::Quaterniond(orientations.data() + 4 * k),
                     .angular_velocity = row(columns[0], k),
                     .angular_acceleration = row(columns[1], k),
                     .angular_jerk = row(columns[2], k)},
          .linear_motion = {
              .position = row(columns[3], k), .velocity = row(columns[4], k), .acceleration = row(columns[5], k)}};
}

io::SampleColumns filled(io::SampleColumns columns, const Columns& there, bool world) {
  columns.frame = world ? io::Frame::world : io::Frame::body;
  columns.derivatives = there[0].has_value() + there[1].has_value() + there[2].has_value();
  columns.positions = there[3].has_value();
  columns.position_derivatives = there[4].has_value() + there[5].has_value();
  return columns;
}

/// Rows are written as they are: rates in the world frame are there already.
Expected<void> write_rows(io::SampleWriter& writer, io::SampleColumns columns, const Times& times,
                          std::span<const double> seconds, const Rows4& orientations, const Columns& there) {
  columns.frame = io::Frame::body;
  io::SampleRows rows(columns);
  std::size_t even = 0;  // of the grid, of which some times may be left out
  for (std::size_t k = 0; k < seconds.size(); ++k) {
    const double t = seconds[k];
    if (!std::isfinite(t)) return failure(ErrorCode::bad_data, "found a time that is not finite", {.time_index = k});
    const io::Sample sample = sample_of(orientations, there, k);
    while (times.grid && even < *times.grid->size() && (*times.grid)[even].t < t) ++even;
    const bool is_even = times.grid && even < *times.grid->size() && (*times.grid)[even].t == t;
    auto appended =
        is_even ? rows.append(times.start, times.grid->offset(even), sample) : rows.append(times.epoch, t, sample);
    if (!appended) return appended;
    if (rows.bytes().size() < io::written_block) continue;
    if (auto written = writer.write(rows); !written) return written;
    rows.clear();
  }
  return writer.write(rows);
}

/// The bytes of a file in memory.
nb::bytes write_samples(const std::string& path, bool in_memory, const io::StatedOptions& stated,
                        const std::string& like, const std::string& epoch, const std::optional<StatedGrid>& grid,
                        bool world, const Numbers& seconds, const Rows4& orientations, const Columns& there) {
  const auto bytes = [&]() -> Expected<std::string> {
    const nb::gil_scoped_release release;
    const auto times = times_of(epoch, grid);
    if (!times) return tl::unexpected(times.error());
    auto named = io::columns_of_output(path, stated);
    if (!named) return tl::unexpected(std::move(named.error()));
    io::SampleColumns columns = filled(std::move(*named), there, world);
    if (const io::FormatInfo* const read = format_of(like)) columns = io::columns_like(*read, columns, path, stated);
    auto opened = in_memory ? io::SampleWriter::open(io::OutputFile::in_memory(path), columns, seconds.size())
                            : io::SampleWriter::open(path, columns, seconds.size());
    return std::move(opened).and_then([&](io::SampleWriter writer) {
      return write_rows(writer, columns, *times, span_of(seconds), orientations, there)
          .and_then([&] { return writer.finish(); })
          .map([&] { return std::move(writer).bytes(); });
    });
  }();
  if (!bytes) raise(bytes.error());
  return nb::bytes(bytes->data(), bytes->size());
}

std::vector<std::string> names(bool world, int derivatives, int position_derivatives) {
  return io::column_names({.positions = position_derivatives >= 0,
                           .derivatives = derivatives,
                           .position_derivatives = std::max(position_derivatives, 0),
                           .frame = world ? io::Frame::world : io::Frame::body});
}

}  // namespace

void add_sample_writing(nb::module_& module) {
  module.def(
      "write_samples",
      [](const std::string& path, bool in_memory, const io::StatedOptions& stated, const std::string& like,
         const std::string& epoch, const std::optional<StatedGrid>& grid, bool world, const Numbers& seconds,
         const Rows4& orientations, const std::optional<Rows3>& angular_velocities,
         const std::optional<Rows3>& angular_accelerations, const std::optional<Rows3>& angular_jerks,
         const std::optional<Rows3>& positions, const std::optional<Rows3>& velocities,
         const std::optional<Rows3>& accelerations) {
        return write_samples(
            path, in_memory, stated, like, epoch, grid, world, seconds, orientations,
            {angular_velocities, angular_accelerations, angular_jerks, positions, velocities, accelerations});
      },
      "path"_a, "in_memory"_a, "stated"_a, "like"_a, "epoch"_a, "grid"_a.none(), "world"_a, "seconds"_a,
      "orientations"_a, "angular_velocities"_a.none(), "angular_accelerations"_a.none(), "angular_jerks"_a.none(),
      "positions"_a.none(), "velocities"_a.none(), "accelerations"_a.none());
  module.def("column_names", &names, "world"_a, "derivatives"_a, "position_derivatives"_a);
}

}  // namespace orispline::python
