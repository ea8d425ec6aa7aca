// SPDX-License-Identifier: Apache-2.0
#include "output/terminal_width.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace orispline::cli {

std::optional<std::size_t> terminal_width() noexcept {
  winsize size{};
  if (!isatty(STDOUT_FILENO) || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

}  // namespace orispline::cli
