// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include <nanobind/stl/optional.h>

#include <orispline/batch/sample_grid.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "quantity.hpp"
#include "sample_memory.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

/// What is asked beside the samples themselves.
struct Asked {
  RateFrame frame;
  Extrapolation beyond;
  Work work;

  Asked(bool world, int how, unsigned threads)
      : frame(world ? RateFrame::world : RateFrame::body), beyond{how}, work{threads} {}
};

/// Samples at times that are given, in any order.
template <class T>
Expected<void> fill(const PythonCurve& curve, std::span<const double> times, const Samples<T>& out,
                    const Asked& asked) {
  return in_blocks(times.size(), asked.work, [&](std::size_t begin, std::size_t count) {
    return curve.sampler().sample_at<T>(times.subspan(begin, count), part_of(out, begin, count), asked.beyond,
                                        asked.frame, asked.work);
  });
}

/// The times of a grid and the samples there, which find them in the cache.
template <class T>
Expected<void> fill_even(const PythonCurve& curve, const SampleGrid& grid, std::span<double> times,
                         const Samples<T>& out, const Asked& asked) {
  return in_blocks(times.size(), asked.work, [&](std::size_t begin, std::size_t count) {
    const auto some = times.subspan(begin, count);
    grid.fill(begin, some);
    return curve.sampler().sample_at<T>(some, part_of(out, begin, count), asked.beyond, asked.frame, asked.work);
  });
}

template <class T>
void add_fills(nb::class_<PythonCurve>& curve_class) {
  using Rows = const std::optional<Memory<T>>&;
  const auto add = [&](const char* name, auto function, auto... times) {
    curve_class.def(name, function, times..., "orientations"_a.noconvert(), "angular_velocities"_a.noconvert().none(),
                    "angular_accelerations"_a.noconvert().none(), "angular_jerks"_a.noconvert().none(),
                    "positions"_a.noconvert().none(), "velocities"_a.noconvert().none(),
                    "accelerations"_a.noconvert().none(), "world"_a, "beyond"_a, "threads"_a);
  };
  const auto without_gil = [](auto work) {
    const nb::gil_scoped_release release;
    return work();
  };
  add(
      "fill",
      [without_gil](const PythonCurve& curve, const Numbers& times, const Memory<T>& q, Rows w, Rows a, Rows j, Rows p,
                    Rows v, Rows l, bool world, int beyond, unsigned threads) {
        const Asked asked(world, beyond, threads);
        const Samples<T> out = samples_in<T>(q, w, a, j, p, v, l);
        value_of(without_gil([&] { return fill<T>(curve, span_of(times), out, asked); }));
      },
      "times"_a);
  add(
      "fill_even",
      [without_gil](const PythonCurve& curve, const SampleGrid& grid, const WritableNumbers& times, const Memory<T>& q,
                    Rows w, Rows a, Rows j, Rows p, Rows v, Rows l, bool world, int beyond, unsigned threads) {
        const Asked asked(world, beyond, threads);
        const Samples<T> out = samples_in<T>(q, w, a, j, p, v, l);
        value_of(without_gil([&] { return fill_even<T>(curve, grid, {times.data(), times.size()}, out, asked); }));
      },
      "grid"_a, "times"_a.noconvert());
}

}  // namespace

void add_fills(nb::class_<PythonCurve>& curve_class) {
  add_fills<double>(curve_class);
  add_fills<float>(curve_class);
}

}  // namespace orispline::python
