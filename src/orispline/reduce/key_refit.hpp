// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/reduce/key_removal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Takes out more keys where the rest can be moved so that the curve is within the tolerance again.
///
/// A key moves by the mean of what is missed around it, weighted by its hat function and by the squared miss
/// (progressive iterative approximation: Deng and Lin, Computer-Aided Design 47, 2014, with weights of our own), which
/// needs no derivatives. The times of the keys stay. The curve is within the tolerance before and after.
[[nodiscard]] Expected<KeySet> with_keys_refitted(const LocalMethod& method, const ToleranceCheck& recording,
                                                  KeySet keys);

}}  // namespace orispline
