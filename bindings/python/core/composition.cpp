// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/composition.hpp>

#include <new>
#include <utility>

#include <orispline/curve/frame_change.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "files.hpp"
#include "keys.hpp"
#include "python_curve.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

void make_inverse(PythonCurve* place, const PythonCurve& curve) {
  new (place) PythonCurve(curve.keys(), PoseSampler(PoseCurve{inverse_of(curve.pose().orientation)}));
}

/// The product on the clock of `like`, one of both; the offsets are the times on their clocks at 0 of its [s].
void make_product(PythonCurve* place, const PythonCurve& a, const PythonCurve& b, const PythonCurve& like,
                  double offset_a, double offset_b) {
  new (place) PythonCurve(like.keys(),
                          value_of(PoseSampler::product(a.sampler(), b.sampler(), {.a = offset_a, .b = offset_b})));
}

/// A method in the frames that options of reading state, as keys_in_axes() has its keys.
MethodText method_in_axes(MethodText method, const io::StatedOptions& stated) {
  const NewFrames frames(frames_of(stated));
  method.words = in_frames(Recipe{.method = std::move(method.words)}, frames).method;
  return method;
}

}  // namespace

void add_compositions(nb::module_& module, nb::class_<PythonCurve>& curve_class) {
  curve_class.def("__init__", &make_inverse, "inverse_of"_a)
      .def("__init__", &make_product, "left"_a, "right"_a, "like"_a, "left_offset"_a, "right_offset"_a)
      .def_prop_ro("knots", [](const PythonCurve& curve) {
        const auto times = curve.pose().orientation.knots().times();
        return array_of(times.data(), times.size(), 0);
      });
  module.def("method_in_axes", &method_in_axes, "method"_a, "stated"_a);
}

}  // namespace orispline::python
