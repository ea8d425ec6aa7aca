// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/suggestion.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/task_list.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

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

Json options_json(const std::vector<FieldInfo>& fields) {
  Json options = Json::array();
  for (const FieldInfo& field : fields) options.push_back(option_json(field));
  return options;
}

Json kinds_of(const TaskKinds& takes) {
  Json kinds = Json::array();
  if (takes.tracks) kinds.push_back("keys");
  if (takes.gyros) kinds.push_back("rates");
  if (takes.scenes) kinds.push_back("skeleton");
  return kinds;
}

Json task_json(const TaskInfo& task) {
  Json inputs = Json::array(), settings = Json::array();
  for (const TaskInput& input : task.inputs)
    inputs.push_back({{"name", input.name},
                      {"sentence", input.sentence},
                      {"required", input.is_required},
                      {"several", input.takes_several},
                      {"kinds", kinds_of(input.takes)}});
  for (const TaskSetting& setting : task.settings)
    settings.push_back({{"name", setting.name}, {"sentence", setting.sentence}});
  Json json{{"task", task.name},
            {"sentence", task.sentence},
            {"options", options_json(task.options)},
            {"results", results_json(task.results)},
            {"inputs", std::move(inputs)},
            {"settings", std::move(settings)}};
  if (!task.results_of_gyros.empty()) json["results_of_gyros"] = results_json(task.results_of_gyros);
  if (!task.on_scene.options.empty()) json["options_of_skeletons"] = options_json(task.on_scene.options);
  return json;
}

/// What is named must be there, and stand as often as it may.
Expected<void> check_names(std::string_view kind, const std::vector<std::string_view>& stated,
                           const std::vector<std::string_view>& known, const std::vector<std::string_view>& repeated) {
  for (const std::string_view name : stated) {
    if (std::ranges::find(known, name) == known.end()) return bad_option(name, unknown_word(kind, name, known));
    if (std::ranges::count(stated, name) > 1 && std::ranges::find(repeated, name) == repeated.end())
      return bad_option(name, "found it twice, wanted it once");
  }
  return {};
}

template <class List>
std::vector<std::string_view> names_in(const List& stated) {
  std::vector<std::string_view> names;
  for (const auto& [name, value] : stated) names.push_back(name);
  return names;
}

/// `orientations at times, or a skeleton`
std::string wanted_kinds(const TaskKinds& takes) {
  std::vector<std::string_view> kinds;
  if (takes.tracks) kinds.emplace_back("orientations at times");
  if (takes.gyros) kinds.emplace_back("the rates of a gyro");
  if (takes.scenes) kinds.emplace_back("the clips of a skeleton");
  return joined(kinds, " or ");
}

std::string_view name_of(const TaskValue& value) {
  constexpr std::array names{"orientations at times", "the rates of a gyro", "the clips of a skeleton"};
  return names[value.index()];
}

bool takes(const TaskKinds& kinds, const TaskValue& value) {
  return std::array{kinds.tracks, kinds.gyros, kinds.scenes}[value.index()];
}

Expected<void> check_inputs(const TaskInfo& task, const TaskRequest& request) {
  std::vector<std::string_view> known, repeated;
  for (const TaskInput& input : task.inputs) {
    known.push_back(input.name);
    if (input.takes_several) repeated.push_back(input.name);
  }
  if (auto fits = check_names("input", names_in(request.inputs), known, repeated); !fits) return fits;
  for (const TaskInput& input : task.inputs) {
    if (input.is_required && !request.value(input.name))
      return bad_option(input.name, "found none, wanted " + wanted_kinds(input.takes));
    for (const auto& [name, value] : request.inputs)
      if (name == input.name && !takes(input.takes, value))
        return bad_option(name, formatted("found {}, wanted {}", name_of(value), wanted_kinds(input.takes)));
  }
  return {};
}

bool runs_on_scene(const TaskInfo& task, const TaskRequest& request) { return task.on_scene.run && has_scene(request); }

Expected<void> check_options(const TaskInfo& task, const TaskRequest& request) {
  const std::vector<FieldInfo>& options = options_for(task, request);
  std::vector<std::string_view> known;
  for (const FieldInfo& field : options)
    if (field.type != FieldType::recording) known.push_back(field.name);
  for (const TaskSetting& setting : task.settings) known.push_back(setting.name);
  if (auto fits = check_names("option", names_in(request.options), known, {}); !fits) return fits;
  for (const FieldInfo& field : options)
    if (field.is_required && !request.stated(field.name))
      return bad_option(field.name, "found none, wanted " + wanted_of(field));
  return {};
}

}  // namespace

Json tasks_json() {
  Json list = Json::array();
  for (const TaskInfo& task : tasks_info()) list.push_back(task_json(task));
  return list;
}

const TaskValue* TaskRequest::value(std::string_view name) const {
  for (const auto& [known, value] : inputs)
    if (known == name) return &value;
  return nullptr;
}

std::shared_ptr<const Track> TaskRequest::input(std::string_view name) const {
  const TaskValue* const found = value(name);
  const auto* const track = found ? std::get_if<std::shared_ptr<const Track>>(found) : nullptr;
  return track ? *track : nullptr;
}

const FieldValue* TaskRequest::stated(std::string_view name) const {
  for (const auto& [known, value] : options)
    if (known == name) return &value;
  return nullptr;
}

const std::string* TaskRequest::option(std::string_view name) const {
  const FieldValue* const found = stated(name);
  return found ? std::get_if<std::string>(found) : nullptr;
}

bool has_scene(const TaskRequest& request) {
  return std::ranges::any_of(request.inputs, [](const auto& input) {
    return std::holds_alternative<std::shared_ptr<const MotionFile>>(input.second);
  });
}

Expected<const TaskInfo*> task_named(std::string_view name) {
  static const std::vector<TaskInfo> tasks = tasks_info();  // which takes as long to make as a short task
  std::vector<std::string_view> names;
  for (const TaskInfo& task : tasks) {
    if (task.name == name) return &task;
    names.push_back(task.name);
  }
  return failure(ErrorCode::bad_argument, unknown_word("task", name, names));
}

const std::vector<FieldInfo>& options_for(const TaskInfo& task, const TaskRequest& request) {
  return has_scene(request) && !task.on_scene.options.empty() ? task.on_scene.options : task.options;
}

Expected<void> check_task(std::string_view name, const TaskRequest& request) {
  return task_named(name).and_then([&](const TaskInfo* task) {
    const auto check = runs_on_scene(*task, request) ? task->on_scene.check : task->check;
    return check_options(*task, request).and_then([&] { return check ? check(request) : Expected<void>(); });
  });
}

Expected<TaskOutcome> run_task(std::string_view name, const TaskRequest& request, const Progress& progress) {
  return task_named(name).and_then([&](const TaskInfo* task) {
    const auto run = runs_on_scene(*task, request) ? task->on_scene.run : task->run;
    return check_inputs(*task, request).and_then([&] { return check_options(*task, request); }).and_then([&] {
      return run(request, progress);
    });
  });
}

}}}  // namespace orispline::jobs
