// SPDX-License-Identifier: Apache-2.0
#include "output/progress.hpp"

#include <limits>

#include <unistd.h>

#include "output/gathered_output.hpp"
#include "output/standard_output.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

namespace {

constexpr std::size_t steps_between_looks = 4096;  // reading the clock costs more than a sample
constexpr std::size_t bar_width = 40;

}  // namespace

Progress::Progress(std::size_t total, Show show)
    : total_(total),
      next_look_(show == Show::on_terminal && !gathered_here() && isatty(STDERR_FILENO)
                     ? steps_between_looks
                     : std::numeric_limits<std::size_t>::max()),
      next_draw_(Clock::now() + std::chrono::seconds(1)) {}

Progress::~Progress() {
  if (state_ == State::shown) tell(formatted("\r{:{}}\r", "", bar_width + 10));
}

void Progress::look(std::size_t done) {
  next_look_ = done + steps_between_looks;
  if (Clock::now() < next_draw_) return;
  next_draw_ = Clock::now() + std::chrono::milliseconds(100);
  state_ = State::shown;
  const double part = static_cast<double>(done) / static_cast<double>(total_);
  const auto filled = static_cast<std::size_t>(part * bar_width);
  tell(formatted("\r[{:#<{}}{:{}}] {:3.0f} %", "", filled, "", bar_width - filled, 100.0 * part));
}

}  // namespace orispline::cli
