// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <orispline/math/eigen.hpp>

// NumPy's memory as the library takes it. The package makes all arrays C-contiguous and of the right type before.

namespace orispline::python {

namespace nb = nanobind;

using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using WritableNumbers = nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Rows4 = nb::ndarray<const double, nb::shape<-1, 4>, nb::c_contig, nb::device::cpu>;
using Rows3 = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

[[nodiscard]] inline std::span<const double> span_of(const Numbers& numbers) {
  return {numbers.data(), numbers.size()};
}

/// Rows into the vectors of Eigen, whose memory is the same: `x, y, z`, and `x, y, z, w` of a quaternion.
template <class Row, class Array>
[[nodiscard]] std::vector<Row> rows_of(const Array& array) {
  std::vector<Row> rows(array.shape(0));
  static_assert(sizeof(Row) % sizeof(double) == 0);
  if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), array.data(), array.size() * sizeof(double));
  return rows;
}

template <class Row, class Array>
[[nodiscard]] std::vector<Row> rows_of(const std::optional<Array>& array) {
  return array ? rows_of<Row>(*array) : std::vector<Row>();
}

/// An array of NumPy that holds float64, and says so where its function is described.
class FloatArray : public nb::object {
  NB_OBJECT(FloatArray, nb::object, "numpy.typing.NDArray[numpy.float64]", nb::ndarray_check)
};

/// A new array of NumPy's own, filled with these numbers; `columns` 0 makes one dimension.
[[nodiscard]] FloatArray array_of(const double* numbers, std::size_t rows, std::size_t columns);

}  // namespace orispline::python
