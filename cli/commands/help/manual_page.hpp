// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "options/command.hpp"

namespace orispline::cli {

/// A page for `man`, from what the program and its commands say about themselves. It has no date: the version in its
/// foot says how old it is, and two builds have the same pages.
struct ManualPage {
  std::string name;  ///< `orispline-sample`
  std::string text;
};

/// Of the program, then of every command.
[[nodiscard]] std::vector<ManualPage> manual_pages(const Program& program, const std::deque<Command>& commands);

}  // namespace orispline::cli
