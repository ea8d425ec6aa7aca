// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include <orispline/scenes.hpp>

namespace orispline::python {

/// A scene as Python holds it: shared, for it never changes.
struct SharedScene {
  std::shared_ptr<const scenes::Scene> scene;

  explicit SharedScene(scenes::Scene made) : scene(std::make_shared<const scenes::Scene>(std::move(made))) {}
};

}  // namespace orispline::python
