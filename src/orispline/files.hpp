// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files of keyframes and of samples (ORISPLINE_IO).

#include <orispline/io/blending_file.hpp>
#include <orispline/io/file_json.hpp>
#include <orispline/io/file_option.hpp>
#include <orispline/io/input.hpp>
#include <orispline/io/key_reader.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/io/rates_file.hpp>
#include <orispline/io/sample_writer.hpp>
#include <orispline/io/time_order.hpp>
#include <orispline/io/times_file.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/io/whole_track.hpp>
