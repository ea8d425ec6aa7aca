// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>

namespace orispline::testing_support {

/// Numbers of a field, three by three.
[[nodiscard]] inline std::vector<Eigen::Vector3d> vectors_of(const DataTable::Row& row, std::string_view column) {
  const std::vector<double> values = row.numbers(column);
  std::vector<Eigen::Vector3d> vectors;
  for (std::size_t i = 0; i < values.size(); i += 3)
    vectors.emplace_back(values[i], values.at(i + 1), values.at(i + 2));
  return vectors;
}

/// The keys of a row of golden/cases.csv, with the rates that the case gives them.
[[nodiscard]] inline Keyframes keys_of(const DataTable& keys, const DataTable::Row& row) {
  KeyframeData data{.angular_velocities = vectors_of(row, "key_rates"),
                    .angular_accelerations = vectors_of(row, "key_accelerations"),
                    .angular_jerks = vectors_of(row, "key_jerks")};
  for (const auto& key : keys.rows_where("sequence", row.text("sequence"))) {
    data.times.push_back(key.number("t"));
    data.orientations.push_back(key.quaternion("qw", "qx", "qy", "qz"));
  }
  return Keyframes::make(std::move(data), row.text("signs") == "as_given" ? Signs::as_given : Signs::shortest).value();
}

/// `name=text;name=text…`
[[nodiscard]] inline std::map<std::string, std::string, std::less<>> named_texts(const std::string& field) {
  std::map<std::string, std::string, std::less<>> named;
  if (field.empty()) return named;
  for (const std::string& assignment : fields_of(field, ';')) {
    const auto parts = fields_of(assignment, '=');
    named.emplace(parts.at(0), parts.at(1));
  }
  return named;
}

[[nodiscard]] inline End end_of(const DataTable::Row& row, std::string_view rate_column) {
  if (row.text("ends").empty()) return {};
  End end{.rule = end_rule_by_name(*find_family(row.text("family")).value(), row.text("ends")).value()};
  if (const auto rate = vectors_of(row, rate_column); !rate.empty()) end.angular_velocity = rate.front();
  return end;
}

/// What a row of golden/cases.csv asks of its family.
[[nodiscard]] inline CurveOptions options_of(const DataTable::Row& row) {
  CurveOptions options{
      .choices = named_texts(row.text("choices")), .start = end_of(row, "start_rate"), .end = end_of(row, "end_rate")};
  for (const auto& [name, values] : named_texts(row.text("parameters")))
    for (const std::string& value : fields_of(values, ' ')) options.parameters[name].push_back(number_of(value));
  if (!row.text("period").empty()) options.loop = Loop{.period = row.number("period")};
  return options;
}

/// What a failed assertion says of the case.
[[nodiscard]] inline std::string label_of(const DataTable::Row& row) {
  return row.text("family") + " on " + row.text("sequence") + ", " + row.text("signs") + " signs, ends '" +
         row.text("ends") + "', choices '" + row.text("choices") + "', parameters '" + row.text("parameters") + "'";
}

}  // namespace orispline::testing_support
