// SPDX-License-Identifier: Apache-2.0
#include "output/interruption.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <mutex>
#include <thread>

#include <unistd.h>

#include <orispline/io/output_file.hpp>

namespace orispline::cli {

namespace {

using Place = std::atomic<const char*>;  // a signal handler may touch nothing that locks or allocates
static_assert(Place::is_always_lock_free);

constexpr std::array polite{SIGINT, SIGTERM, SIGHUP};

std::array<Place, 1000> unfinished{};  // null: nothing to remove

std::mutex noting;                 // of the threads that work side by side
std::atomic<int> opening = 0;      // files that may be there without their note
std::atomic<int> postponed = 0;    // the signal that came meanwhile
std::atomic<bool> ending = false;  // no file may come to be any more
static_assert(std::atomic<int>::is_always_lock_free);

bool is_free(const Place& place) { return place.load() == nullptr; }

void remove_and_end(int signal) {
  ending = true;
  if (opening.load() > 0) {  // in another thread
    postponed = signal;
    ending = false;
    return;
  }
  for (const Place& place : unfinished)
    if (const char* path = place.load()) unlink(path);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void watch_interruptions() {
  for (const int signal : polite)
    if (std::signal(signal, remove_and_end) == SIG_IGN)
      std::signal(signal, SIG_IGN);  // as a caller like nohup wants it
}

}  // namespace

InterruptionHeld::InterruptionHeld(const std::string& output) : is_held_(!io::is_stream(output)) {
  if (!is_held_) return;
  sigset_t held;
  sigemptyset(&held);
  for (const int signal : polite) sigaddset(&held, signal);
  pthread_sigmask(SIG_BLOCK, &held, &before_);
  static std::once_flag once;
  std::call_once(once, watch_interruptions);
  for (++opening; ending; ++opening) {  // another thread removes files, and ends the program
    --opening;
    std::this_thread::yield();
  }
}

InterruptionHeld::~InterruptionHeld() {
  if (!is_held_) return;
  --opening;
  if (const int signal = postponed.exchange(0)) std::raise(signal);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

RemovedWhenInterrupted::RemovedWhenInterrupted(const std::string& path) : path_(path) {
  const std::scoped_lock lock(noting);
  const auto place = std::ranges::find_if(unfinished, is_free);
  if (path_.empty() || place == unfinished.end()) return;
  place_ = &*place;
  *place_ = path_.c_str();
}

RemovedWhenInterrupted::~RemovedWhenInterrupted() {
  if (place_ == nullptr) return;
  const std::scoped_lock lock(noting);
  *place_ = nullptr;
}

}  // namespace orispline::cli
