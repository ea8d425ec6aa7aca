// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <nanobind/stl/vector.h>

#include <orispline/base/parallel.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "quantity.hpp"

using namespace nanobind::literals;

namespace orispline::python {
namespace {

constexpr std::size_t times_of_a_part = 2048;  // of one joint: in a thread's cache, and far dearer than the thread

template <class T>
using Memory = nb::ndarray<T, nb::ndim<3>, nb::c_contig, nb::device::cpu>;

/// One quantity of every curve, the samples of a time side by side: (n, curves, 4) or (n, curves, 3).
template <class T>
void fill_stack(const std::vector<const PythonCurve*>& curves, int asked, const Numbers& numbers, const Memory<T>& out,
                bool world, int beyond, unsigned threads) {
  const std::span<const double> times = span_of(numbers);
  const std::size_t parts = (times.size() + times_of_a_part - 1) / times_of_a_part;
  for (const PythonCurve* curve : curves)  // what cannot be asked is raised here, where that may be
    static_cast<void>(Quantity<T>(*curve, asked, world, beyond, 1));
  std::vector<Expected<void>> done(parts * curves.size());
  const auto part = [&](std::size_t i) {
    const std::size_t joint = i % curves.size(), begin = i / curves.size() * times_of_a_part;
    const auto part_times = times.subspan(begin, std::min(times_of_a_part, times.size() - begin));
    Quantity<T> quantity(*curves[joint], asked, world, beyond, 1);
    const std::size_t width = quantity.width();
    std::vector<T> rows(width * part_times.size());
    done[i] = quantity.at(part_times, rows.data());
    for (std::size_t k = 0; k < part_times.size(); ++k)
      std::copy_n(rows.data() + width * k, width, out.data() + width * ((begin + k) * curves.size() + joint));
  };
  {
    const nb::gil_scoped_release release;
    parallel_for(done.size(), threads, part);
  }
  for (std::size_t i = 0; i < done.size(); ++i)
    if (!done[i]) {
      Error error = done[i].error();
      if (error.where.time_index) *error.where.time_index += i / curves.size() * times_of_a_part;
      raise(error);
    }
}

}  // namespace

void add_stack(nb::module_& module) {
  module.def("fill_stack", &fill_stack<double>, "curves"_a, "what"_a, "times"_a, "out"_a.noconvert(), "world"_a,
             "beyond"_a, "threads"_a);
  module.def("fill_stack", &fill_stack<float>, "curves"_a, "what"_a, "times"_a, "out"_a.noconvert(), "world"_a,
             "beyond"_a, "threads"_a);
}

}  // namespace orispline::python
