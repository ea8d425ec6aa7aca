// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <csignal>
#include <string>

namespace orispline::cli {

/// While it lives, Ctrl-C and a polite kill wait: so nothing comes between a file and the note of it. Of pipes and
/// devices there is no note, and they may take long to open: there nothing waits.
class InterruptionHeld {
 public:
  explicit InterruptionHeld(const std::string& output);
  ~InterruptionHeld();
  InterruptionHeld(const InterruptionHeld&) = delete;
  InterruptionHeld& operator=(const InterruptionHeld&) = delete;

 private:
  sigset_t before_;
  bool is_held_;
};

/// While it lives, Ctrl-C and a polite kill remove the file that is being written before they end the command.
class RemovedWhenInterrupted {
 public:
  /// `path` may be empty: nothing to remove. A thousand at a time; more are left.
  explicit RemovedWhenInterrupted(const std::string& path);
  ~RemovedWhenInterrupted();
  RemovedWhenInterrupted(const RemovedWhenInterrupted&) = delete;
  RemovedWhenInterrupted& operator=(const RemovedWhenInterrupted&) = delete;

 private:
  std::string path_;
  std::atomic<const char*>* place_ = nullptr;  // where the path is noted; none where there is nothing to remove
};

}  // namespace orispline::cli
