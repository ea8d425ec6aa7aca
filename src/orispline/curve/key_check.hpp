// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include <orispline/base/expected.hpp>
#include <orispline/math/eigen.hpp>

// What one key must be, whether it comes with all the others or alone. Errors are bad_data with the key's index;
// success allocates nothing.

namespace orispline::inline ORISPLINE_ABI {

/// A time that is not finite, or that does not come after that of the key before, or not at a step in range.
[[nodiscard]] std::optional<Error> check_time(std::size_t key, double time, std::optional<double> before);

/// The norm of a key's quaternion; an error when it is not finite or farther than `norm_error_limit` from 1.
[[nodiscard]] Expected<double> checked_norm(std::size_t key, const Eigen::Quaterniond& q);

/// A vector that is not finite; `what` names it, such as "position".
[[nodiscard]] std::optional<Error> check_vector(std::size_t key, const char* what, const Eigen::Vector3d& v);

}  // namespace orispline::inline ORISPLINE_ABI
