// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace orispline::cli {

/// While it lives, Ctrl-C and a polite kill remove the file that is being written before they end the command.
class RemovedWhenInterrupted {
 public:
  /// `path` may be empty: nothing to remove. Two at a time.
  explicit RemovedWhenInterrupted(const std::string& path);
  ~RemovedWhenInterrupted();
  RemovedWhenInterrupted(const RemovedWhenInterrupted&) = delete;
  RemovedWhenInterrupted& operator=(const RemovedWhenInterrupted&) = delete;

 private:
  char* place_ = nullptr;  // of the path; none where there is nothing to remove
};

}  // namespace orispline::cli
