// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nanobind/nanobind.h>

#include <orispline/jobs.hpp>
#include <orispline/pages.hpp>

#include "arrays.hpp"
#include "fields.hpp"
#include "keys.hpp"
#include "method_text.hpp"
#include "page_bytes.hpp"

namespace orispline::python {

void add_fields(nanobind::module_& module);
void add_align(nanobind::module_& module);
void add_align_rates(nanobind::module_& module);
void add_smooth(nanobind::module_& module);
void add_reduce(nanobind::module_& module);
void add_retime(nanobind::module_& module);
void add_tune(nanobind::module_& module);
void add_mean(nanobind::module_& module);
void add_compare(nanobind::module_& module);
void add_scenes(nanobind::module_& module);

inline Keys shared(Track track) { return {std::make_shared<const Track>(std::move(track))}; }

/// That of its text, else as jobs::chosen_method() chooses. Raises the library's errors.
jobs::ChosenMethod method_chosen(const std::optional<MethodText>& stated, const Track& keys,
                                 const jobs::UsualMethod& usual);

/// A recording; null where there is none.
inline std::shared_ptr<const Track> reference_in(const std::optional<Keys>& recording) {
  return recording ? recording->track : nullptr;
}

/// As Python's lists have them; quaternions scalar last.
inline std::vector<double> numbers_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline std::vector<double> numbers_of(const Eigen::Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }

/// What there is to say of an outcome of orispline::jobs, whose document is a dict or a list.
template <class Document = nanobind::dict, class Outcome>
void add_words(nanobind::class_<Outcome>& outcome_class) {
  outcome_class.def_prop_ro("warnings", [](const Outcome& outcome) { return warnings_of(outcome.warnings); })
      .def("members", [](const Outcome& outcome) { return nanobind::cast<Document>(object_of(document_of(outcome))); })
      .def("summary", [](const Outcome& outcome) { return shown(summary_of(outcome)); });
}

/// Its page.
template <class Outcome>
void add_page(nanobind::class_<Outcome>& outcome_class) {
  const auto page = [](const Outcome& outcome, const std::string& date) {
    return bytes_of([&] { return report::document(page_of(outcome, pages::PageHead{.date = date})); });
  };
  outcome_class.def("page", page, nanobind::arg("date"));
}

}  // namespace orispline::python
