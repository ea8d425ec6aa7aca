// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"

namespace orispline::python {

FloatArray array_of(const double* numbers, std::size_t rows, std::size_t columns) {
  const nb::object empty = nb::module_::import_("numpy").attr("empty");
  const nb::object array = columns == 0 ? empty(rows) : empty(nb::make_tuple(rows, columns));
  const auto memory = nb::cast<nb::ndarray<double, nb::c_contig, nb::device::cpu>>(array);
  if (rows > 0) std::memcpy(memory.data(), numbers, rows * (columns == 0 ? 1 : columns) * sizeof(double));
  return nb::borrow<FloatArray>(array);
}

}  // namespace orispline::python
