// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/jobs.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

using jobs::CompareOutcome;
using Decimations = std::vector<nb::typed<nb::dict, nb::str, nb::any>>;

std::vector<Decimation> decimations_in(const Decimations& stated) {
  std::vector<Decimation> decimations;
  for (const nb::dict& one : stated) {
    decimations.push_back(options_in<Decimation>(one));
    value_of(check_ranges(decimations.back()));
  }
  return decimations;
}

std::vector<jobs::LabelledMethod> methods_in(const std::vector<MethodText>& texts) {
  std::vector<jobs::LabelledMethod> methods;
  for (const MethodText& one : texts) methods.push_back({one.words, one.method()});
  return methods;
}

std::vector<std::string> words_of(const std::vector<MethodText>& texts) {
  std::vector<std::string> words;
  for (const MethodText& one : texts) words.push_back(one.words);
  return words;
}

CompareOutcome compared(const Keys& keys, const std::optional<Keys>& reference, bool align,
                        const Decimations& decimations, const std::optional<std::vector<MethodText>>& texts, bool tune,
                        const std::string& sort, const nb::dict& measured, unsigned threads) {
  jobs::CompareRequest request{
      .keys = keys.track,
      .reference = reference_in(reference),
      .decimations = decimations_in(decimations),
      .methods = texts ? methods_in(*texts) : jobs::all_methods(),
      .named = texts ? words_of(*texts) : std::vector<std::string>(),
      .tune = tune,
      .align = align,
      .measured = options_in<MeasureOptions>(measured),
      .has_inertia = measured.contains("inertia") && !nb::object(measured["inertia"]).is_none(),
      .sort = sort,
      .threads = threads};
  return value_of(interruptible([&](const Progress& progress) { return jobs::compare(std::move(request), progress); }));
}

nb::list infos_of(const CompareOutcome& outcome) {
  nb::list infos;
  for (const MeasureInfo& measure : outcome.measures()) {
    nb::dict info;
    info["id"] = text(measure.id);
    info["word"] = text(measure.word);
    info["label"] = text(measure.label);
    info["unit"] = text(measure.unit);
    info["explanation"] = text(measure.explanation);
    infos.append(info);
  }
  return infos;
}

/// The text of each row's method, with the values that were tuned.
std::vector<MethodText> texts_of(const CompareOutcome& outcome) {
  std::vector<MethodText> texts;
  for (const ComparedMethod& method : outcome.methods) texts.push_back(MethodText::of(method.candidate.method));
  return texts;
}

}  // namespace

void add_compare(nb::module_& module) {
  auto outcome_class = nb::class_<CompareOutcome>(module, "Comparison");
  outcome_class.def("measures", &infos_of)
      .def("texts", &texts_of)
      .def_prop_ro("alignment", [](const CompareOutcome& outcome) { return outcome.alignment; })
      .def("keys_of", [](const CompareOutcome& outcome, std::size_t row) {
        return shared(outcome.data.key_sets[outcome.methods.at(row).key_set].track);
      });
  add_words<nb::list>(outcome_class);
  add_page(outcome_class);
  module.def("compare", &compared, "keys"_a, "reference"_a.none(), "align"_a, "decimations"_a, "methods"_a.none(),
             "tune"_a, "sort"_a, "measured"_a, "threads"_a);
}

}  // namespace orispline::python
