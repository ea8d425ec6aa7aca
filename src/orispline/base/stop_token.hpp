// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <version>

#ifdef __cpp_lib_jthread
#include <stop_token>
#else
#include <atomic>
#include <memory>
#include <utility>
#endif

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

#ifdef __cpp_lib_jthread

using StopSource = std::stop_source;
using StopToken = std::stop_token;

#else

// Where the standard library has none, such as that of Apple and that of WebAssembly.

/// Whether a stop was asked for. One that no source gave is never asked.
class StopToken {
 public:
  StopToken() noexcept = default;

  [[nodiscard]] bool stop_requested() const noexcept { return asked_ && asked_->load(std::memory_order_acquire); }
  [[nodiscard]] bool stop_possible() const noexcept { return asked_ != nullptr; }

 private:
  friend class StopSource;
  explicit StopToken(std::shared_ptr<const std::atomic<bool> > asked) noexcept : asked_(std::move(asked)) {}

  std::shared_ptr<const std::atomic<bool> > asked_;
};

/// Asks all that hold its tokens for a stop, from any thread. Copies are one source.
class StopSource {
 public:
  [[nodiscard]] StopToken get_token() const noexcept { return StopToken(asked_); }
  [[nodiscard]] bool stop_requested() const noexcept { return asked_->load(std::memory_order_acquire); }
  /// Whether this is the first request.
  bool request_stop() noexcept { return !asked_->exchange(true, std::memory_order_acq_rel); }

 private:
  std::shared_ptr<std::atomic<bool> > asked_ = std::make_shared<std::atomic<bool> >(false);
};

#endif

}}  // namespace orispline
