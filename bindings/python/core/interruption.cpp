// SPDX-License-Identifier: Apache-2.0
#include "interruption.hpp"

#include <chrono>
#include <future>

#include <nanobind/nanobind.h>

namespace nb = nanobind;

namespace orispline::python {

namespace {

constexpr std::chrono::milliseconds between_looks{20};

}  // namespace

void run_interruptibly(const std::function<void(const Progress&)>& work) {
  StopSource source;
  std::future<void> done = std::async(std::launch::async, [&] { work({.stop = source.get_token()}); });
  const auto is_done = [&] {
    const nb::gil_scoped_release release;
    return done.wait_for(between_looks) == std::future_status::ready;
  };
  while (!is_done()) {
    if (PyErr_CheckSignals() == 0) continue;
    nb::python_error interruption;  // takes what the handler of the signal raised
    source.request_stop();
    {
      const nb::gil_scoped_release release;
      done.wait();
    }
    throw interruption;
  }
  done.get();
}

}  // namespace orispline::python
