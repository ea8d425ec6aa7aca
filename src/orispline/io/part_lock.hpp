// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

// Parts are locked while their process lives: one that nobody holds was left by a run that was killed. Where files
// cannot be locked, nothing is taken for left.

/// Removes a part that no living process holds.
ORISPLINE_EXPORT void remove_if_left(const std::string& part);

/// Locks a part that was just made. False: another process took it for left in that very moment.
[[nodiscard]] ORISPLINE_EXPORT bool lock_part(std::FILE* file, const std::string& part);

/// Holds the lock of a part whose file is closed. A few hundred at a time; more are not held.
class ORISPLINE_EXPORT PartLock {
 public:
  PartLock() = default;
  /// Of an open file, whose lock stays when that is closed.
  explicit PartLock(std::FILE* file);
  PartLock(PartLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, none)) {}
  PartLock& operator=(PartLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~PartLock();

 private:
  static constexpr int none = -1;
  int descriptor_ = none;
};

}}}  // namespace orispline::io
