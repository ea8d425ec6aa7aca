// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>

#include <orispline/base/expected.hpp>
#include <orispline/base/stop_token.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a caller follows a task that may take long, and ends it before it is done.
///
/// Any thread may ask the source of `stop` for a stop; the task then returns `ErrorCode::cancelled` soon and has
/// changed nothing. `show` is called with the share of the work that is done, from 0 to 1, which does not go back; from
/// one thread at a time, not always the caller's. It must not throw.
struct Progress {
  StopToken stop{};
  std::function<void(double share)> show{};

  [[nodiscard]] bool stopped() const noexcept { return stop.stop_requested(); }
  void at(double share) const {
    if (show) show(share);
  }
};

/// Work of which nobody knows beforehand how much there is, such as that of an iteration: every piece takes its share
/// of what is left, so that the share that is shown rises all the time and is 1 only where the task says that it is
/// done.
class OpenEndedWork {
 public:
  /// `expected`: of most tasks, in the unit of the pieces.
  OpenEndedWork(Progress progress, double expected) : progress_(std::move(progress)), expected_(expected) {}

  [[nodiscard]] bool stopped() const noexcept { return progress_.stopped(); }
  void add(double piece) {
    left_ *= expected_ / (expected_ + piece);
    progress_.at(1.0 - left_);
  }
  void finish() const { progress_.at(1.0); }

 private:
  Progress progress_;
  double expected_, left_ = 1.0;
};

/// The failure of a task that was asked to stop.
[[nodiscard]] inline tl::unexpected<Error> cancellation() {
  return failure(ErrorCode::cancelled, "stopped before it was done");
}

}}  // namespace orispline
