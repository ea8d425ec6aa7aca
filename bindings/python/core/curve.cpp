// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <orispline/analysis/continuity.hpp>
#include <orispline/batch/sample.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "python_curve.hpp"

using namespace nanobind::literals;

namespace orispline::python {

PythonCurve::PythonCurve(Keys keys, const std::string& method_text)
    : keys_(std::move(keys)),
      method_([&] {
        Method method = value_of(method_from_text(method_text));
        const FamilyInfo& family = *value_of(find_family(method.name));
        return completed(std::move(method), family, *keys_.track);
      }()),
      pose_([this] {
        const nb::gil_scoped_release release;
        return make_pose_curve(method_, keys_.track->keys);
      }()) {
  if (!pose_) raise(pose_.error());
}

const CompiledCurve<double>& PythonCurve::compiled() const {
  std::call_once(once_, [this] { compiled_.emplace(pose_->orientation); });
  return *compiled_;
}

namespace {

/// What is asked of a curve at a time.
enum class What { orientation, angular_velocity, angular_acceleration, angular_jerk, position, velocity, acceleration };

/// What a time outside the curve gets.
enum class Beyond { hold, error, nan };

constexpr std::size_t samples_at_a_time = std::size_t{1} << 15;  // of scratch memory, that of a thread's cache

/// Numbers of a sample.
constexpr std::size_t width_of(What what) { return what == What::orientation ? 4 : 3; }

/// The numbers of one time.
using Sample = std::array<double, 4>;

template <class Vector>
Sample numbers_of(const Vector& v) {
  return {v.x(), v.y(), v.z(), 0.0};
}

Sample sample_of(const PythonCurve& curve, What what, double t, bool world) {
  const AnyCurve& orientation = curve.pose().orientation;
  if (what == What::orientation) {
    const Eigen::Quaterniond q = orientation(t);
    return {q.x(), q.y(), q.z(), q.w()};
  }
  if (what >= What::position) {
    const LinearMotion motion = curve.pose().position->linear_motion(t);
    return numbers_of(what == What::position   ? motion.position
                      : what == What::velocity ? motion.velocity
                                               : motion.acceleration);
  }
  const Motion motion = orientation.motion(t);
  switch (what) {
    case What::angular_velocity:
      return numbers_of(world ? angular_velocity_world(motion) : motion.angular_velocity);
    case What::angular_acceleration:
      return numbers_of(world ? angular_acceleration_world(motion) : motion.angular_acceleration);
    default:
      return numbers_of(world ? angular_jerk_world(motion) : motion.angular_jerk);
  }
}

void check_has(const PythonCurve& curve, What what) {
  if (what >= What::position && !curve.pose().position)
    raise({ErrorCode::bad_argument, "these keys have no positions, wanted positions= of Keys or Curve", {}});
}

bool is_outside(const Domain& domain, double t) { return t < domain.start || t > domain.end; }

/// The first time outside the curve, which is an error.
void check_inside(const PythonCurve& curve, std::span<const double> times) {
  const Domain domain = curve.domain();
  const auto stray = std::ranges::find_if(times, [&](double t) { return is_outside(domain, t); });
  if (stray == times.end()) return;
  Error error = curve.pose().orientation.checked_motion(*stray).error();
  error.where.time_index = static_cast<std::size_t>(stray - times.begin());
  raise(error);
}

nb::object one(const PythonCurve& curve, int asked, double t, bool world, int beyond) {
  const What what{asked};
  check_has(curve, what);
  if (Beyond{beyond} == Beyond::error) check_inside(curve, {&t, 1});
  Sample sample = sample_of(curve, what, t, world);
  if (Beyond{beyond} == Beyond::nan && is_outside(curve.domain(), t))
    sample.fill(std::numeric_limits<double>::quiet_NaN());
  static const nb::handle empty = nb::object(nb::module_::import_("numpy").attr("empty")).release();  // kept for good
  const nb::object array = empty(width_of(what));
  const auto memory = nb::cast<nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>>(array);
  std::copy_n(sample.data(), width_of(what), memory.data());
  return array;
}

/// Where samples of a kind go, and what must be made beside them.
template <class T>
struct Planes {
  std::vector<T> orientations, angular_velocities, angular_accelerations;
};

template <class T>
std::span<T>& target_of(Samples<T>& samples, What what) {
  switch (what) {
    case What::orientation:
      return samples.orientations;
    case What::angular_velocity:
      return samples.angular_velocities;
    case What::angular_acceleration:
      return samples.angular_accelerations;
    case What::angular_jerk:
      return samples.angular_jerks;
    case What::position:
      return samples.positions;
    case What::velocity:
      return samples.velocities;
    default:
      return samples.accelerations;
  }
}

template <class T>
using RowsMap = Eigen::Map<Eigen::Matrix<T, 3, Eigen::Dynamic>>;

/// Turns rates of the body into those of the world, as math/frames has it.
template <class T>
void turn_to_world(const Samples<T>& samples, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Map<const Eigen::Quaternion<T>> q(samples.orientations.data() + 4 * k);
    const auto at = [k](std::span<T> numbers) { return Eigen::Map<Eigen::Matrix<T, 3, 1>>(numbers.data() + 3 * k); };
    if (!samples.angular_jerks.empty())
      at(samples.angular_jerks) =
          (q * (at(samples.angular_jerks) + at(samples.angular_velocities).cross(at(samples.angular_accelerations))))
              .eval();
    if (!samples.angular_accelerations.empty())
      at(samples.angular_accelerations) = (q * at(samples.angular_accelerations)).eval();
    if (!samples.angular_velocities.empty())
      at(samples.angular_velocities) = (q * at(samples.angular_velocities)).eval();
  }
}

template <class T>
Expected<void> sample_into(const PythonCurve& curve, std::span<const double> times, const Samples<T>& out,
                           unsigned threads, bool sorted) {
  if (wants_positions(out))
    return sorted ? sample<T>(curve.pose(), times, out, {.threads = threads})
                  : sample_at<T>(curve.pose(), times, out, {.threads = threads});
  if (sorted) return sample<T>(curve.pose().orientation, times, out, {.threads = threads});
  if constexpr (std::is_same_v<T, double>) return sample_at<T>(curve.compiled(), times, out, {.threads = threads});
  else return sample_at<T>(curve.pose().orientation, times, out, {.threads = threads});
}

template <class T>
using Memory = nb::ndarray<T, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// One quantity at many times, into memory of NumPy: (n, 4) or (n, 3).
template <class T>
void many(const PythonCurve& curve, int asked, const Numbers& numbers, const Memory<T>& memory, bool world, int beyond,
          unsigned threads) {
  const What what{asked};
  check_has(curve, what);
  const std::span<const double> times = span_of(numbers);
  if (Beyond{beyond} == Beyond::error) check_inside(curve, times);
  const std::size_t width = width_of(what);
  Expected<void> done;
  {
    const nb::gil_scoped_release release;
    const bool sorted = std::ranges::is_sorted(times) && std::ranges::none_of(times, [](double t) { return t != t; });
    const bool turns = world && what >= What::angular_velocity && what <= What::angular_jerk;
    const std::size_t most = samples_at_a_time * std::max(threads, 1u);
    Planes<T> planes;
    for (std::size_t begin = 0; begin < times.size() && done; begin += most) {
      const std::size_t count = std::min(most, times.size() - begin);
      const auto room = [count](std::vector<T>& numbers_of_plane, std::size_t columns) {
        numbers_of_plane.resize(columns * count);
        return std::span<T>(numbers_of_plane);
      };
      Samples<T> out;
      target_of(out, what) = {memory.data() + width * begin, width * count};
      if (what != What::orientation) out.orientations = room(planes.orientations, 4);
      if (turns && what == What::angular_jerk) {
        out.angular_velocities = room(planes.angular_velocities, 3);
        out.angular_accelerations = room(planes.angular_accelerations, 3);
      }
      done = sample_into<T>(curve, times.subspan(begin, count), out, threads, sorted);
      if (done && turns) turn_to_world(out, count);
    }
    if (done && Beyond{beyond} == Beyond::nan)
      for (std::size_t k = 0; k < times.size(); ++k)
        if (is_outside(curve.domain(), times[k]))
          std::fill_n(memory.data() + width * k, width, std::numeric_limits<T>::quiet_NaN());
  }
  value_of(std::move(done));
}

/// All of a sample that is asked for, at times that do not decrease, into memory of NumPy.
template <class T>
void fill(const PythonCurve& curve, const Numbers& numbers, const Memory<T>& orientations,
          const std::optional<Memory<T>>& angular_velocities, const std::optional<Memory<T>>& angular_accelerations,
          const std::optional<Memory<T>>& angular_jerks, const std::optional<Memory<T>>& positions,
          const std::optional<Memory<T>>& velocities, const std::optional<Memory<T>>& accelerations, bool world,
          unsigned threads) {
  const auto span = [](const std::optional<Memory<T>>& memory) {
    return memory ? std::span<T>(memory->data(), memory->size()) : std::span<T>();
  };
  const Samples<T> out{.orientations = {orientations.data(), orientations.size()},
                       .angular_velocities = span(angular_velocities),
                       .angular_accelerations = span(angular_accelerations),
                       .angular_jerks = span(angular_jerks),
                       .positions = span(positions),
                       .velocities = span(velocities),
                       .accelerations = span(accelerations)};
  Expected<void> done;
  {
    const nb::gil_scoped_release release;
    const std::span<const double> times = span_of(numbers);
    done = sample_into<T>(curve, times, out, threads, std::ranges::is_sorted(times));
    if (done && world) turn_to_world(out, times.size());
  }
  value_of(std::move(done));
}

}  // namespace

void add_curve(nb::module_& module) {
  auto curve_class = nb::class_<PythonCurve>(module, "Curve");
  add_grids(curve_class);
  add_analysis(module, curve_class);
  add_baked(module, curve_class);
  add_pictures(module, curve_class);
  curve_class.def(nb::init<Keys, const std::string&>(), "keys"_a, "method"_a)
      .def_prop_ro("keys", &PythonCurve::keys)
      .def_prop_ro("method", [](const PythonCurve& curve) { return text_of(curve.method()); })
      .def_prop_ro("name", [](const PythonCurve& curve) { return curve.method().name; })
      .def_prop_ro("has_positions", [](const PythonCurve& curve) { return curve.pose().position.has_value(); })
      .def_prop_ro("domain",
                   [](const PythonCurve& curve) { return std::pair(curve.domain().start, curve.domain().end); })
      .def("continuity", [](const PythonCurve& curve) {
        return continuity_at_keys(curve.pose().orientation, curve.method().options.loop ? Seam::closed : Seam::open)
            .order();
      })
      .def("one", &one, "what"_a, "t"_a, "world"_a, "beyond"_a)
      .def("many", &many<double>, "what"_a, "times"_a, "out"_a.noconvert(), "world"_a, "beyond"_a, "threads"_a)
      .def("many", &many<float>, "what"_a, "times"_a, "out"_a.noconvert(), "world"_a, "beyond"_a, "threads"_a)
      .def("fill", &fill<double>, "times"_a, "orientations"_a.noconvert(), "angular_velocities"_a.noconvert().none(),
           "angular_accelerations"_a.noconvert().none(), "angular_jerks"_a.noconvert().none(),
           "positions"_a.noconvert().none(), "velocities"_a.noconvert().none(), "accelerations"_a.noconvert().none(),
           "world"_a, "threads"_a)
      .def("fill", &fill<float>, "times"_a, "orientations"_a.noconvert(), "angular_velocities"_a.noconvert().none(),
           "angular_accelerations"_a.noconvert().none(), "angular_jerks"_a.noconvert().none(),
           "positions"_a.noconvert().none(), "velocities"_a.noconvert().none(), "accelerations"_a.noconvert().none(),
           "world"_a, "threads"_a);
}

}  // namespace orispline::python
