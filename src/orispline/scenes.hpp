// SPDX-License-Identifier: Apache-2.0
#pragma once

// Skeletons and their clips, in files of animation (ORISPLINE_SCENES).

#include <orispline/scenes/scene_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>
