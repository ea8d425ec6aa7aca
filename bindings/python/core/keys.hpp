// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <nanobind/nanobind.h>

#include <orispline/curve/track.hpp>

namespace orispline::python {

/// Keyframes as Python holds them: shared, for they never change.
struct Keys {
  std::shared_ptr<const Track> track;
};

/// The error with its place in the file of the keys, unless the caller alone is at fault. `has_columns`: columns of the
/// file bring settings along.
[[nodiscard]] Error placed(const Track& track, bool has_columns, Error error);

void add_keys(nanobind::module_& module);
void add_curve(nanobind::module_& module);
void add_methods(nanobind::module_& module);
void add_blending(nanobind::module_& module);
void add_online(nanobind::module_& module);
void add_stack(nanobind::module_& module);
void add_tracks(nanobind::module_& module);
void add_files(nanobind::module_& module);
void add_fields(nanobind::module_& module);
void add_tasks(nanobind::module_& module);
void add_scenes(nanobind::module_& module);

}  // namespace orispline::python
