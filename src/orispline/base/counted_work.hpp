// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <orispline/base/mutex.hpp>
#include <orispline/base/progress.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Work of so many parts, which any threads may do: each shows the share that is done with it.
class CountedWork {
 public:
  CountedWork(const Progress& progress, std::size_t parts) : progress_(progress), parts_(parts) {}

  void add_part() {
    const std::lock_guard one_at_a_time(showing_);
    progress_.at(static_cast<double>(++done_) / static_cast<double>(parts_));
  }

 private:
  const Progress& progress_;
  std::size_t parts_, done_ = 0;
  Mutex showing_;
};

}}  // namespace orispline
