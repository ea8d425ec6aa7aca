// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <orispline/optimise/recording.hpp>

namespace orispline::optimise {

/// A local method, as far as it concerns the search for keys: moving a key changes `reach` segments on either side.
struct LocalMethod {
  std::string_view name;
  std::size_t reach;
};

/// Adds keys until the curve is within the tolerance: in every round the worst sample of every segment that breaks it.
[[nodiscard]] Expected<KeySet> with_keys_added(const LocalMethod& method, const Recording& recording, KeySet keys);

/// Takes out keys that the curve can do without, until there are none: many at once, so far apart that no segment feels
/// two of them. The curve is within the tolerance before and after.
[[nodiscard]] Expected<KeySet> with_keys_pruned(const LocalMethod& method, const Recording& recording, KeySet keys);

}  // namespace orispline::optimise
