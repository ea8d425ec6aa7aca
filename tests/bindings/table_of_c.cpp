// SPDX-License-Identifier: Apache-2.0
// table_of_c TABLE FOLDER: what the C API finds for every request of the table, a line of JSON each.
#include <memory>

#include <orispline.h>

#include <orispline/base/base64.hpp>

#include "bindings/table.hpp"

namespace orispline::bindings_table { namespace {

template <class Handle, void (*Free)(Handle*)>
struct Freeing {
  void operator()(Handle* handle) const noexcept { Free(handle); }
};
template <class Handle, void (*Free)(Handle*)>
using Owned = std::unique_ptr<Handle, Freeing<Handle, Free>>;
using Value = Owned<orispline_value, orispline_value_free>;
using Keys = Owned<orispline_keys, orispline_keys_free>;
using Text = Owned<char, orispline_text_free>;

Json told(orispline_error* error) {
  const Owned<orispline_error, orispline_error_free> owned(error);
  return {{"error",
           {{"code", orispline_error_code(error)},
            {"message", orispline_error_message(error)},
            {"option", orispline_error_option(error)},
            {"remedy", orispline_error_remedy(error)},
            {"key", orispline_error_key(error)}}}};
}

/// Null where it cannot be made, with the error.
Value value_of(const Input& input, orispline_error** error) {
  orispline_value* value = nullptr;
  if (input.kind == "rates") {
    const Rates gyro = rates_in(input.bytes);
    orispline_value_of_rates(gyro.times.data(), gyro.rates.data(), gyro.times.size(), nullptr, &value, error);
  } else if (input.kind == "skeleton") {
    orispline_value_of_skeleton(input.bytes.data(), input.bytes.size(), input.file.c_str(), nullptr, 0, &value, error);
  } else {
    orispline_keys* keys = nullptr;
    orispline_keys_read(input.bytes.data(), input.bytes.size(), input.file.c_str(), nullptr, 0, &keys, error);
    const Keys owned(keys);
    if (keys) orispline_value_of_keys(keys, &value, error);
  }
  return Value(value);
}

std::vector<double> column(const orispline_keys* keys, const char* name, std::size_t width) {
  std::vector<double> numbers(width * orispline_keys_count(keys));
  orispline_keys_column(keys, name, ORISPLINE_WXYZ, numbers.data(), numbers.size(), nullptr);
  return numbers;
}

Json json_of(const Value& value) {
  const std::size_t count = orispline_value_count(value.get());
  if (orispline_value_kind(value.get()) == ORISPLINE_KEYS) {
    orispline_keys* made = nullptr;
    orispline_value_keys(value.get(), &made, nullptr);
    const Keys keys(made);
    return {{"times", column(made, "times", 1)}, {"orientations", column(made, "orientations", 4)}};
  }
  if (orispline_value_kind(value.get()) == ORISPLINE_RATES) {
    std::vector<double> times(count), rates(3 * count);
    orispline_value_rates(value.get(), times.data(), rates.data(), count, nullptr);
    return {{"times", times}, {"rates", rates}};
  }
  char* bytes = nullptr;
  std::size_t size = 0;
  orispline_value_write(value.get(), "made.glb", nullptr, 0, &bytes, &size, nullptr, nullptr);
  const Text owned(bytes);
  return {{"skeleton", base64_of(std::string(bytes ? bytes : "", size))}};
}

Json json_of(const orispline_outcome* outcome) {
  Json made = Json::array();
  for (std::size_t k = 0; k < orispline_outcome_value_count(outcome); ++k) {
    orispline_value* value = nullptr;
    orispline_outcome_value(outcome, k, &value, nullptr);
    made.push_back(json_of(Value(value)));
  }
  return {{"document", Json::parse(orispline_outcome_document(outcome))},
          {"summary", orispline_outcome_summary(outcome)},
          {"line", orispline_outcome_line(outcome)},
          {"warnings", Json::parse(orispline_outcome_warnings(outcome))},
          {"made", made}};
}

Json found_for(const Request& request) {
  orispline_error* error = nullptr;
  std::vector<Value> values;
  std::vector<orispline_named_value> inputs;
  for (const Input& input : request.inputs) {
    values.push_back(value_of(input, &error));
    if (error) return told(error);
    inputs.push_back({input.name.c_str(), values.back().get()});
  }
  std::vector<std::string> texts;
  for (const auto& [name, text] : request.options) texts.push_back(name + "=" + text);
  std::vector<const char*> options;
  for (const std::string& text : texts) options.push_back(text.c_str());
  orispline_outcome* outcome = nullptr;
  orispline_task_run_with(request.task.c_str(), inputs.data(), inputs.size(), options.data(), options.size(), nullptr,
                          nullptr, &outcome, &error);
  const Owned<orispline_outcome, orispline_outcome_free> owned(outcome);
  return error ? told(error) : json_of(outcome);
}

}}  // namespace orispline::bindings_table

int main(int count, char** arguments) {
  return orispline::bindings_table::run_table(count, arguments, orispline::bindings_table::found_for);
}
