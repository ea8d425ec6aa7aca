// SPDX-License-Identifier: Apache-2.0
#include "output/repairs_json.hpp"

#include <orispline/math/degrees.hpp>

namespace orispline::cli {

void add_repairs(Json& json, const io::RepairReport& repairs) {
  json["duplicates_dropped"] = repairs.duplicates_dropped;
  json["invalid_dropped"] = repairs.invalid_dropped;
  json["rows_moved"] = repairs.rows_moved;
  json["normalised"] = repairs.normalised;
  json["rates_left_free"] = repairs.rates_left_free;
  json["rows_between"] = repairs.rows_between;
  json["largest_matrix_distance"] = repairs.largest_matrix_distance;
  json["largest_duplicate_deg"] = repairs.largest_duplicate_turn * degrees;
  json["largest_duplicate_m"] = repairs.largest_duplicate_distance;
}

}  // namespace orispline::cli
