// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <orispline/base/fraction.hpp>
#include <orispline/batch/sample_grid.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "grid.hpp"
#include "python_curve.hpp"

using namespace nanobind::literals;

namespace orispline::python {
namespace {

Expected<std::optional<Decimal>> decimal_in(const std::optional<std::string>& text) {
  if (!text) return std::optional<Decimal>();
  return Decimal::parse(*text).map([](const Decimal& number) { return std::optional(number); });
}

}  // namespace

Expected<std::optional<Decimal>> GridText::begin() const { return decimal_in(start); }

Expected<SampleGrid> GridText::grid(double first, double last) const {
  const auto from = decimal_in(start), to = decimal_in(end);
  if (!from) return tl::unexpected(from.error());
  if (!to) return tl::unexpected(to.error());
  SampleGrid::Request request{
      .spacing = SampleGrid::Count{count.value_or(0)},
      .start = *from,
      .end = *to,
      .last = include_end ? SampleGrid::LastSample::at_end : SampleGrid::LastSample::before_end};
  if (rate) {
    const auto hertz = Fraction::parse(*rate);
    if (!hertz) return tl::unexpected(hertz.error());
    request.spacing = SampleRate{hertz->numerator().to_double(), hertz->denominator().to_double()};
  }
  return SampleGrid::make(request, first, last);
}

namespace {

SampleGrid grid_of(const PythonCurve& curve, const GridText& text) {
  return value_of(text.grid(curve.domain().start, curve.domain().end));
}

FloatArray grid(const PythonCurve& curve, const std::optional<std::string>& rate, std::optional<std::size_t> count,
                const std::optional<std::string>& start, const std::optional<std::string>& end, bool include_end) {
  const SampleGrid made = grid_of(curve, {rate, count, start, end, include_end});
  const auto size = static_cast<std::size_t>(*made.size());
  const nb::object array = nb::module_::import_("numpy").attr("empty")(size);
  const auto memory = nb::cast<nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>>(array);
  made.fill(0, {memory.data(), size});
  return nb::borrow<FloatArray>(array);
}

std::size_t grid_size(const PythonCurve& curve, const std::string& rate, const std::optional<std::string>& start,
                      const std::optional<std::string>& end, bool include_end) {
  return static_cast<std::size_t>(*grid_of(curve, {rate, {}, start, end, include_end}).size());
}

}  // namespace

void add_grids(nb::class_<PythonCurve>& curve_class) {
  curve_class.def("grid", &grid, "rate"_a.none(), "count"_a.none(), "start"_a.none(), "end"_a.none(), "include_end"_a)
      .def("grid_size", &grid_size, "rate"_a, "start"_a.none(), "end"_a.none(), "include_end"_a);
}

}  // namespace orispline::python
