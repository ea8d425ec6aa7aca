// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/families/setting_quantity.hpp>

#include "errors.hpp"
#include "keys.hpp"
#include "method_text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

nb::list parameters_of(const FamilyInfo& family) {
  nb::list list;
  for (const Parameter& parameter : family.parameters) {
    nb::dict entry;
    entry["name"] = text(parameter.name);
    entry["default"] = parameter.initial;
    entry["lowest"] = parameter.lowest;
    entry["highest"] = parameter.highest;
    entry["per_key"] = parameter.per_key;
    entry["tensor"] = parameter.tensor;
    entry["tunable"] = parameter.tunable;
    const Quantity* const quantity = quantity_of_setting(parameter.name);
    entry["unit"] = quantity ? nb::object(text(quantity->unit)) : nb::object(nb::none());
    list.append(entry);
  }
  return list;
}

nb::list words_of(std::span<const std::string_view> words) {
  nb::list list;
  for (const std::string_view word : words) list.append(text(word));
  return list;
}

}  // namespace

nb::typed<nb::dict, nb::str, nb::any> info_of(const FamilyInfo& family) {
  nb::typed<nb::dict, nb::str, nb::any> info;
  nb::dict choices;
  for (const Choice& choice : family.choices) choices[text(choice.name)] = words_of(choice.words);
  nb::list ends;
  for (const EndRule rule : family.ends) ends.append(text(name_of(rule)));
  info["name"] = text(family.name);
  info["title"] = text(family.title);
  info["source"] = text(family.source);
  info["interpolates"] = family.interpolates;
  info["continuity_uniform"] = family.continuity_uniform;
  info["continuity_uneven"] = family.continuity_uneven;
  info["continuity_of_shape"] = family.shape_order();
  info["is_local"] = !family.is_global();
  info["min_keys"] = family.min_keys;
  info["parameters"] = parameters_of(family);
  info["choices"] = choices;
  info["ends"] = ends;
  info["closes"] = family.closes;
  info["rate_orders"] = family.rate_orders;
  info["order_with_inner_quaternions"] = family.order_with_inner_quaternions;
  return info;
}

void add_methods(nb::module_& module) {
  module.def("methods", [] {
    nb::typed<nb::list, nb::typed<nb::dict, nb::str, nb::any>> list;
    for (const FamilyInfo& family : families_info()) list.append(info_of(family));
    return list;
  });
  module.def(
      "method_texts",
      [](const std::string& typed, const std::vector<Blending>& blendings) {
        std::vector<std::shared_ptr<const OwnFamily>> own;
        for (const Blending& blending : blendings) own.push_back(blending.family);
        return value_of(method_texts_in(typed, own));
      },
      "typed"_a, "blendings"_a);
}

}  // namespace orispline::python
