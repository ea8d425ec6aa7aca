// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/method_json.hpp>

#include <utility>

#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/setting_quantity.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Json unit_json(const Quantity* quantity) { return quantity ? Json(quantity->unit) : Json(nullptr); }

Json parameters_of(const FamilyInfo& family) {
  Json parameters = Json::array();
  for (const Parameter& p : family.parameters)
    parameters.push_back({{"name", p.name},
                          {"default", p.initial},
                          {"min", p.lowest},
                          {"max", p.highest},
                          {"per_key", p.per_key},
                          {"ghosts", p.ghosts},
                          {"tensor", p.tensor},
                          {"unit", unit_json(quantity_of_setting(p.name))}});
  return parameters;
}

Json choices_of(const FamilyInfo& family) {
  Json choices = Json::array();
  for (const auto& [name, words] : family.choices)
    choices.push_back({{"name", name}, {"default", words.front()}, {"words", words}});
  return choices;
}

Json ends_json(const FamilyInfo& family) {
  Json ends = Json::array();
  for (const EndRule rule : family.ends) ends.push_back(name_of(rule));
  return ends;
}

/// What was found of a family of one's own, or nothing.
Json findings_json(const FamilyInfo& family) {
  Json findings = Json::array();
  for (const BlendingFinding& found : findings_of(family))
    findings.push_back({{"promise", promise_name(found.promise)},
                        {"order", found.order},
                        {"why", found.why},
                        {"where", found.where},
                        {"provided", found.provided},
                        {"sentence", sentence_of(found)}});
  return findings;
}

Json inner_json(const FamilyInfo& family) {
  const auto& order = family.order_with_inner_quaternions;
  return order ? Json(*order) : Json(nullptr);
}

Json method_json(const FamilyInfo& family) {
  Json json = {{"name", family.name},
               {"title", family.title},
               {"source", family.source},
               {"interpolates", family.interpolates},
               {"continuity_uniform", family.continuity_uniform},
               {"continuity_uneven", family.continuity_uneven},
               {"continuity_of_shape", family.shape_order()},
               {"keeps_constant_rate_uniform", family.keeps_constant_rate_uniform},
               {"keeps_constant_rate_uneven", family.keeps_constant_rate_uneven},
               {"support_keys", family.support_keys == all_keys ? Json(nullptr) : Json(family.support_keys)},
               {"min_keys", family.min_keys},
               {"closes", family.closes},
               {"rate_orders", family.rate_orders},
               {"order_with_inner_quaternions", inner_json(family)},
               {"parameters", parameters_of(family)},
               {"choices", choices_of(family)},
               {"ends", ends_json(family)}};
  if (family.own) json["findings"] = findings_json(family);
  return json;
}

}  // namespace

Json methods_json(std::span<const FamilyInfo> families) {
  Json list = Json::array();
  for (const FamilyInfo& family : families) list.push_back(method_json(family));
  return list;
}

}}  // namespace orispline
