// SPDX-License-Identifier: Apache-2.0
#include "output/repairs_text.hpp"

#include <vector>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>

namespace orispline::cli {

std::string text_of(const io::RepairReport& repairs) {
  std::vector<std::string> clauses;
  if (repairs.duplicates_dropped > 0)
    clauses.push_back(formatted("dropped {} of duplicate time", counted(repairs.duplicates_dropped, "row")));
  if (repairs.invalid_dropped > 0)
    clauses.push_back(formatted("dropped {} without valid numbers", counted(repairs.invalid_dropped, "row")));
  if (repairs.largest_matrix_distance > 0.0)
    clauses.push_back(
        formatted("made {} the nearest rotation: up to {:.3g} away by Frobenius' norm",
                  repairs.normalised == 1 ? "1 matrix" : formatted("{} matrices each", repairs.normalised),
                  repairs.largest_matrix_distance));
  else if (repairs.normalised > 0)
    clauses.push_back(formatted("made {} unit: norms up to {:.3g} off", counted(repairs.normalised, "quaternion"),
                                repairs.largest_norm_error));
  if (repairs.rates_left_free > 0)
    clauses.push_back(formatted("left rates of {} free", counted(repairs.rates_left_free, "key")));
  if (repairs.rows_between > 0)
    clauses.push_back(
        formatted("put {} in between for turns that no quaternion holds", counted(repairs.rows_between, "row")));
  if (repairs.rows_moved > 0) clauses.push_back(formatted("sorted {}", counted(repairs.rows_moved, "row")));
  return joined(clauses, "; ");
}

}  // namespace orispline::cli
