// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <type_traits>

#include <orispline/base/progress.hpp>

namespace orispline::python {

/// Does long work on a thread of its own, while this one leaves the interpreter to others and looks for signals. One
/// that raises, such as Ctrl-C, stops the work.
void run_interruptibly(const std::function<void(const Progress&)>& work);

/// Runs work interruptibly and gives its result.
template <class Work>
auto interruptible(const Work& work) {
  std::optional<std::invoke_result_t<Work, const Progress&>> result;
  run_interruptibly([&](const Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

}  // namespace orispline::python
