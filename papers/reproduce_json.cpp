// SPDX-License-Identifier: Apache-2.0
#include "papers/reproduce_report.hpp"

#include <string_view>

#include <orispline/fields/json.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

namespace {

/// A column of what the paper prints is a word: `paper: time [s]` is `paper_time_s`.
std::string json_name(std::string_view column) {
  if (!column.starts_with("paper")) return std::string(column);
  std::string name;
  for (const char c : column) {
    if (c >= 'A' && c <= 'Z') name += static_cast<char>(c - 'A' + 'a');
    else if (c >= 'a' && c <= 'z') name += c;
    else if (!name.ends_with('_')) name += '_';
  }
  return name.ends_with('_') ? name.substr(0, name.size() - 1) : name;
}

Json table(const report::Table& table) {
  Json columns = Json::array(), rows = Json::array();
  for (const report::Column& column : table.columns) columns.push_back(json_name(column.name));
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const report::Cell& cell : row) std::visit([&](const auto& value) { cells.push_back(value); }, cell);
    rows.push_back(std::move(cells));
  }
  return {{"title", table.title}, {"columns", columns}, {"rows", rows}, {"notes", table.notes}};
}

Json numbers(const Eigen::Vector3d& v) { return std::vector<double>{v.x(), v.y(), v.z()}; }
Json numbers(const Eigen::Quaterniond& q) { return std::vector<double>{q.w(), q.x(), q.y(), q.z()}; }

Json chart(const report::Chart& chart) {
  Json series = Json::array(), marks = Json::array();
  for (const report::Series& s : chart.series) series.push_back(Json{{"label", s.label}, {"x", s.x}, {"y", s.y}});
  for (const report::Mark& mark : chart.marks) marks.push_back(mark.x);
  return {{"title", chart.title}, {"series", series}, {"marks", marks}};
}

Json sphere(const report::SpherePicture& sphere) {
  Json paths = Json::array(), dots = Json::array();
  for (const report::SpherePath& path : sphere.paths) {
    Json directions = Json::array();
    for (const Eigen::Vector3d& direction : path.directions) directions.push_back(numbers(direction));
    paths.push_back(Json{{"label", path.label}, {"directions", directions}});
  }
  for (const report::SphereDot& dot : sphere.dots)
    dots.push_back(Json{{"label", dot.label}, {"direction", numbers(dot.direction)}});
  return {{"paths", paths}, {"dots", dots}};
}

Json row_of_bodies(const FrameRow& row) {
  Json times = Json::array(), orientations = Json::array();
  for (const Frame& frame : row.frames) {
    times.push_back(frame.t);
    orientations.push_back(numbers(frame.orientation));
  }
  return {{"label", row.label}, {"t", times}, {"q", orientations}};
}

Json drawn(const Picture& picture) {
  Json charts = Json::array(), spheres = Json::array(), rows = Json::array();
  for (const report::Chart& c : picture.charts()) charts.push_back(chart(c));
  for (const report::SpherePicture& s : picture.spheres()) spheres.push_back(sphere(s));
  for (const FrameRow& row : picture.rows()) rows.push_back(row_of_bodies(row));
  return {{"picture", picture.name()}, {"charts", charts}, {"spheres", spheres}, {"bodies", rows}};
}

Json object(const ExperimentReport& report) {
  Json tables = Json::array(), pictures = Json::array();
  for (const report::Table& t : report.findings.tables) tables.push_back(table(t));
  for (const Picture& picture : report.findings.pictures) pictures.push_back(drawn(picture));
  return {{"experiment", report.name},
          {"title", report.title},
          {"tables", tables},
          {"pictures", report.picture_files},
          {"drawn", pictures}};
}

}  // namespace

std::string json_of(std::span<const Experiment> experiments) {
  Json list = Json::array();
  for (const Experiment& experiment : experiments)
    list.push_back(Json{{"experiment", experiment.name},
                        {"name", name_by_author(experiment)},
                        {"title", experiment.title},
                        {"takes_keys", experiment.takes_keys()},
                        {"takes_reference", experiment.run_on != nullptr}});
  return document(list);
}

std::string json_of(const ExperimentReport& report) {
  Json list = Json::array();
  list.push_back(object(report));
  return document(list);
}

std::string json_of(const std::vector<ExperimentReport>& reports) {
  Json list = Json::array();
  for (const ExperimentReport& report : reports) list.push_back(object(report));
  return document(list);
}

std::string files_json_of(const std::vector<ExperimentReport>& reports) {
  Json list = Json::array();
  for (const ExperimentReport& report : reports)
    list.push_back(Json{{"experiment", report.name},
                        {"title", report.title},
                        {"tables", report.table_files},
                        {"pictures", report.picture_files}});
  return document(list);
}

}  // namespace orispline::cli
