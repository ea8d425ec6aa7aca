// SPDX-License-Identifier: Apache-2.0
#include "commands/tasks/tasks_json.hpp"

#include <cmath>

#include <orispline/fields/field_json.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

namespace {

Json words_of(const FieldInfo& field) {
  Json words = Json::array();
  for (const Word& word : field.words) words.push_back({{"word", word.word}, {"sentence", word.sentence}});
  return words;
}

/// null where there is none.
template <class T>
Json or_null(T value, bool is_there) {
  return is_there ? Json(value) : Json(nullptr);
}

Json field_json(const FieldInfo& field, std::string_view name) {
  Json json{{"name", name},
            {"type", name_of(field.type)},
            {"unit", field.quantity ? Json(field.quantity->unit) : Json(nullptr)}};
  if (!field.words.empty()) json["words"] = words_of(field);
  json["absent"] = or_null(field.absent, !field.absent.empty());
  json["sentence"] = field.sentence;
  return json;
}

Json option_json(const FieldInfo& field) {
  Json json = field_json(field, field.name);
  json["default"] = default_json(field);
  json["lowest"] = or_null(field.range.lowest, std::isfinite(field.range.lowest));
  json["highest"] = or_null(field.range.highest, std::isfinite(field.range.highest));
  json["range"] = text_of(field.range, nullptr);
  json["required"] = field.is_required;
  return json;
}

Json results_json(const std::vector<FieldInfo>& fields) {
  Json results = Json::array();
  for (const FieldInfo& field : fields) results.push_back(field_json(field, name_with_unit(field)));
  return results;
}

}  // namespace

std::string json_of(const std::vector<TaskInfo>& tasks) {
  Json list = Json::array();
  for (const TaskInfo& task : tasks) {
    Json options = Json::array();
    for (const FieldInfo& field : task.options) options.push_back(option_json(field));
    Json json{{"task", task.name},
              {"sentence", task.sentence},
              {"options", std::move(options)},
              {"results", results_json(task.results)}};
    if (!task.results_of_gyros.empty()) json["results_of_gyros"] = results_json(task.results_of_gyros);
    list.push_back(std::move(json));
  }
  return document(list);
}

}  // namespace orispline::cli
