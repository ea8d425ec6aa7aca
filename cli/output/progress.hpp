// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>

namespace orispline::cli {

/// A bar on standard error for work that takes more than a second.
class Progress {
 public:
  enum class Show { never, on_terminal };

  Progress(std::size_t total, Show show);
  ~Progress();  ///< wipes the bar away
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance_to(std::size_t done) {
    if (done >= next_look_) look(done);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void look(std::size_t done);

  std::size_t total_;
  std::size_t next_look_;
  Clock::time_point next_draw_;
  enum class State { hidden, shown } state_ = State::hidden;
};

}  // namespace orispline::cli
