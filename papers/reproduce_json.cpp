// SPDX-License-Identifier: Apache-2.0
#include "papers/reproduce_report.hpp"

#include "output/json_document.hpp"

namespace orispline::cli {

namespace {

Json table(const report::Table& table) {
  Json columns = Json::array(), rows = Json::array();
  for (const report::Column& column : table.columns) columns.push_back(column.name);
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const report::Cell& cell : row) std::visit([&](const auto& value) { cells.push_back(value); }, cell);
    rows.push_back(std::move(cells));
  }
  return {{"title", table.title}, {"columns", columns}, {"rows", rows}, {"notes", table.notes}};
}

}  // namespace

std::string json_of(std::span<const Experiment> experiments) {
  Json list = Json::array();
  for (const Experiment& experiment : experiments)
    list.push_back(Json{{"experiment", experiment.name},
                        {"name", name_by_author(experiment)},
                        {"title", experiment.title},
                        {"takes_keys", experiment.run_with != nullptr}});
  return document(list);
}

std::string json_of(const std::vector<ExperimentReport>& reports) {
  Json list = Json::array();
  for (const ExperimentReport& report : reports) {
    Json tables = Json::array();
    for (const report::Table& t : report.findings.tables) tables.push_back(table(t));
    list.push_back(Json{
        {"experiment", report.name}, {"title", report.title}, {"tables", tables}, {"pictures", report.picture_files}});
  }
  return document(list);
}

}  // namespace orispline::cli
