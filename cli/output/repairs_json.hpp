// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/io/key_file.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// Four members: how many rows each kind of repair touched.
void add_repairs(Json& json, const io::RepairReport& repairs);

}  // namespace orispline::cli
