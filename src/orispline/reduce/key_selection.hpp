// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/reduce/key_removal.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Few samples that are keys of a curve within the tolerance.
///
/// Insertion: in every round the worst sample of every segment that breaks the tolerance, from the two ends on. Then
/// pruning: keys that the curve can do without are taken out. Then exchange: two keys for one, by taking out a key and
/// moving its neighbours to other samples by fixed shares of the gap.
[[nodiscard]] Expected<KeySet> selected_keys(const LocalMethod& method, const ToleranceCheck& recording);

}}  // namespace orispline
