// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace orispline::testing_support {

/// How many allocations of operator new, which this executable replaces, were not freed yet.
[[nodiscard]] long live_allocations() noexcept;

}  // namespace orispline::testing_support
