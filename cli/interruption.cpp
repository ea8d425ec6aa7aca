// SPDX-License-Identifier: Apache-2.0
#include "interruption.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <csignal>
#include <cstring>

#include <unistd.h>

namespace orispline::cli {
namespace {

using Path = std::array<char, PATH_MAX>;  // a signal handler may touch nothing that allocates

std::array<Path, 2> unfinished{};  // empty: nothing to remove

bool is_free(const Path& path) { return path.front() == '\0'; }

void remove_and_end(int signal) {
  for (const Path& path : unfinished)
    if (!is_free(path)) unlink(path.data());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void on_interruption(void (*handler)(int)) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);  // as a caller like nohup wants it
}

}  // namespace

RemovedWhenInterrupted::RemovedWhenInterrupted(const std::string& path) {
  const auto place = std::ranges::find_if(unfinished, is_free);
  if (path.empty() || place == unfinished.end() || path.size() >= place->size()) return;
  std::memcpy(place->data() + 1, path.c_str() + 1, path.size());
  place->front() = path.front();
  place_ = place->data();
  on_interruption(remove_and_end);
}

RemovedWhenInterrupted::~RemovedWhenInterrupted() {
  if (place_ == nullptr) return;
  *place_ = '\0';
  if (std::ranges::all_of(unfinished, is_free)) on_interruption(SIG_DFL);
}

}  // namespace orispline::cli
