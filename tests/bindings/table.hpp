// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

// The table of requests as a program of one of the bindings reads it, and what it found as it writes it.
// docs/testing.md.

namespace orispline::bindings_table {

using Json = nlohmann::json;

/// An input of a request: a file of keys, of the rates of a gyro, or of a skeleton.
struct Input {
  std::string name, kind, file, bytes;
};

/// The rates of a gyro that a table holds.
struct Rates {
  std::vector<double> times, rates;
};

inline Rates rates_in(const std::string& table) {
  Rates found;
  std::istringstream rows(table);
  std::string row;
  std::getline(rows, row);  // the header
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    std::string cell;
    for (int column = 0; std::getline(cells, cell, ','); ++column)
      (column == 0 ? found.times : found.rates).push_back(std::stod(cell));
  }
  return found;
}

struct Request {
  std::string task;
  std::vector<Input> inputs;
  std::vector<std::pair<std::string, std::string>> options;
};

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// `folder`: of the files that the table names.
inline Request request_of(const Json& row, const Json& files, const std::string& folder) {
  Request request{row["task"], {}, {}};
  for (const auto& input : row["inputs"]) {
    const std::string file = input[1];
    request.inputs.push_back({input[0], files[file], file, bytes_of(folder + "/" + file)});
  }
  for (const auto& [name, text] : row["options"].items()) request.options.emplace_back(name, text);
  return request;
}

/// Runs all requests: `run(request)` gives what was found as JSON.
template <class Run>
int run_table(int count, char** arguments, Run run) {
  if (count != 3) return 2;
  const Json table = Json::parse(bytes_of(arguments[1]));
  for (const Json& row : table["requests"])
    std::cout << run(request_of(row, table["files"], arguments[2])).dump() << '\n';
  return std::cout.good() ? 0 : 1;
}

}  // namespace orispline::bindings_table
