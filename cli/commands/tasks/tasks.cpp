// SPDX-License-Identifier: Apache-2.0
#include "commands/tasks/tasks.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/jobs/task_list.hpp>

#include "output/json_document.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

constexpr std::size_t name_width = 31, type_width = 18;

/// ` [acceleration]`, what holds where nothing is stated.
std::string standing(const FieldInfo& field) {
  std::string text(field.absent);
  if (text.empty() && !field.is_required) text = text_of(field.initial());
  return text.empty() || field.type == FieldType::symmetric_matrix ? "" : formatted(" [{}]", text);
}

std::string lines_of(const FieldInfo& field, std::string_view name, std::string_view standing) {
  std::string lines =
      formatted("  {:{}}{:{}}{}{}\n", name, name_width, name_of(field.type), type_width, field.sentence, standing);
  for (const Word& word : field.words)
    lines += formatted("  {:{}}{:{}}{}\n", "", name_width, word.word, type_width, word.sentence);
  return lines;
}

std::string lines_of_option(const FieldInfo& field) {
  const std::string unit = field.quantity ? formatted(" [{}]", field.quantity->unit) : "";
  return lines_of(field, formatted("{}{}", field.name, unit), standing(field));
}

std::string lines_of_results(const std::vector<FieldInfo>& results, std::string_view head) {
  std::string text = results.empty() ? "" : formatted("  {}\n", head);
  for (const FieldInfo& field : results)
    text += lines_of(field, name_with_unit(field), field.absent.empty() ? "" : formatted(" [{}]", field.absent));
  return text;
}

std::string text_of(const jobs::TaskInfo& task) {
  std::string text = formatted("{}: {}\n", task.name, task.sentence);
  for (const FieldInfo& field : task.options) text += lines_of_option(field);
  if (!task.on_scene.options.empty()) text += "  options where the input is a skeleton\n";
  for (const FieldInfo& field : task.on_scene.options) text += lines_of_option(field);
  return text + lines_of_results(task.results, "results") +
         lines_of_results(task.results_of_gyros, "results where a recording is of a gyro") + "\n";
}

}  // namespace

Expected<void> tasks(const TasksArguments& options) {
  const auto tasks = jobs::tasks_info();
  if (options.json) return print_document(document(jobs::tasks_json()));
  std::string text;
  for (const jobs::TaskInfo& task : tasks) text += text_of(task);
  return print_document(text);
}

}  // namespace orispline::cli
