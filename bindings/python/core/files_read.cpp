// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <orispline/families/registry.hpp>
#include <orispline/jobs/curve_of_keys.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "files.hpp"
#include "keys.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

Error in_words(Error error) {
  if (const auto* const fault = io::reading_option_of(error.option)) error.option = fault->name;
  const auto* const remedy = io::reading_option_of(error.remedy);
  if (!remedy) return error;
  error.message += " (" + std::string(remedy->name) + "=";
  error.message += remedy->is_repeated ? "..." : remedy->argument ? remedy->argument() : "True";
  if (!remedy->use.empty()) error.message += " " + std::string(remedy->use);
  error.message += ")";
  error.remedy.clear();
  return error;
}

nb::list told(const std::vector<Warning>& warnings) {
  std::set<std::string> texts;
  nb::list list;
  for (const Warning& warning : warnings) {
    const auto [words, is_new] = texts.insert(describe(warning));
    if (!is_new) continue;
    nb::dict numbers;
    for (const auto& [name, number] : warning.numbers) numbers[text(name)] = number;
    list.append(nb::make_tuple(shown(*words), text(warning.code), numbers));
  }
  return list;
}

io::Input input_of(const std::string& path, const std::optional<nb::bytes>& bytes) {
  if (!bytes) return path;
  return io::Input::in_memory(path, std::string(static_cast<const char*>(bytes->data()), bytes->size()));
}

const io::FormatInfo* format_of(std::string_view word) {
  const auto found = std::ranges::find(io::formats(), word, &io::FormatInfo::id);
  return found == io::formats().end() ? nullptr : *found;
}

namespace {

Expected<io::TrackFile> read_keys(const io::Input& input, io::Reading reading) {
  const auto words = [](const Error& error) { return describe(in_words(error)); };
  return io::read_whole_track(input, std::move(reading), {families_info(), jobs::family_named, words});
}

nb::dict repairs_of(const io::RepairReport& repairs) {
  nb::dict result;
  result["duplicates_dropped"] = repairs.duplicates_dropped;
  result["invalid_dropped"] = repairs.invalid_dropped;
  result["rows_moved"] = repairs.rows_moved;
  result["normalised"] = repairs.normalised;
  result["rates_left_free"] = repairs.rates_left_free;
  result["largest_norm_error"] = repairs.largest_norm_error;
  result["largest_matrix_distance"] = repairs.largest_matrix_distance;
  result["largest_duplicate_turn"] = repairs.largest_duplicate_turn;
  result["largest_duplicate_distance"] = repairs.largest_duplicate_distance;
  result["rows_between"] = repairs.rows_between;
  return result;
}

io::Reading reading_of(const io::StatedOptions& stated, const std::map<std::string, std::string>& columns) {
  io::Reading reading;
  value_of(io::take_options(reading, stated));
  for (const auto& [name, column] : columns) reading.options.columns.emplace(name, column);
  return reading;
}

nb::dict read(const std::string& path, const io::StatedOptions& stated,
              const std::map<std::string, std::string>& columns, const std::optional<nb::bytes>& bytes) {
  io::Reading reading = reading_of(stated, columns);
  const io::Input input = input_of(path, bytes);
  auto file = [&] {
    const nb::gil_scoped_release release;
    return read_keys(input, std::move(reading));
  }();
  if (!file) raise(in_words(std::move(file.error())));
  nb::list ignored;
  for (const std::string& name : file->ignored_columns) ignored.append(text(name));
  nb::dict result;
  result["repairs"] = repairs_of(file->repairs);
  result["warnings"] = told(file->warnings);
  result["format"] = text(file->format->id);
  result["ignored_columns"] = ignored;
  result["keys"] = nb::cast(Keys{std::make_shared<const Track>(std::move(file->track))});
  return result;
}

std::size_t sessions(const std::string& path, const io::StatedOptions& stated,
                     const std::map<std::string, std::string>& columns, const std::optional<nb::bytes>& bytes) {
  const io::Reading reading = reading_of(stated, columns);
  const io::Input input = input_of(path, bytes);
  auto count = [&] {
    const nb::gil_scoped_release release;
    return io::sessions_in(input, reading.options);
  }();
  if (!count) raise(in_words(std::move(count.error())));
  return *count;
}

/// The rates of a gyro: seconds since the first one, rates, the exact time of that, and warnings.
nb::tuple read_rates(const std::string& path, const io::StatedOptions& stated,
                     const std::map<std::string, std::string>& columns, const std::optional<nb::bytes>& bytes) {
  const io::Reading reading = reading_of(stated, columns);
  io::Input input = input_of(path, bytes);
  auto rows = [&] {
    const nb::gil_scoped_release release;
    return io::read_rates(std::move(input), reading.options);
  }();
  if (!rows) raise(in_words(std::move(rows.error())));
  const Decimal& first = rows->exact_times.front();
  std::vector<double> seconds;
  for (const Decimal& time : rows->exact_times) seconds.push_back((time - first).to_double());
  return nb::make_tuple(array_of(seconds.data(), seconds.size(), 0),
                        array_of(rows->rates.front().data(), rows->rates.size(), 3), first.to_string(),
                        told(rows->warnings));
}

template <class Target>
nb::list listed(std::span<const io::FileOption<Target>> options) {
  nb::list list;
  for (const auto& option : options) {
    nb::dict entry;
    entry["name"] = text(option.name);
    entry["sentence"] = text(option.sentence);
    entry["argument"] = option.argument ? nb::object(text(option.argument())) : nb::none();
    list.append(entry);
  }
  return list;
}

}  // namespace

void add_files(nb::module_& module) {
  add_key_origins(module);
  add_key_writing(module);
  add_sample_writing(module);
  module.def("read", &read, "path"_a, "stated"_a, "columns"_a, "bytes"_a.none());
  module.def(
      "check_reading",
      [](const io::StatedOptions& stated) {
        const io::Reading reading = reading_of(stated, {});
        value_of(io::check_frames(reading.options).map_error([](Error error) { return in_words(std::move(error)); }));
      },
      "stated"_a);
  module.def("sessions", &sessions, "path"_a, "stated"_a, "columns"_a, "bytes"_a.none());
  module.def("read_rates", &read_rates, "path"_a, "stated"_a, "columns"_a, "bytes"_a.none());
  module.def("reading_options", [] { return listed(io::reading_options()); });
  module.def("writing_options", [] { return listed(io::writing_options()); });
}

}  // namespace orispline::python
