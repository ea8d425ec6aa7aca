// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <csignal>
#include <string>

namespace orispline::cli {

/// While it lives, Ctrl-C and a polite kill wait: so nothing comes between a file and the note of it, or between
/// outputs that appear all or none. Not for what may take long, as opening a pipe does.
class InterruptionHeld {
 public:
  InterruptionHeld();
  ~InterruptionHeld();
  InterruptionHeld(const InterruptionHeld&) = delete;
  InterruptionHeld& operator=(const InterruptionHeld&) = delete;

 private:
  sigset_t before_;
};

/// The path of a file that an interruption removes; null: none. Notes make a list, the last one first.
struct NotedPath {
  std::atomic<const char*> path{nullptr};
  NotedPath* const before;
};

/// While it lives, Ctrl-C and a polite kill remove the file that is being written before they end the command.
class RemovedWhenInterrupted {
 public:
  /// `path` may be empty: nothing to remove.
  explicit RemovedWhenInterrupted(const std::string& path);
  ~RemovedWhenInterrupted();
  RemovedWhenInterrupted(const RemovedWhenInterrupted&) = delete;
  RemovedWhenInterrupted& operator=(const RemovedWhenInterrupted&) = delete;

 private:
  std::string path_;
  NotedPath* note_ = nullptr;
};

}  // namespace orispline::cli
