// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include <orispline/families/auto.hpp>
#include <orispline/families/slerp.hpp>
#include <orispline/families/squad.hpp>
#include <orispline/families/timed.hpp>

// In the place of the header of that name where a program is to be small.

namespace orispline { inline namespace ORISPLINE_ABI {

/// THE list of the families of such programs.
using Families = std::tuple<families::Auto, families::Slerp, families::Squad, families::TimedC2>;

}}  // namespace orispline
