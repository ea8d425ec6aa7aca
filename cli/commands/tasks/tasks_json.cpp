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

}  // namespace

std::string json_of(const std::vector<TaskInfo>& tasks) {
  Json list = Json::array();
  for (const TaskInfo& task : tasks) {
    Json options = Json::array(), results = Json::array();
    for (const FieldInfo& field : task.options) options.push_back(option_json(field));
    for (const FieldInfo& field : task.results) results.push_back(field_json(field, name_with_unit(field)));
    list.push_back({{"task", task.name},
                    {"sentence", task.sentence},
                    {"options", std::move(options)},
                    {"results", std::move(results)}});
  }
  return document(list);
}

}  // namespace orispline::cli
