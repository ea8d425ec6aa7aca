// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <future>
#include <stop_token>

#include <nanobind/nanobind.h>

#include <orispline/base/progress.hpp>

#include "errors.hpp"

namespace orispline::python {

/// The value of work that may take long, `Expected<T> work(const Progress&)`, without the GIL on a thread of its own.
/// Ctrl-C stops it and raises KeyboardInterrupt.
template <class Work>
auto interruptible(Work work) {
  constexpr std::chrono::milliseconds between_looks{50};
  std::stop_source source;
  auto running = std::async(std::launch::async, [&] { return work(Progress{.stop = source.get_token()}); });
  for (;;) {
    {
      const nanobind::gil_scoped_release release;
      if (running.wait_for(between_looks) == std::future_status::ready) break;
    }
    if (PyErr_CheckSignals() == 0) continue;
    source.request_stop();
    const nanobind::gil_scoped_release release;
    running.wait();
    break;
  }
  if (PyErr_Occurred() != nullptr) throw nanobind::python_error();
  return value_of(running.get());
}

}  // namespace orispline::python
