// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <orispline/jobs/task_list.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "handles.hpp"

namespace orispline::c {

/// What a task takes or has made, as C holds it.
struct Value {
  jobs::TaskValue value;
  std::shared_ptr<const scenes::Scene> file{};  ///< of a skeleton: what its file holds beside it and its clips
};

template <>
struct HandleOf<orispline_value> {
  using Body = Value;
  static constexpr Kind kind = Kind::value;
  static constexpr std::string_view name = "value";
};

}  // namespace orispline::c
