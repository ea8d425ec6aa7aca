// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/base/decimal.hpp>
#include <orispline/streams.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "interruption.hpp"
#include "keys.hpp"
#include "method_text.hpp"
#include "quantity.hpp"
#include "text.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

using Column = nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Offsets = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

constexpr std::size_t samples_at_a_time = 1024;
constexpr unsigned most_derivatives = 3;

/// Column of NumPy for column of NumPy: t, qx, qy, qz, qw and where there are positions x, y, z.
struct KeyColumns {
  const std::vector<Numbers>& columns;

  [[nodiscard]] std::span<const double> operator[](std::size_t i) const {
    return i < columns.size() ? span_of(columns[i]) : std::span<const double>();
  }
  [[nodiscard]] bool has_positions() const { return columns.size() == 8; }
  /// Raises ArgumentError where they are not the columns above.
  void check() const {
    const bool as_long =
        std::ranges::all_of(columns, [&](const Numbers& column) { return column.size() == columns.front().size(); });
    if ((columns.size() != 5 && columns.size() != 8) || !as_long)
      raise({ErrorCode::bad_argument,
             "found other columns, wanted t, qx, qy, qz, qw, or these and x, y, z, as long as t",
             {}});
  }
};

/// Even times at a rate: from the first key of each track on, or where multiples of 1/rate lie in it.
TrackGrid grid_of(const std::string& rate, bool at_multiples) {
  const Fraction hertz = value_of(Fraction::parse(rate));
  const SampleRate made{hertz.numerator().to_double(), hertz.denominator().to_double()};
  if (at_multiples) return {.step = made.seconds, .parts = made.hertz, .start = 0.0};
  return {.request = SampleGrid::Request{.spacing = made}};
}

/// New columns of NumPy, and where the library writes to.
struct Room {
  nb::list columns;
  TrackSampleColumns spans;

  Room(std::size_t count, unsigned derivatives, bool positions) {
    spans.times = column(count);
    fill(spans.orientations, count);
    if (positions) fill(spans.positions, count);
    if (derivatives > 0) fill(spans.angular_velocities, count);
    if (derivatives > 1) fill(spans.angular_accelerations, count);
    if (derivatives > 2) fill(spans.angular_jerks, count);
    if (positions && derivatives > 0) fill(spans.velocities, count);
    if (positions && derivatives > 1) fill(spans.accelerations, count);
  }

 private:
  template <std::size_t N>
  void fill(std::array<std::span<double>, N>& into, std::size_t count) {
    for (std::span<double>& one : into) one = column(count);
  }
  std::span<double> column(std::size_t count) {
    const nb::object array = nb::module_::import_("numpy").attr("empty")(count);
    columns.append(array);
    return {nb::cast<Column>(array).data(), count};
  }
};

template <std::size_t N>
void gather(const std::array<std::span<double>, N>& columns, std::size_t first, std::span<double> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = columns[i % N][first + i / N];
}

template <std::size_t N>
void scatter(std::span<const double> rows, const std::array<std::span<double>, N>& columns, std::size_t first) {
  for (std::size_t i = 0; i < rows.size(); ++i) columns[i % N][first + i / N] = rows[i];
}

/// Rates of the body become those of the world, with the bits of Curve.
void turn_columns(const TrackSampleColumns& columns) {
  std::vector<double> q, w, a, j;
  const auto rows_of = [](std::vector<double>& rows, const auto& from, std::size_t first, std::size_t count) {
    rows.resize(from[0].empty() ? 0 : from.size() * count);
    gather(from, first, rows);
    return std::span(rows);
  };
  const std::size_t size = columns.orientations[0].size();
  for (std::size_t first = 0; first < size; first += samples_at_a_time) {
    const std::size_t count = std::min(samples_at_a_time, size - first);
    const Samples<double> samples{.orientations = rows_of(q, columns.orientations, first, count),
                                  .angular_velocities = rows_of(w, columns.angular_velocities, first, count),
                                  .angular_accelerations = rows_of(a, columns.angular_accelerations, first, count),
                                  .angular_jerks = rows_of(j, columns.angular_jerks, first, count)};
    turn_to_world(samples);
    scatter(w, columns.angular_velocities, first);
    scatter(a, columns.angular_accelerations, first);
    scatter(j, columns.angular_jerks, first);
  }
}

/// What is taken, in columns of its own: t, qx … qw, x … z, then rate by rate those of the rotation and of the
/// position.
struct Wanted {
  std::size_t count;
  unsigned derivatives;
  bool positions, world;

  template <class Take>
  [[nodiscard]] nb::list from(const Take& take) const {
    Room room(count, std::min(derivatives, most_derivatives), positions);
    value_of(interruptible([&](const Progress& progress) {
      auto done = take(room.spans, progress);
      if (done && world && derivatives > 0) turn_columns(room.spans);
      return done;
    }));
    return std::move(room.columns);
  }
};

TrackBatch batch_of(const MethodText& method, const Offsets& offsets, const std::vector<Numbers>& columns,
                    const std::string& rate, bool at_multiples, std::optional<double> gap, unsigned threads) {
  const KeyColumns keys{columns};
  keys.check();
  const TrackColumns tracks{.offsets = {offsets.data(), offsets.size()},
                            .times = keys[0],
                            .orientations = {keys[1], keys[2], keys[3], keys[4]},
                            .positions = {keys[5], keys[6], keys[7]}};
  const Method made = method.method();
  const TrackGrid grid = grid_of(rate, at_multiples);
  return value_of(interruptible([&](const Progress& progress) {
    return TrackBatch::make(made, tracks, grid, {.gap = gap}, {.threads = threads}, progress);
  }));
}

/// How many samples every track has, and of those without any which one, which key and why.
nb::tuple counts_and_errors(const TrackBatch& batch) {
  const auto offsets = batch.offsets();
  const nb::object counts = nb::module_::import_("numpy").attr("empty")(offsets.size() - 1, "int64");
  const auto memory = nb::cast<nb::ndarray<std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>>(counts);
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i) memory.data()[i] = offsets[i + 1] - offsets[i];
  nb::list errors;
  for (Error error : batch.errors()) {
    const std::size_t track = error.where.curve.value_or(0);
    error.where.curve.reset();  // its place among the tracks of a batch is nobody's business
    errors.append(nb::make_tuple(track, describe(error)));
  }
  return nb::make_tuple(counts, errors);
}

nb::list take_of_batch(TrackBatch& batch, std::size_t count, unsigned derivatives, bool positions, bool world,
                       unsigned threads) {
  return Wanted{count, derivatives, positions, world}.from(
      [&](const TrackSampleColumns& out, const Progress& progress) {
        return batch.take(out, {.threads = threads}, progress);
      });
}

TrackSampler sampler_of(const MethodText& method, const std::string& rate, bool at_multiples,
                        std::optional<double> gap) {
  return value_of(TrackSampler::make(method.method(), grid_of(rate, at_multiples), {.gap = gap}));
}

/// Until the first key that is refused.
void append(TrackSampler& sampler, const std::vector<Numbers>& columns) {
  const KeyColumns keys{columns};
  keys.check();
  const auto [t, x, y, z, w] = std::array{keys[0], keys[1], keys[2], keys[3], keys[4]};
  value_of(interruptible([&](const Progress& progress) -> Expected<void> {
    constexpr std::size_t keys_at_a_time = 4096;
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (i % keys_at_a_time == 0 && progress.stopped()) return cancellation();
      StreamKey key{.time = t[i], .orientation = quaternion_xyzw(x[i], y[i], z[i], w[i])};
      if (keys.has_positions()) key.position = Eigen::Vector3d(keys[5][i], keys[6][i], keys[7][i]);
      if (auto taken = append_checked(sampler, std::move(key)); !taken) return taken;
    }
    return {};
  }));
}

nb::list take_of_sampler(TrackSampler& sampler, std::size_t count, unsigned derivatives, bool positions, bool world,
                         unsigned threads) {
  return Wanted{count, derivatives, positions, world}.from(
      [&](const TrackSampleColumns& out, const Progress& progress) {
        return take_columns(sampler, out, {.threads = threads}, progress);
      });
}

nb::bytes state_of(const TrackSampler& sampler) {
  const std::vector<std::byte> state = sampler.state();
  return nb::bytes(state.data(), state.size());
}

TrackSampler restored(const nb::bytes& state) {
  return value_of(TrackSampler::from_state({static_cast<const std::byte*>(state.data()), state.size()}));
}

}  // namespace

void add_tracks(nb::module_& module) {
  nb::class_<TrackBatch>(module, "TrackBatch")
      .def(nb::new_(&batch_of), "method"_a, "offsets"_a, "columns"_a, "rate"_a, "at_multiples"_a, "gap"_a.none(),
           "threads"_a)
      .def_prop_ro("counts_and_errors", &counts_and_errors)
      .def_prop_ro("left", &TrackBatch::left)
      .def("take", &take_of_batch, "count"_a, "derivatives"_a, "positions"_a, "world"_a, "threads"_a);
  nb::class_<TrackSampler>(module, "TrackSampler")
      .def(nb::new_(&sampler_of), "method"_a, "rate"_a, "at_multiples"_a, "gap"_a.none())
      .def_static("from_state", &restored, "state"_a)
      .def_prop_ro("state", &state_of)
      .def_prop_ro("keys", [](const TrackSampler& sampler) { return sampler.keys(); })
      .def_prop_ro("ready", [](const TrackSampler& sampler) { return sampler.ready(); })
      .def_prop_ro("is_global", &TrackSampler::is_global)
      .def("append", &append, "columns"_a)
      .def("finish", [](TrackSampler& sampler) { value_of(sampler.finish()); })
      .def("take", &take_of_sampler, "count"_a, "derivatives"_a, "positions"_a, "world"_a, "threads"_a);
}

}  // namespace orispline::python
