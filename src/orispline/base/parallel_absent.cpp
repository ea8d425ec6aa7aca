// SPDX-License-Identifier: Apache-2.0
// Where a program has one thread.
#include <orispline/base/parallel.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

void parallel_for(std::size_t count, unsigned, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

}}  // namespace orispline
