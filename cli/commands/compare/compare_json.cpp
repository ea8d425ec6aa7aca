// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_report.hpp"

#include "output/json_document.hpp"

namespace orispline::cli {

std::string json_of(const CompareReport& report) {
  Json list = Json::array();
  const auto measures = measures_of(report);
  for (const ComparedMethod& method : report.methods) {
    const ComparedKeys& keys = report.data.key_sets[method.key_set];
    Json json{{"method", method.label},
              {"keep_every", keys.decimation ? Json(keys.decimation->keep_every) : Json(nullptr)},
              {"keys", keys.track.keys.size()},
              {"samples", keys.compared}};
    for (const MeasureInfo& measure : measures) {
      const auto value = value_of(measure, method, report.data);
      json[std::string(measure.id)] = !value                   ? Json(nullptr)
                                      : !measure.order.empty() ? Json(static_cast<int>(*value))
                                                               : Json(*value);
    }
    json["error"] = method.measures ? Json(nullptr) : Json(describe(method.measures.error()));
    list.push_back(std::move(json));
  }
  return document(list);
}

}  // namespace orispline::cli
