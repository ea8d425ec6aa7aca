// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/base/parallel.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "quantity.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

constexpr std::size_t times_of_a_part = 256;  // of all joints: what is written then fits into a thread's cache
constexpr std::size_t quantities = 4;         // orientations and rates of order 1 to 3
constexpr std::array<std::size_t, quantities> widths{4, 3, 3, 3};

/// (n, curves, 4) or (n, curves, 3).
template <class T>
using Memory = std::optional<nb::ndarray<T, nb::ndim<3>, nb::c_contig, nb::device::cpu>>;

/// Samples of all curves in turn at the same few times, and their places among those of all times.
template <class T>
class Part {
 public:
  Part(const std::vector<const PythonCurve*>& curves, const std::array<T*, quantities>& out, bool world, int beyond)
      : curves_(curves), out_(out), world_(world), beyond_{beyond} {}

  /// Those at `times`, of which the first is number `begin` of all.
  [[nodiscard]] Expected<void> make(std::span<const double> times, std::size_t begin) {
    const bool turns_jerks = world_ && out_[3];
    std::array<std::span<T>, quantities> rows;
    for (std::size_t i = 0; i < quantities; ++i)
      if (i == 0 || out_[i] || turns_jerks) {
        scratch_[i].resize(widths[i] * times.size());
        rows[i] = scratch_[i];
      }
    const Samples<T> samples{.orientations = rows[0],
                             .angular_velocities = rows[1],
                             .angular_accelerations = rows[2],
                             .angular_jerks = rows[3]};
    for (std::size_t joint = 0; joint < curves_.size(); ++joint) {
      const RateFrame frame = world_ ? RateFrame::world : RateFrame::body;
      if (auto done = curves_[joint]->sampler().sample_at<T>(times, samples, beyond_, frame); !done) return done;
      for (std::size_t i = 0; i < quantities; ++i)
        for (std::size_t k = 0; out_[i] && k < times.size(); ++k)
          std::copy_n(rows[i].data() + widths[i] * k, widths[i],
                      out_[i] + widths[i] * ((begin + k) * curves_.size() + joint));
    }
    return {};
  }

 private:
  const std::vector<const PythonCurve*>& curves_;
  std::array<T*, quantities> out_;
  bool world_;
  Extrapolation beyond_;
  std::array<std::vector<T>, quantities> scratch_;
};

/// What there is room for, of every curve, the samples of a time side by side.
template <class T>
void fill_stack(const std::vector<const PythonCurve*>& curves, const Numbers& numbers, const Memory<T>& orientations,
                const Memory<T>& angular_velocities, const Memory<T>& angular_accelerations,
                const Memory<T>& angular_jerks, bool world, int beyond, unsigned threads) {
  const auto place = [](const Memory<T>& memory) { return memory ? memory->data() : nullptr; };
  const std::array out{place(orientations), place(angular_velocities), place(angular_accelerations),
                       place(angular_jerks)};
  const std::span<const double> times = span_of(numbers);
  std::vector<Expected<void>> done((times.size() + times_of_a_part - 1) / times_of_a_part);
  {
    const nb::gil_scoped_release release;
    parallel_for(done.size(), threads, [&](std::size_t i) {
      const std::size_t begin = i * times_of_a_part, count = std::min(times_of_a_part, times.size() - begin);
      done[i] = Part<T>(curves, out, world, beyond).make(times.subspan(begin, count), begin);
    });
  }
  for (std::size_t i = 0; i < done.size(); ++i)
    if (!done[i]) {
      Error error = done[i].error();
      if (error.where.time_index) *error.where.time_index += i * times_of_a_part;
      raise(error);
    }
}

template <class T>
void add_fill_stack(nb::module_& module) {
  module.def("fill_stack", &fill_stack<T>, "curves"_a, "times"_a, "orientations"_a.noconvert().none() = nb::none(),
             "angular_velocities"_a.noconvert().none() = nb::none(),
             "angular_accelerations"_a.noconvert().none() = nb::none(),
             "angular_jerks"_a.noconvert().none() = nb::none(), nb::kw_only(), "world"_a, "beyond"_a, "threads"_a);
}

}  // namespace

void add_stack(nb::module_& module) {
  add_fill_stack<double>(module);
  add_fill_stack<float>(module);
}

}  // namespace orispline::python
