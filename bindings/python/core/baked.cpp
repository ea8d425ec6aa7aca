// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include <nanobind/stl/pair.h>

#include <orispline/batch/baked_curve.hpp>
#include <orispline/batch/sample.hpp>
#include <orispline/jobs.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "interruption.hpp"
#include "python_curve.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

template <class T>
using Rows = nb::ndarray<T, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
template <class T>
using Coefficients = nb::ndarray<const T, nb::shape<-1, 4, batch::baked_degree<T> + 1>, nb::c_contig, nb::device::cpu>;
/// Of a piece: middle [s] and 1/s, which its variable is made of.
using Scales = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;

constexpr std::size_t samples_at_a_time = std::size_t{1} << 12;

/// Orders of what is asked for: 0 the orientation, then its rates.
constexpr int orientation = 0;

template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;

/// Samples with all rates that one of them needs in the world's frame.
template <class T>
struct Scratch {
  std::array<T, 4 * samples_at_a_time> orientations;
  std::array<std::array<T, 3 * samples_at_a_time>, 3> rates;

  [[nodiscard]] Samples<T> spans(std::size_t count, int order) {
    Samples<T> out{.orientations = std::span(orientations).first(4 * count)};
    const auto room = [&](int rate) { return std::span(rates[static_cast<std::size_t>(rate)]).first(3 * count); };
    if (order >= 1) out.angular_velocities = room(0);
    if (order >= 2) out.angular_accelerations = room(1);
    if (order >= 3) out.angular_jerks = room(2);
    return out;
  }
  [[nodiscard]] Eigen::Vector3d in_world(std::size_t k, int order) const {
    const auto rate = [&](std::size_t i) -> Eigen::Vector3d {
      return Eigen::Map<const Vector<T>>(rates[i].data() + 3 * k).template cast<double>();
    };
    const Eigen::Map<const Eigen::Quaternion<T>> turn(orientations.data() + 4 * k);
    Motion motion{.orientation = turn.template cast<double>(), .angular_velocity = rate(0)};
    if (order == 1) return angular_velocity_world(motion);
    motion.angular_acceleration = rate(1);
    if (order == 2) return angular_acceleration_world(motion);
    motion.angular_jerk = rate(2);
    return angular_jerk_world(motion);
  }
};

/// One quantity at times in any order, into memory of NumPy: (n, 4) or (n, 3).
template <class T>
Expected<void> sample_into(const BakedCurve<T>& curve, int order, std::span<const double> times, const Rows<T>& out,
                           bool world) {
  const nb::gil_scoped_release release;
  const std::size_t width = order == orientation ? 4 : 3;
  const auto scratch = std::make_unique<Scratch<T>>();
  Expected<void> done;
  for (std::size_t begin = 0; begin < times.size() && done; begin += samples_at_a_time) {
    const std::size_t count = std::min(samples_at_a_time, times.size() - begin);
    const std::span<T> rows(out.data() + width * begin, width * count);
    Samples<T> samples = scratch->spans(count, world ? order : 0);
    if (order == orientation) samples.orientations = rows;
    else if (!world)
      (order == 1   ? samples.angular_velocities
       : order == 2 ? samples.angular_accelerations
                    : samples.angular_jerks) = rows;
    done = sample_at<T>(curve, times.subspan(begin, count), samples);
    if (done && world && order != orientation)
      for (std::size_t k = 0; k < count; ++k)
        Eigen::Map<Vector<T>>(rows.data() + 3 * k) = scratch->in_world(k, order).template cast<T>();
  }
  return done;
}

template <class T>
void many_of_baked(const BakedCurve<T>& curve, int order, const Numbers& times, const Rows<T>& out, bool world) {
  value_of(sample_into<T>(curve, order, span_of(times), out, world));
}

/// What it is made of, to be stored.
template <class T>
nb::tuple parts_of(const BakedCurve<T>& curve) {
  const auto ends = curve.knots().times();
  const auto pieces = curve.pieces();
  const nb::module_ numpy = nb::module_::import_("numpy");
  constexpr int powers = batch::baked_degree<T> + 1;
  const nb::object coefficients =
      numpy.attr("empty")(nb::make_tuple(pieces.size(), 4, powers), sizeof(T) == sizeof(float) ? "float32" : "float64");
  const nb::object scales = numpy.attr("empty")(nb::make_tuple(pieces.size(), 2));
  T* row = nb::cast<nb::ndarray<T, nb::ndim<3>, nb::c_contig, nb::device::cpu>>(coefficients).data();
  double* scale = nb::cast<Rows<double>>(scales).data();
  for (const batch::BakedRecord<T>& piece : pieces) {
    row = std::copy_n(&piece.coefficients[0][0], 4 * powers, row);
    *scale++ = piece.middle;
    *scale++ = piece.per_step;
  }
  return nb::make_tuple(array_of(ends.data(), ends.size(), 0), coefficients, scales, curve.largest_difference());
}

template <class T>
BakedCurve<T> restored(const Numbers& ends, const Coefficients<T>& coefficients, const Scales& scales,
                       double largest_difference) {
  constexpr std::size_t size = 4 * (batch::baked_degree<T> + 1);
  if (coefficients.shape(0) != scales.shape(0))
    raise({ErrorCode::bad_data, "found pieces without their times, wanted those of a baked curve", {}});
  std::vector<batch::BakedRecord<T>> pieces(coefficients.shape(0));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::copy_n(coefficients.data() + size * i, size, &pieces[i].coefficients[0][0]);
    pieces[i].middle = scales.data()[2 * i];
    pieces[i].per_step = scales.data()[2 * i + 1];
  }
  return value_of(
      BakedCurve<T>::restored({ends.data(), ends.data() + ends.size()}, std::move(pieces), largest_difference));
}

template <class T>
void add(nb::module_& module, nb::class_<PythonCurve>& curve_class, const char* name, const char* bake_name) {
  nb::class_<BakedCurve<T>>(module, name)
      .def(nb::new_(&restored<T>), "ends"_a, "coefficients"_a, "scales"_a, "largest_difference"_a)
      .def("__len__", [](const BakedCurve<T>& curve) { return curve.pieces().size(); })
      .def_prop_ro("domain",
                   [](const BakedCurve<T>& curve) { return std::pair(curve.domain().start, curve.domain().end); })
      .def_prop_ro("largest_difference", &BakedCurve<T>::largest_difference)
      .def_prop_ro("nbytes", [](const BakedCurve<T>& curve) { return curve.pieces().size_bytes(); })
      .def_prop_ro("parts", &parts_of<T>)
      .def("many", &many_of_baked<T>, "order"_a, "times"_a, "out"_a.noconvert(), "world"_a);
  curve_class.def(
      bake_name,
      [](const PythonCurve& curve, double tolerance) {
        return value_of(interruptible([&](const Progress& progress) {
          return jobs::check_without_gaps(*curve.keys().track).and_then([&] {
            return bake<T>(curve.pose().orientation, tolerance, {}, progress);
          });
        }));
      },
      "tolerance"_a);
}

}  // namespace

void add_baked(nb::module_& module, nb::class_<PythonCurve>& curve_class) {
  add<double>(module, curve_class, "BakedCurve64", "bake64");
  add<float>(module, curve_class, "BakedCurve32", "bake32");
}

}  // namespace orispline::python
