// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/euler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Notices what is lost of the turns that Euler angles state: yaw from 0° to 350° is a step of -10° the short way, and
/// from 0° to 720° it is none at all. Recordings whose angles begin anew at 180° or 360° lose nothing: there an angle
/// jumps by nearly a full turn within a range of one, and the steps beside it are like what is left of the jump.
class ORISPLINE_EXPORT EulerTurns {
 public:
  /// The angles [rad] of the next key, in the order of the turns, and the quaternion that they make, with its sign.
  void add(const Eigen::Vector3d& angles, const Eigen::Quaterniond& q);
  /// Says that there are no more keys.
  void finish();

  /// `lost_turns`: steps whose turns the signs do not keep (`steps`), and where the first of them begins. One warning
  /// at most. The file is named by the caller.
  [[nodiscard]] std::vector<Warning> warnings(Signs signs, const EulerOrder& order) const;

 private:
  /// A step from one key to the next.
  struct Step {
    std::size_t key = 0;  // before it
    Eigen::Vector3d from{}, to{};
    bool is_whole = false;  // a full turn or more, that no signs can state
  };
  struct Lost {
    std::size_t steps = 0;
    Step first{};
  };

  [[nodiscard]] bool looks_wrapped(const Step& step, const Eigen::Vector3d& beside) const;
  void note(const Step& step);

  std::size_t keys_ = 0;
  Eigen::Vector3d angles_{}, least_{}, most_{};
  std::optional<Eigen::Vector3d> step_{};  // to the last key
  Eigen::Quaterniond q_{};
  std::optional<Step> open_{};  // that is lost unless the next step says otherwise
  Lost half_{}, whole_{};       // those that signs as given would keep, and the others
};

}}}  // namespace orispline::io
