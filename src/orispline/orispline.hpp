// SPDX-License-Identifier: Apache-2.0
#pragma once

// The interface of the library: keyframes in, curves with exact rates out.

#include <orispline/base/version.hpp>
#include <orispline/curve/composition.hpp>
#include <orispline/curve/extrapolation.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/key_findings.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/motion_band.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/families/setting_quantity.hpp>
#include <orispline/math/geodesic.hpp>
