// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nanobind/nanobind.h>

#include <orispline/families/method_text.hpp>
#include <orispline/pages.hpp>

#include "arrays.hpp"
#include "fields.hpp"
#include "keys.hpp"

namespace orispline::python {

void add_fields(nanobind::module_& module);
void add_smooth(nanobind::module_& module);
void add_reduce(nanobind::module_& module);
void add_retime(nanobind::module_& module);
void add_tune(nanobind::module_& module);
void add_compare(nanobind::module_& module);
void add_scenes(nanobind::module_& module);

/// What a task made of keys.
template <class Result>
struct TaskResult {
  Keys given;
  Result result;

  [[nodiscard]] const Track& track() const { return *given.track; }
};

inline Keys shared(Track track) { return {std::make_shared<const Track>(std::move(track))}; }

/// That of its text, else the one that the keys are for if it fits, else the usual one. Raises the library's errors.
Method method_for(const std::optional<std::string>& stated, const Track& track, std::string_view usual,
                  bool (*fits)(const FamilyInfo&));

/// The same keys at other times [s], where some are given.
Track at_times(const Keys& keys, const std::optional<Numbers>& times);

/// Writes a page as a file, complete or not at all. Raises AccessError.
void write_page(const std::string& path, const report::Page& page);

}  // namespace orispline::python
