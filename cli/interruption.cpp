// SPDX-License-Identifier: Apache-2.0
#include "interruption.hpp"

#include <array>
#include <climits>
#include <csignal>
#include <cstring>

#include <unistd.h>

namespace orispline::cli {
namespace {

std::array<char, PATH_MAX> unfinished{};  // a signal handler may touch nothing that allocates

void remove_and_end(int signal) {
  unlink(unfinished.data());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void on_interruption(void (*handler)(int)) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);  // as a caller like nohup wants it
}

}  // namespace

RemovedWhenInterrupted::RemovedWhenInterrupted(const std::string& path) {
  if (path.empty() || path.size() >= unfinished.size()) return;
  std::memcpy(unfinished.data(), path.c_str(), path.size() + 1);
  on_interruption(remove_and_end);
}

RemovedWhenInterrupted::~RemovedWhenInterrupted() { on_interruption(SIG_DFL); }

}  // namespace orispline::cli
