// SPDX-License-Identifier: Apache-2.0
#include "tasks.hpp"

#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>

#include "errors.hpp"

namespace nb = nanobind;

namespace orispline::python {

jobs::ChosenMethod method_chosen(const std::optional<MethodText>& stated, const Track& keys,
                                 const jobs::UsualMethod& usual) {
  const auto named = stated ? std::optional(stated->method()) : std::nullopt;
  return value_of(jobs::chosen_method(named, keys, usual));
}

}  // namespace orispline::python
