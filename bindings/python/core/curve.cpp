// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <utility>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>

#include <orispline/analysis.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/jobs.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "fields.hpp"
#include "quantity.hpp"
#include "sample_memory.hpp"
#include "text.hpp"

using namespace nanobind::literals;

namespace orispline::python {

PythonCurve::PythonCurve(Keys keys, const MethodText& stated)
    : keys_(std::move(keys)),
      method_([&] {
        Method method = stated.method();
        const FamilyInfo& family = *value_of(family_of_method(method));
        return completed(std::move(method), family, *keys_.track);
      }()),
      sampler_([this] {
        const nb::gil_scoped_release release;
        return jobs::curve_through(method_, *keys_.track).map([](PoseCurve curve) {
          return PoseSampler(std::move(curve));
        });
      }()) {
  if (sampler_) return;
  const bool has_columns = method_.options.parameters.size() > stated.method().options.parameters.size();
  raise(placed(*keys_.track, has_columns, sampler_.error()));
}

namespace {

/// One quantity at many times, into memory of NumPy: (n, 4) or (n, 3).
template <class T>
void many(const PythonCurve& curve, int asked, const Numbers& numbers, const Memory<T>& memory, bool world, int beyond,
          unsigned threads) {
  Quantity<T> quantity(curve, asked, world, beyond, threads);
  const auto fill = [&] {
    const nb::gil_scoped_release release;
    return quantity.at(span_of(numbers), memory.data());
  };
  value_of(fill());
}

/// One quantity at one time, with the bits that `many` has there.
nb::object one(const PythonCurve& curve, int asked, double t, bool world, int beyond) {
  Quantity<double> quantity(curve, asked, world, beyond, 1);
  static const nb::handle empty = nb::object(nb::module_::import_("numpy").attr("empty")).release();  // kept for good
  const nb::object array = empty(quantity.width());
  const auto memory = nb::cast<nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>>(array);
  auto done = quantity.at({&t, 1}, memory.data());
  if (!done) done.error().where.time_index.reset();  // there is but one
  value_of(std::move(done));
  return array;
}

/// What the segment before the time has there, where it may jump: orientation, ω, α, jerk, then position, v and a.
nb::list motion_before(const PythonCurve& curve, double t, bool world) {
  const Motion motion = curve.pose().orientation.motion(t, Side::left);
  nb::list arrays;
  arrays.append(array_of(motion.orientation.coeffs().data(), 4, 0));
  const auto append = [&](const Eigen::Vector3d& v) { arrays.append(array_of(v.data(), 3, 0)); };
  append(world ? angular_velocity_world(motion) : motion.angular_velocity);
  append(world ? angular_acceleration_world(motion) : motion.angular_acceleration);
  append(world ? angular_jerk_world(motion) : motion.angular_jerk);
  if (!curve.pose().position) return arrays;
  const LinearMotion linear = curve.pose().position->linear_motion(t, Side::left);
  append(linear.position);
  append(linear.velocity);
  append(linear.acceleration);
  return arrays;
}

}  // namespace

void add_curve(nb::module_& module) {
  module.def("extrapolations", [] {
    nb::list list;
    for (const Word& word : words<Extrapolation>) list.append(text(word.word));
    return list;
  });
  auto curve_class = nb::class_<PythonCurve>(module, "Curve");
  add_grids(module, curve_class);
  add_analysis(module, curve_class);
  add_baked(module, curve_class);
  add_pictures(module, curve_class);
  curve_class.def(nb::init<Keys, const MethodText&>(), "keys"_a, "method"_a)
      .def_prop_ro("keys", &PythonCurve::keys)
      .def_prop_ro("method", [](const PythonCurve& curve) { return MethodText::of(curve.method()); })
      .def_prop_ro("info",
                   [](const PythonCurve& curve) { return info_of(*value_of(family_of_method(curve.method()))); })
      .def_prop_ro("has_positions", [](const PythonCurve& curve) { return curve.pose().position.has_value(); })
      .def_prop_ro("domain",
                   [](const PythonCurve& curve) { return std::pair(curve.domain().start, curve.domain().end); })
      .def_prop_ro(
          "warnings",
          [](const PythonCurve& curve) {
            return warnings_of(orispline::warnings_of(curve.method(), *curve.keys().track, &curve.pose().orientation));
          })
      .def("continuity",
           [](const PythonCurve& curve) {
             return continuity_at_keys(curve.pose().orientation,
                                       curve.method().options.loop ? Seam::closed : Seam::open)
                 .order();
           })
      .def("one", &one, "what"_a, "t"_a, "world"_a, "beyond"_a)
      .def("motion_before", &motion_before, "t"_a, "world"_a)
      .def("many", &many<double>, "what"_a, "times"_a, "out"_a.noconvert(), "world"_a, "beyond"_a, "threads"_a)
      .def("many", &many<float>, "what"_a, "times"_a, "out"_a.noconvert(), "world"_a, "beyond"_a, "threads"_a);
  add_compositions(module, curve_class);
  add_fills(curve_class);
}

}  // namespace orispline::python
