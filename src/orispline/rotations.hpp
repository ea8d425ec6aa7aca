// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rotations as numbers: exponential and logarithm with their derivatives, slerp, Euler angles, matrices.

#include <orispline/math/degrees.hpp>
#include <orispline/math/euler.hpp>
#include <orispline/math/geodesic.hpp>
#include <orispline/math/rotation_matrix.hpp>
#include <orispline/math/so3.hpp>
