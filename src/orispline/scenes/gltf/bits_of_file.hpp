// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// A channel of rotations as a file of the scene held it, to write the same bits again where they were not changed:
/// `read` is `raw` normalised.
struct RotationOfFile {
  RotationChannel raw{}, read{};
};

/// How near a key is to one of the file that it is taken to be.
enum class SameKey { to_the_bit, to_rounding };

/// Each key that is as it was read, as the file had it.
[[nodiscard]] RotationChannel with_bits_of_file(RotationChannel channel, const RotationOfFile& file, SameKey same);

}}}  // namespace orispline::scenes::gltf
