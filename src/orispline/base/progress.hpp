// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stop_token>

#include <orispline/base/expected.hpp>

namespace orispline {

/// How a caller follows a task that may take long, and ends it before it is done.
///
/// Any thread may ask the source of `stop` for a stop; the task then returns `ErrorCode::cancelled` soon and has
/// changed nothing. `show` is called with the share of the work that is done, from 0 to 1, which does not go back; from
/// one thread at a time, not always the caller's. It must not throw.
struct Progress {
  std::stop_token stop{};
  std::function<void(double share)> show{};

  [[nodiscard]] bool stopped() const noexcept { return stop.stop_requested(); }
  void at(double share) const {
    if (show) show(share);
  }
};

/// The failure of a task that was asked to stop.
[[nodiscard]] inline tl::unexpected<Error> cancellation() {
  return failure(ErrorCode::cancelled, "stopped before it was done");
}

}  // namespace orispline
