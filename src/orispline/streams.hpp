// SPDX-License-Identifier: Apache-2.0
#pragma once

// Keys that arrive one by one, or in pieces, and many tracks in one call.

#include <orispline/online/online_curve.hpp>
#include <orispline/online/sample_tracks.hpp>
#include <orispline/online/track_sampler.hpp>
