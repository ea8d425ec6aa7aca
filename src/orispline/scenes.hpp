// SPDX-License-Identifier: Apache-2.0
#pragma once

// Skeletons and their clips: how they move, how they differ, and files of them (ORISPLINE_SCENES).

#include <orispline/clip/clip_difference.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/scenes/scene_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>
