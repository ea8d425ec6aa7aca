// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <orispline/base/progress.hpp>
#include <orispline/base/stop_token.hpp>

#include "orispline.h"

namespace orispline::c {

/// A function of C that is shown the progress of a task and may stop it; null: nobody is.
[[nodiscard]] inline Progress progress_by(orispline_progress function, void* context) {
  if (!function) return {};
  const auto source = std::make_shared<StopSource>();
  return {.stop = source->get_token(), .show = [function, context, source](double share) {
            if (function(share, context) != 0) source->request_stop();
          }};
}

}  // namespace orispline::c
