// SPDX-License-Identifier: Apache-2.0
#include "output/repairs_json.hpp"

namespace orispline::cli {

void add_repairs(Json& json, const io::RepairReport& repairs) {
  json["duplicates_dropped"] = repairs.duplicates_dropped;
  json["invalid_dropped"] = repairs.invalid_dropped;
  json["rows_moved"] = repairs.rows_moved;
  json["normalised"] = repairs.normalised;
  json["rates_left_free"] = repairs.rates_left_free;
}

}  // namespace orispline::cli
