// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>

#include <nanobind/stl/optional.h>

#include <orispline/base/decimal.hpp>
#include <orispline/batch/sample_grid.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "grid.hpp"
#include "python_curve.hpp"
#include "text.hpp"

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

SampleGrid grid(const PythonCurve& curve, const std::optional<std::string>& rate, std::optional<std::size_t> count,
                const std::optional<std::string>& start, const std::optional<std::string>& end, bool include_end) {
  const GridText text{rate, count, start, end, include_end};
  return value_of(text.grid(curve.domain().start, curve.domain().end));
}

}  // namespace

void add_grids(nb::module_& module, nb::class_<PythonCurve>& curve_class) {
  nb::class_<SampleGrid>(module, "Grid")
      .def("__len__", [](const SampleGrid& grid) { return *grid.size(); })
      .def(
          "fill",
          [](const SampleGrid& grid, const WritableNumbers& times) {
            grid.fill(0, {times.data(), times.size()});
          },
          "times"_a.noconvert());
  curve_class.def("grid", &grid, "rate"_a.none(), "count"_a.none(), "start"_a.none(), "end"_a.none(), "include_end"_a);
}

}  // namespace orispline::python
