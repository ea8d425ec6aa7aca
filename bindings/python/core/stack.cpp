// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/base/parallel.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "quantity.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

constexpr std::size_t times_of_a_part = 256;  // of all joints: what is written then fits into a thread's cache
constexpr std::size_t quantities = 7;         // orientations with rates of order 1 to 3, positions with theirs
constexpr std::array<std::size_t, quantities> widths{4, 3, 3, 3, 3, 3, 3};

/// (n, curves, 4) or (n, curves, 3); where every curve has times of its own (curves, n, …).
template <class T>
using Memory = std::optional<nb::ndarray<T, nb::ndim<3>, nb::c_contig, nb::device::cpu>>;
template <class T>
using Rows = std::array<T*, quantities>;

using Curves = std::vector<const PythonCurve*>;

template <class T>
Samples<T> samples_in(const std::array<std::span<T>, quantities>& rows) {
  return {.orientations = rows[0],
          .angular_velocities = rows[1],
          .angular_accelerations = rows[2],
          .angular_jerks = rows[3],
          .positions = rows[4],
          .velocities = rows[5],
          .accelerations = rows[6]};
}

/// Beside what there is room for, orientations, and where rates of the world need them the lower orders.
template <class T>
bool is_needed(const Rows<T>& out, bool world, std::size_t quantity) {
  return quantity == 0 || out[quantity] || (world && out[3] && quantity < 3);
}

/// Samples of all curves in turn at the same few times, and their places among those of all times.
template <class T>
class Part {
 public:
  Part(const Curves& curves, const Rows<T>& out, bool world, int beyond)
      : curves_(curves), out_(out), world_(world), beyond_{beyond} {}

  /// Those at `times`, of which the first is number `begin` of all.
  [[nodiscard]] Expected<void> make(std::span<const double> times, std::size_t begin) {
    std::array<std::span<T>, quantities> rows;
    for (std::size_t i = 0; i < quantities; ++i)
      if (is_needed(out_, world_, i)) {
        scratch_[i].resize(widths[i] * times.size());
        rows[i] = scratch_[i];
      }
    for (std::size_t joint = 0; joint < curves_.size(); ++joint) {
      const RateFrame frame = world_ ? RateFrame::world : RateFrame::body;
      if (auto done = curves_[joint]->sampler().sample_at<T>(times, samples_in(rows), beyond_, frame); !done)
        return done;
      for (std::size_t i = 0; i < quantities; ++i)
        for (std::size_t k = 0; out_[i] && k < times.size(); ++k)
          std::copy_n(rows[i].data() + widths[i] * k, widths[i],
                      out_[i] + widths[i] * ((begin + k) * curves_.size() + joint));
    }
    return {};
  }

 private:
  const Curves& curves_;
  Rows<T> out_;
  bool world_;
  Extrapolation beyond_;
  std::array<std::vector<T>, quantities> scratch_;
};

/// What there is room for, of every curve, the samples of a time side by side.
template <class T>
void fill_together(const Curves& curves, std::span<const double> times, const Rows<T>& out, bool world, int beyond,
                   unsigned threads) {
  std::vector<Expected<void>> done((times.size() + times_of_a_part - 1) / times_of_a_part);
  {
    const nb::gil_scoped_release release;
    parallel_for(done.size(), threads, [&](std::size_t i) {
      const std::size_t begin = i * times_of_a_part, count = std::min(times_of_a_part, times.size() - begin);
      done[i] = Part<T>(curves, out, world, beyond).make(times.subspan(begin, count), begin);
    });
  }
  for (std::size_t i = 0; i < done.size(); ++i)
    if (!done[i]) {
      Error error = done[i].error();
      if (error.where.time_index) *error.where.time_index += i * times_of_a_part;
      raise(error);
    }
}

/// What there is room for, of every curve at times of its own.
template <class T>
void fill_each(const Curves& curves, std::span<const double> times, const Rows<T>& out, bool world, int beyond,
               unsigned threads) {
  const std::size_t count = curves.empty() ? 0 : times.size() / curves.size();
  std::vector<Expected<void>> done(curves.size());
  {
    const nb::gil_scoped_release release;
    parallel_for(curves.size(), threads, [&](std::size_t track) {
      std::array<std::vector<T>, quantities> scratch;
      std::array<std::span<T>, quantities> rows;
      for (std::size_t i = 0; i < quantities; ++i) {
        if (out[i]) rows[i] = {out[i] + widths[i] * count * track, widths[i] * count};
        else if (is_needed(out, world, i)) rows[i] = scratch[i] = std::vector<T>(widths[i] * count);
      }
      done[track] =
          curves[track]->sampler().sample_at<T>(times.subspan(count * track, count), samples_in(rows),
                                                Extrapolation{beyond}, world ? RateFrame::world : RateFrame::body);
    });
  }
  for (std::size_t track = 0; track < done.size(); ++track)
    if (!done[track]) {
      Error error = done[track].error();
      error.message.insert(0, "track " + std::to_string(track) + ": ");
      raise(error);
    }
}

template <class T>
void fill_stack(const Curves& curves, const Numbers& times, const Memory<T>& orientations,
                const Memory<T>& angular_velocities, const Memory<T>& angular_accelerations,
                const Memory<T>& angular_jerks, const Memory<T>& positions, const Memory<T>& velocities,
                const Memory<T>& accelerations, bool each, bool world, int beyond, unsigned threads) {
  const auto place = [](const Memory<T>& memory) { return memory ? memory->data() : nullptr; };
  const Rows<T> out{place(orientations), place(angular_velocities), place(angular_accelerations), place(angular_jerks),
                    place(positions),    place(velocities),         place(accelerations)};
  (each ? fill_each<T> : fill_together<T>)(curves, span_of(times), out, world, beyond, threads);
}

template <class T>
void add_fill_stack(nb::module_& module) {
  module.def("fill_stack", &fill_stack<T>, "curves"_a, "times"_a, "orientations"_a.noconvert().none() = nb::none(),
             "angular_velocities"_a.noconvert().none() = nb::none(),
             "angular_accelerations"_a.noconvert().none() = nb::none(),
             "angular_jerks"_a.noconvert().none() = nb::none(), "positions"_a.noconvert().none() = nb::none(),
             "velocities"_a.noconvert().none() = nb::none(), "accelerations"_a.noconvert().none() = nb::none(),
             nb::kw_only(), "each"_a, "world"_a, "beyond"_a, "threads"_a);
}

}  // namespace

void add_stack(nb::module_& module) {
  add_fill_stack<double>(module);
  add_fill_stack<float>(module);
}

}  // namespace orispline::python
