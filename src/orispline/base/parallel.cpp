// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Calls `work` with the numbers that the threads have not yet taken. What it throws ends them all.
class Parts {
 public:
  Parts(std::size_t count, const std::function<void(std::size_t)>& work) : count_(count), work_(work) {}

  void run() noexcept {
    try {
      for (std::size_t i = next_++; i < count_; i = next_++) work_(i);
    } catch (...) {
      next_ = count_;
      if (!has_failed_.test_and_set()) failure_ = std::current_exception();
    }
  }

  /// After all threads are joined.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::atomic_flag has_failed_;
  std::exception_ptr failure_;
};

/// Threads that do parts beside this one, until there are none left. Not of `std::jthread`, which Apple's library
/// lacks.
class Others {
 public:
  /// As many as the system has, up to `count`.
  Others(std::size_t count, Parts& parts) {
    try {
      while (threads_.size() < count) threads_.emplace_back([&parts] { parts.run(); });
    } catch (const std::system_error&) {  // those that there are do the rest
    } catch (const std::bad_alloc&) {
    }
  }
  Others(const Others&) = delete;
  Others& operator=(const Others&) = delete;
  ~Others() {
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  std::vector<std::thread> threads_;
};

}  // namespace

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  Parts parts(count, work);
  {
    const Others others(std::max<std::size_t>(1, std::min<std::size_t>(threads, count)) - 1, parts);
    parts.run();
  }
  parts.rethrow();
}

}}  // namespace orispline
