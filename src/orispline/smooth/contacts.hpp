// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A stretch of frames in which a joint stands on the ground.
struct Contact {
  std::size_t joint = 0;
  std::size_t first = 0, count = 0;              ///< keys of the rotation of its parent
  double start = 0.0, end = 0.0;                 ///< times of the first and the last of them [s]
  double slide_before = 0.0, slide_after = 0.0;  ///< mean speed in the world meanwhile [units of length/s]
};

/// A clip whose contacts are held, and these, joint after joint.
struct HeldContacts {
  Clip clip{};
  std::vector<Contact> contacts{};
};

/// The name that means the joints in which legs end, unless a joint has it.
inline constexpr std::string_view all_legs = "auto";

/// Holds joints where they stand on the ground, by small turns of the joints above them.
///
/// A joint stands where it is no more than 0.04 leg lengths above the height that 5 % of its frames are below (up is
/// y, or z where the figure is usually 1.5 times as tall along z as along y), and goes no faster than 0.4 leg lengths
/// in a second, from 0.1 s before to 0.1 s behind; for 0.1 s at least. A leg is what is above the joint: three joints
/// that turn at most, and none of those that the other legs are below too. In a contact the joint is drawn to the mean
/// of its places: of the turns of its leg ψ [rad] those that make Σ|ψ|² + 10 Σ|d|² the least, where d is how far the
/// joints are from there, in leg lengths, all contacts of a leg together. Within 0.1 s before and behind the second sum
/// comes and goes with two derivatives that are 0 at the ends. `auto`: the joints that turn, have two above them that
/// turn, and come within a tenth of the figure's height of its lowest.
///
/// Where a leg does not turn there are no contacts. Errors (bad_argument, `keep_contacts`): a joint that is not there,
/// or that has nothing but the root above it.
[[nodiscard]] ORISPLINE_EXPORT Expected<HeldContacts> held_contacts(const Skeleton& skeleton, const Clip& clip,
                                                                    std::span<const std::string> joints);

}}  // namespace orispline
