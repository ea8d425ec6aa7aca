// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>

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

const io::FormatInfo* format_of(std::string_view word) {
  const auto found = std::ranges::find(io::formats(), word, &io::FormatInfo::id);
  return found == io::formats().end() ? nullptr : *found;
}

namespace {

constexpr int all_rate_orders = 3;

/// With the columns that the methods take.
io::ReadOptions read_for(std::span<const FamilyInfo* const> families, io::ReadOptions options) {
  std::set<std::string> parameters;
  options.rate_orders = 0;
  for (const FamilyInfo* const family : families) {
    options.rate_orders = std::max(options.rate_orders, family->rate_orders);
    options.inner_quaternions |= family->takes_inner_quaternions();
    for (const Parameter& parameter : family->parameters) parameters.emplace(parameter.name);
  }
  options.parameters = {parameters.begin(), parameters.end()};
  options.world_rates = true;
  return options;
}

/// With the columns that any method takes, those too that are `named`: which one the keys are for is not known yet.
io::ReadOptions read_for_all(std::vector<const FamilyInfo*> families, io::ReadOptions options) {
  for (const FamilyInfo& family : families_info()) families.push_back(&family);
  options = read_for(families, std::move(options));
  options.rate_orders = all_rate_orders;
  return options;
}

bool has_more_than_motion(const io::TrackFile& file) {
  const Keyframes& keys = file.track.keys;
  return !file.track.settings.empty() || !keys.angular_velocities().empty() || !keys.inner_leaving().empty() ||
         !keys.inner_arriving().empty();
}

Warning left_out(const std::string& path, const std::string& reason) {
  return {.code = "columns_left_out",
          .message = "columns of rates, inner quaternions or settings are left out, since they are not those of keys: " + reason,
          .where = {.file = path}};
}

/// Reads keys with all that any method takes of them. Where that cannot be had of all keys, with what the method takes
/// that the file names, as the command does.
Expected<io::TrackFile> read_keys(const std::string& path, io::Reading reading) {
  reading.options.keep_exact_times = reading.options.keep_as_read = true;
  auto input = io::KeyInput::open(path, reading.options);
  if (!input) return tl::unexpected(std::move(input.error()));
  const auto method = method_of(input->recipe(), path);
  if (!method) return tl::unexpected(method.error());
  std::vector<const FamilyInfo*> named;
  if (*method) named.push_back(*family_of_method(**method));
  auto file = io::read_track(std::move(*input), read_for_all(named, reading.options), reading.signs);
  const bool is_whole = file && (!has_more_than_motion(*file) || file->repairs.invalid_dropped == 0);
  if (is_whole || path == io::standard_stream) return file;
  auto plain = io::read_track(path, read_for(named, std::move(reading.options)), reading.signs);
  if (!plain || (file && file->track.keys.size() == plain->track.keys.size())) return file ? file : plain;
  plain->warnings.push_back(
      left_out(path, file ? "some have no numbers" : describe(in_words(std::move(file.error())))));
  return plain;
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
              const std::map<std::string, std::string>& columns) {
  io::Reading reading = reading_of(stated, columns);
  auto file = [&] {
    const nb::gil_scoped_release release;
    return read_keys(path, std::move(reading));
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
                     const std::map<std::string, std::string>& columns) {
  const io::Reading reading = reading_of(stated, columns);
  auto count = [&] {
    const nb::gil_scoped_release release;
    return io::sessions_in(path, reading.options);
  }();
  if (!count) raise(in_words(std::move(count.error())));
  return *count;
}

/// The rates of a gyro: seconds since the first one, rates, the exact time of that, and warnings.
nb::tuple read_rates(const std::string& path, const io::StatedOptions& stated,
                     const std::map<std::string, std::string>& columns) {
  const io::Reading reading = reading_of(stated, columns);
  auto rows = [&] {
    const nb::gil_scoped_release release;
    return io::read_rates(path, reading.options);
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
  module.def("read", &read, "path"_a, "stated"_a, "columns"_a);
  module.def(
      "check_reading",
      [](const io::StatedOptions& stated) {
        const io::Reading reading = reading_of(stated, {});
        value_of(io::check_frames(reading.options).map_error([](Error error) { return in_words(std::move(error)); }));
      },
      "stated"_a);
  module.def("sessions", &sessions, "path"_a, "stated"_a, "columns"_a);
  module.def("read_rates", &read_rates, "path"_a, "stated"_a, "columns"_a);
  module.def("reading_options", [] { return listed(io::reading_options()); });
  module.def("writing_options", [] { return listed(io::writing_options()); });
}

}  // namespace orispline::python
