// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace orispline::cli {

/// Asks the desktop to show a file as it is used to, and does not wait for it. Nothing happens without a display, or
/// where the desktop has no program for that.
void open_in_browser(const std::string& path);

}  // namespace orispline::cli
