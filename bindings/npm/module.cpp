// SPDX-License-Identifier: Apache-2.0
// A module is what is linked: the C interface, as far as its functions are named.
#include "orispline.h"

extern "C" {
/// What the script is told of a task, as an orispline_progress.
[[clang::import_module("orispline"), clang::import_name("progress")]] int32_t orispline_npm_progress(double share,
                                                                                                     void* context);

/// That function as an address, which the script cannot make.
[[clang::export_name("orispline_npm_progress_address")]] orispline_progress orispline_npm_progress_address() {
  return orispline_npm_progress;
}
}
