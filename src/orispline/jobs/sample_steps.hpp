// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/jobs/sample.hpp>
#include <orispline/jobs/sample_rows.hpp>

// The steps from keys or a joint to rows and to what there is to say of them.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// In the place of a method, of a joint: what its file says between its keys.
inline constexpr std::string_view stored_method = "stored";

/// The keys as they come back from a file that holds all of their digits: times count from the first key. The curve
/// through them is that of the file, bit for bit. Errors: those of Keyframes::make().
[[nodiscard]] Expected<Track> as_read_again(const Track& keys);

/// Of a joint that moves as its file says.
[[nodiscard]] SampleOutcome outcome_of_joint(std::string source, const PoseCurve& curve);

/// The joints that a clip moves, in the order of the skeleton: those with keys of their own, and in the world those
/// that these carry too.
[[nodiscard]] std::vector<std::size_t> moved_joints(const Skeleton& skeleton, const Clip& clip, JointSpace space);

/// Says what became of the samples.
void count_rows(SampleOutcome& outcome, const RowPolicy& policy, const RowCounts& counts);

}}}  // namespace orispline::jobs
