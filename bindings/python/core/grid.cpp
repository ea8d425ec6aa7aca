// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <orispline/base/fraction.hpp>
#include <orispline/batch/sample_grid.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "python_curve.hpp"

using namespace nanobind::literals;

namespace orispline::python {
namespace {

Expected<std::optional<Decimal>> decimal_in(const std::optional<std::string>& text) {
  if (!text) return std::optional<Decimal>();
  return Decimal::parse(*text).map([](const Decimal& number) { return std::optional(number); });
}

/// The even times of a rate (a number or a fraction, as text) or of a count, as the command has them.
SampleGrid grid_of(const PythonCurve& curve, const std::optional<std::string>& rate, std::optional<std::size_t> count,
                   const std::optional<std::string>& start, const std::optional<std::string>& end, bool include_end) {
  SampleGrid::Request request{
      .spacing = SampleGrid::Count{count.value_or(0)},
      .start = value_of(decimal_in(start)),
      .end = value_of(decimal_in(end)),
      .last = include_end ? SampleGrid::LastSample::at_end : SampleGrid::LastSample::before_end};
  if (rate) {
    const Fraction hertz = value_of(Fraction::parse(*rate));
    request.spacing = SampleRate{hertz.numerator().to_double(), hertz.denominator().to_double()};
  }
  return value_of(SampleGrid::make(request, curve.domain().start, curve.domain().end));
}

FloatArray grid(const PythonCurve& curve, const std::optional<std::string>& rate, std::optional<std::size_t> count,
                const std::optional<std::string>& start, const std::optional<std::string>& end, bool include_end) {
  const SampleGrid made = grid_of(curve, rate, count, start, end, include_end);
  const auto size = static_cast<std::size_t>(*made.size());
  const nb::object array = nb::module_::import_("numpy").attr("empty")(size);
  const auto memory = nb::cast<nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>>(array);
  made.fill(0, {memory.data(), size});
  return nb::borrow<FloatArray>(array);
}

std::size_t grid_size(const PythonCurve& curve, const std::string& rate, const std::optional<std::string>& start,
                      const std::optional<std::string>& end, bool include_end) {
  return static_cast<std::size_t>(*grid_of(curve, rate, {}, start, end, include_end).size());
}

}  // namespace

void add_grids(nb::class_<PythonCurve>& curve_class) {
  curve_class.def("grid", &grid, "rate"_a.none(), "count"_a.none(), "start"_a.none(), "end"_a.none(), "include_end"_a)
      .def("grid_size", &grid_size, "rate"_a, "start"_a.none(), "end"_a.none(), "include_end"_a);
}

}  // namespace orispline::python
