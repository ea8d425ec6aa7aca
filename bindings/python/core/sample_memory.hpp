// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/batch/sample.hpp>

#include "arrays.hpp"

namespace orispline::python {

/// Rows of NumPy that samples are written to.
template <class T>
using Memory = nb::ndarray<T, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// Room for samples in arrays of NumPy; where there is none, nothing is wanted.
template <class T>
[[nodiscard]] Samples<T> samples_in(const Memory<T>& orientations, const std::optional<Memory<T>>& angular_velocities,
                                    const std::optional<Memory<T>>& angular_accelerations,
                                    const std::optional<Memory<T>>& angular_jerks,
                                    const std::optional<Memory<T>>& positions,
                                    const std::optional<Memory<T>>& velocities,
                                    const std::optional<Memory<T>>& accelerations) {
  const auto span = [](const std::optional<Memory<T>>& memory) {
    return memory ? std::span<T>(memory->data(), memory->size()) : std::span<T>();
  };
  return {.orientations = {orientations.data(), orientations.size()},
          .angular_velocities = span(angular_velocities),
          .angular_accelerations = span(angular_accelerations),
          .angular_jerks = span(angular_jerks),
          .positions = span(positions),
          .velocities = span(velocities),
          .accelerations = span(accelerations)};
}

/// `count` of the samples from one on.
template <class T>
[[nodiscard]] Samples<T> part_of(const Samples<T>& all, std::size_t from, std::size_t count) {
  const auto part = [&](std::span<T> numbers, std::size_t columns) {
    return numbers.empty() ? numbers : numbers.subspan(columns * from, columns * count);
  };
  return {.orientations = part(all.orientations, 4),
          .angular_velocities = part(all.angular_velocities, 3),
          .angular_accelerations = part(all.angular_accelerations, 3),
          .angular_jerks = part(all.angular_jerks, 3),
          .positions = part(all.positions, 3),
          .velocities = part(all.velocities, 3),
          .accelerations = part(all.accelerations, 3)};
}

}  // namespace orispline::python
