// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/curve/motion.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/jobs.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/report/motion_drawing.hpp>
#include <orispline/report/page_samples.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "python_curve.hpp"
#include "text.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

using Vector = nb::ndarray<const double, nb::shape<3>, nb::c_contig, nb::device::cpu>;
using Inertia = nb::ndarray<const double, nb::shape<3, 3>, nb::c_contig, nb::device::cpu>;

nb::object numbers(const std::vector<double>& values) { return array_of(values.data(), values.size(), 0); }

nb::object rows(const std::vector<Eigen::Quaterniond>& quaternions) {
  return array_of(quaternions.empty() ? nullptr : quaternions.front().coeffs().data(), quaternions.size(), 4);
}

report::PageSamples drawn_samples(const PythonCurve& curve) {
  const nb::gil_scoped_release release;
  return report::sampled(curve.pose(), report::samples_to_draw);
}

/// Times [s], with both sides of jumps, orientations, and what charts show of them by its word.
nb::tuple drawn(const PythonCurve& curve) {
  const report::PageSamples samples = drawn_samples(curve);
  nb::dict charts;
  for (const report::DrawnQuantity& quantity : report::drawn_quantities())
    charts[text(quantity.word)] = numbers(quantity.values(samples));
  return nb::make_tuple(numbers(samples.path.times), rows(samples.path.orientations), charts);
}

std::string svg(const PythonCurve& curve, std::string title) {
  const nb::gil_scoped_release release;
  const std::array shown{jobs::NamedCurve{text_of(curve.method()), curve.pose()}};
  return jobs::picture_of({.title = std::move(title)}, curve.keys().track->keys, shown);
}

/// Angles [deg] between orientations at the same times, the largest of every so many where there are very many.
nb::tuple drawn_errors(const Numbers& times, const Rows4& one, const Rows4& other) {
  const auto p = rows_of<Eigen::Quaterniond>(one), q = rows_of<Eigen::Quaterniond>(other);
  report::PageErrors errors{.times = {times.data(), times.data() + times.size()}};
  for (std::size_t i = 0; i < p.size(); ++i) errors.values.push_back(angular_distance(p[i], q[i]) * degrees);
  if (errors.times.size() > report::samples_to_draw) errors = report::largest(errors, report::samples_to_draw);
  return nb::make_tuple(numbers(errors.times), numbers(errors.values));
}

/// Where a body axis points in the world: (n, 3).
nb::object directions(const Rows4& orientations, const Vector& axis) {
  const Eigen::Vector3d body = Eigen::Map<const Eigen::Vector3d>(axis.data());
  std::vector<Eigen::Vector3d> found;
  for (const Eigen::Quaterniond& q : rows_of<Eigen::Quaterniond>(orientations))
    found.push_back(to_world<double>(q, body));
  return array_of(found.empty() ? nullptr : found.front().data(), found.size(), 3);
}

/// The faces of the body at even times from start to end, in the order of drawing: the time of each [s], its three
/// corners as x and y, which is down, and its opacity.
nb::tuple ghosts(const PythonCurve& curve, std::size_t count) {
  const report::View view = report::view_of_ghosts();
  std::vector<double> times, corners, opacities;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count - 1);
    const double t = std::lerp(curve.domain().start, curve.domain().end, share);
    for (const report::SeenFace& face : report::seen_faces(view, curve.pose().orientation(t))) {
      times.push_back(t);
      opacities.push_back(face.opacity);
      for (const report::Point& corner : face.corners) corners.insert(corners.end(), {corner.x, corner.y});
    }
  }
  return nb::make_tuple(numbers(times), array_of(corners.data(), times.size(), 6), numbers(opacities));
}

/// The text that `make()` gives, which works without Python's lock; bytes, since names in it need not be UTF-8.
template <class Make>
nb::bytes bytes_of(const Make& make) {
  const std::string text = [&] {
    const nb::gil_scoped_release release;
    return make();
  }();
  return nb::bytes(text.data(), text.size());
}

/// The page of a curve; `start` is the caller's own time at 0 s.
report::Page page_of(const PythonCurve& curve, const std::string& title, const std::string& date,
                     const std::string& start, const std::optional<Inertia>& inertia) {
  std::optional<Eigen::Matrix3d> matrix;
  if (inertia) matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(inertia->data());
  return value_of([&]() -> Expected<report::Page> {
    const nb::gil_scoped_release release;
    auto epoch = Decimal::parse(start);
    if (!epoch) return tl::unexpected(std::move(epoch.error()));
    Track track = *curve.keys().track;
    track.epoch = *epoch;
    return pages::motion_page(track, curve.method(), {.title = title, .date = date}, matrix);
  }());
}

nb::bytes page(const PythonCurve& curve, const std::string& title, const std::string& date, const std::string& start,
               const std::optional<Inertia>& inertia) {
  const report::Page made = page_of(curve, title, date, start, inertia);
  return bytes_of([&] { return report::document(made); });
}

nb::bytes page_data(const PythonCurve& curve, const std::string& title, const std::string& date,
                    const std::string& start, const std::optional<Inertia>& inertia) {
  const report::Page made = page_of(curve, title, date, start, inertia);
  return bytes_of([&] { return report::data_of(made); });
}

/// The module that a notebook loads, and its style.
nb::tuple page_module() {
  const report::PageModule module = report::page_module();
  return nb::make_tuple(text(module.script), text(module.style));
}

void write_bytes(const std::string& path, const nb::bytes& bytes) {
  value_of([&] {
    const std::string_view text(bytes.c_str(), bytes.size());
    const nb::gil_scoped_release release;
    return io::OutputFile::open(path).and_then(
        [&](io::OutputFile file) { return file.write(text).and_then([&] { return file.finish(); }); });
  }());
}

}  // namespace

void add_pictures(nb::module_& module, nb::class_<PythonCurve>& curve_class) {
  module.attr("most_marked_keys") = report::most_marked_keys;
  module.attr("most_ghosts") = report::most_ghosts;
  module.def("drawn_errors", &drawn_errors, "times"_a, "one"_a, "other"_a);
  module.def("directions", &directions, "orientations"_a, "axis"_a);
  module.def("page_module", &page_module);
  module.def("write_bytes", &write_bytes, "path"_a, "bytes"_a);
  curve_class.def("drawn", &drawn)
      .def("ghosts", &ghosts, "count"_a)
      .def("svg", &svg, "title"_a)
      .def("page", &page, "title"_a, "date"_a, "start"_a, "inertia"_a.none())
      .def("page_data", &page_data, "title"_a, "date"_a, "start"_a, "inertia"_a.none());
}

}  // namespace orispline::python
