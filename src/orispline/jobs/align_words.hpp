// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/fields/json.hpp>
#include <orispline/math/eigen.hpp>

// What alignments by orientations and by rates say alike.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

[[nodiscard]] std::string rotation_text(const Eigen::Quaterniond& q);
/// ` ± 0.02°, 0.01°, 0.02°`; empty where it was not looked for.
[[nodiscard]] std::string sigmas_text(const Eigen::Vector3d& sigmas, double unit, std::string_view name);
[[nodiscard]] std::string sigma_text(double sigma, std::string_view name);

[[nodiscard]] Json vector_json(const Eigen::Vector3d& v);

}}}  // namespace orispline::jobs
