// SPDX-License-Identifier: Apache-2.0
#include "support/places.hpp"

namespace orispline::testing_support {

std::string in_project(std::string_view path) { return std::string(ORISPLINE_FOLDER "/").append(path); }

std::string beside_project(std::string_view path) { return std::string(ORISPLINE_FOLDER "/../shared/").append(path); }

}  // namespace orispline::testing_support
