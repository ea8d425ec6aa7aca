// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "options/option_text.hpp"

namespace orispline::cli {

/// Three principal moments, or those with the products of inertia Jxy, Jxz, Jyz [kg m²].
[[nodiscard]] Expected<Eigen::Matrix3d> inertia_in(OptionText option);

/// A line about an inertia that no rigid body has; else nothing.
[[nodiscard]] std::optional<std::string> inertia_warning(const Eigen::Matrix3d& inertia);

}  // namespace orispline::cli
