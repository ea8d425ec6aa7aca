// SPDX-License-Identifier: Apache-2.0
#include "output/interruption.hpp"

#include <array>
#include <csignal>
#include <mutex>
#include <thread>
#include <vector>

#include <unistd.h>

namespace orispline::cli {

namespace {

// A signal handler may touch nothing that locks or allocates.
static_assert(std::atomic<const char*>::is_always_lock_free && std::atomic<NotedPath*>::is_always_lock_free);

constexpr std::array polite{SIGINT, SIGTERM, SIGHUP};

std::atomic<NotedPath*> notes = nullptr;  // all there ever were, since a handler may be walking along them

std::mutex noting;  // of the threads that work side by side
std::vector<NotedPath*> free_notes;
std::atomic<int> opening = 0;      // files that may be there without their note, or without those beside them
std::atomic<int> postponed = 0;    // the signal that came meanwhile
std::atomic<bool> ending = false;  // no file may come to be any more
static_assert(std::atomic<int>::is_always_lock_free);

/// One that notes nothing yet. Call it with `noting` locked.
NotedPath& free_note() {
  if (free_notes.empty()) {
    free_notes.push_back(new NotedPath{.before = notes.load()});
    notes = free_notes.back();
  }
  NotedPath& note = *free_notes.back();
  free_notes.pop_back();
  return note;
}

void remove_and_end(int signal) {
  ending = true;
  if (opening.load() > 0) {  // in another thread
    postponed = signal;
    ending = false;
    return;
  }
  for (const NotedPath* note = notes.load(); note; note = note->before)
    if (const char* path = note->path.load()) unlink(path);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void watch_interruptions() {
  for (const int signal : polite)
    if (std::signal(signal, remove_and_end) == SIG_IGN)
      std::signal(signal, SIG_IGN);  // as a caller like nohup wants it
}

}  // namespace

InterruptionHeld::InterruptionHeld() {
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
  --opening;
  if (const int signal = postponed.exchange(0)) std::raise(signal);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

RemovedWhenInterrupted::RemovedWhenInterrupted(const std::string& path) : path_(path) {
  if (path_.empty()) return;
  const std::scoped_lock lock(noting);
  note_ = &free_note();
  note_->path = path_.c_str();
}

RemovedWhenInterrupted::~RemovedWhenInterrupted() {
  if (note_ == nullptr) return;
  note_->path = nullptr;
  while (ending) std::this_thread::yield();  // a handler that may have read the path
  const std::scoped_lock lock(noting);
  free_notes.push_back(note_);
}

}  // namespace orispline::cli
