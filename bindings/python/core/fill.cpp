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

/// Calls `make(begin, count)` for samples that are made together.
template <class Make>
Expected<void> together(std::size_t size, Work work, Make make) {
  const std::size_t most = samples_at_a_time(work);
  for (std::size_t begin = 0; begin < size; begin += most)
    if (auto made = make(begin, std::min(most, size - begin)); !made) return made;
  return {};
}

template <class T>
Expected<void> make_part(const PythonCurve& curve, std::span<const double> times, const Samples<T>& out,
                         std::size_t begin, const Asked& asked) {
  return curve.sampler().sample_at<T>(times, part_of(out, begin, times.size()), asked.beyond, asked.frame, asked.work);
}

/// Samples at times that are given, in any order.
template <class T>
Expected<void> fill(const PythonCurve& curve, std::span<const double> times, const Samples<T>& out,
                    const Asked& asked) {
  if (asked.beyond == Extrapolation::error)  // the first time outside by its place among all
    if (auto inside = check_inside(curve.pose().orientation, times); !inside) return inside;
  return together(times.size(), asked.work, [&](std::size_t begin, std::size_t count) {
    return make_part<T>(curve, times.subspan(begin, count), out, begin, asked);
  });
}

/// The times of a grid and the samples there, which find them in the cache.
template <class T>
Expected<void> fill_even(const PythonCurve& curve, const SampleGrid& grid, std::span<double> times,
                         const Samples<T>& out, const Asked& asked) {
  if (asked.beyond == Extrapolation::error) {
    grid.fill(0, times);
    return fill<T>(curve, times, out, asked);
  }
  return together(times.size(), asked.work, [&](std::size_t begin, std::size_t count) {
    grid.fill(begin, times.subspan(begin, count));
    return make_part<T>(curve, times.subspan(begin, count), out, begin, asked);
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
