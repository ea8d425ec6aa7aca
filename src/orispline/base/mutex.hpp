// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

#ifdef __STDCPP_THREADS__
using Mutex = std::mutex;
#else
/// Of a program that has one thread, which nobody waits for.
struct Mutex {
  void lock() noexcept {}
  void unlock() noexcept {}
};
#endif

}}  // namespace orispline
