// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/blending_file.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/line_reader.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

using Nlohmann = nlohmann::ordered_json;

constexpr std::size_t longest_file = std::size_t{64} << 10;  // [bytes]
constexpr std::array<std::string_view, 7> members{"name", "title", "parameters", "rows", "first", "ends", "basis"};
constexpr std::array<std::string_view, 3> bases{"bernstein", "power", "bezier"};
constexpr std::array<std::string_view, 3> parameter_members{"default", "min", "max"};

tl::unexpected<Error> refused(std::string message) { return failure(ErrorCode::bad_data, std::move(message)); }

/// Where a text stops being JSON [bytes].
struct FaultFinder : nlohmann::json_sax<Nlohmann> {
  std::size_t position = 0;
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool key(string_t&) override { return true; }
  bool parse_error(std::size_t at, const std::string&, const nlohmann::detail::exception&) override {
    position = at;
    return false;
  }
};

tl::unexpected<Error> not_json(std::string_view text) {
  FaultFinder finder;
  Nlohmann::sax_parse(text, &finder);
  const std::string_view before = text.substr(0, finder.position == 0 ? 0 : finder.position - 1);
  const auto line = static_cast<std::size_t>(std::ranges::count(before, '\n'));
  return failure(ErrorCode::bad_data, "found text that is not valid JSON, wanted an object with 'name' and 'rows'",
                 {.line = line + 1, .column = before.size() - (before.rfind('\n') + 1) + 1});
}

std::string shown(const Nlohmann& value) {
  if (const auto* text = value.get_ptr<const Nlohmann::string_t*>()) return in_quotes(*text);
  if (value.is_array()) return "a list";
  return value.is_object() ? "an object" : value.dump();
}

Expected<std::string> text_in(const Nlohmann& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end()) return std::string();
  if (!found->is_string()) return refused(formatted("{}: found {}, wanted a text", name, shown(*found)));
  return found->get<std::string>();
}

template <std::size_t Count>
Expected<void> check_members(const Nlohmann& json, std::string_view place,
                             const std::array<std::string_view, Count>& known) {
  for (const auto& [name, value] : json.items())
    if (std::ranges::find(known, name) == known.end())
      return refused(formatted("{}found the member {}, wanted {}", place, in_quotes(name), joined(known, ", ")));
  return {};
}

Expected<BlendingParameter> parameter_in(const std::string& name, const Nlohmann& value) {
  BlendingParameter parameter{.name = name};
  const std::string place = formatted("parameters: {}: ", in_quotes(name));
  if (value.is_number()) {
    parameter.initial = value.get<double>();
    return parameter;
  }
  if (!value.is_object())
    return refused(
        formatted("{}found {}, wanted its default, or an object with 'default', 'min', 'max'", place, shown(value)));
  if (auto checked = check_members(value, place, parameter_members); !checked)
    return tl::unexpected(std::move(checked.error()));
  const std::array places{std::pair("default", &parameter.initial), std::pair("min", &parameter.lowest),
                          std::pair("max", &parameter.highest)};
  for (const auto& [member, number] : places) {
    const auto found = value.find(member);
    if (found == value.end()) continue;
    if (!found->is_number()) return refused(formatted("{}{}: found {}, wanted a number", place, member, shown(*found)));
    *number = found->get<double>();
  }
  return parameter;
}

Expected<std::vector<BlendingParameter>> parameters_in(const Nlohmann& json) {
  std::vector<BlendingParameter> parameters;
  const auto found = json.find("parameters");
  if (found == json.end()) return parameters;
  if (!found->is_object())
    return refused(formatted("parameters: found {}, wanted an object of names and defaults", shown(*found)));
  for (const auto& [name, value] : found->items()) {
    auto parameter = parameter_in(name, value);
    if (!parameter) return tl::unexpected(std::move(parameter.error()));
    parameters.push_back(std::move(*parameter));
  }
  return parameters;
}

Expected<std::vector<std::vector<std::string>>> rows_in(const Nlohmann& json) {
  std::vector<std::vector<std::string>> rows;
  const auto found = json.find("rows");
  if (found == json.end() || !found->is_array())
    return refused(formatted("rows: found {}, wanted a list of rows", found == json.end() ? "none" : shown(*found)));
  for (const Nlohmann& row : *found) {
    if (!row.is_array())
      return refused(formatted("row {}: found {}, wanted a list of coefficients", rows.size() + 1, shown(row)));
    auto& entries = rows.emplace_back();
    for (const Nlohmann& entry : row) {
      if (!entry.is_string() && !entry.is_number())
        return refused(formatted("row {}, entry {}: found {}, wanted a number or a text", rows.size(),
                                 entries.size() + 1, shown(entry)));
      entries.push_back(entry.is_string() ? entry.get<std::string>() : entry.dump());
    }
  }
  return rows;
}

Expected<std::optional<int>> first_in(const Nlohmann& json) {
  const auto found = json.find("first");
  if (found == json.end()) return std::nullopt;
  const bool is_small = found->is_number_integer() && std::abs(found->get<double>()) < 1e6;
  if (!is_small) return refused(formatted("first: found {}, wanted a whole number", shown(*found)));
  return found->get<int>();
}

Expected<BlendingBasis> basis_in(const Nlohmann& json) {
  return text_in(json, "basis").and_then([](const std::string& word) -> Expected<BlendingBasis> {
    const auto found = static_cast<std::size_t>(std::ranges::find(bases, word) - bases.begin());
    if (word.empty()) return BlendingBasis::bernstein;
    if (found == bases.size())
      return refused(formatted("basis: found {}, wanted one of {}", in_quotes(word), joined(bases, ", ")));
    return static_cast<BlendingBasis>(found);
  });
}

/// Puts what was found into its place, or keeps the first error.
template <class T>
void put(std::optional<Error>& error, T& place, Expected<T> found) {
  if (found) place = std::move(*found);
  else if (!error) error = std::move(found.error());
}

}  // namespace

Expected<BlendingData> blending_from_json(std::string_view text) {
  const Nlohmann json = Nlohmann::parse(text, nullptr, false);
  if (json.is_discarded()) return not_json(text);
  if (!json.is_object()) return refused(formatted("found {}, wanted an object with 'name' and 'rows'", shown(json)));
  if (auto checked = check_members(json, "", members); !checked) return tl::unexpected(std::move(checked.error()));
  BlendingData data;
  std::optional<Error> error;
  put(error, data.name, text_in(json, "name"));
  put(error, data.title, text_in(json, "title"));
  put(error, data.parameters, parameters_in(json));
  put(error, data.rows, rows_in(json));
  put(error, data.first, first_in(json));
  put(error, data.basis, basis_in(json));
  if (json.contains("ends")) put(error, data.ends, text_in(json, "ends"));
  if (error) return tl::unexpected(std::move(*error));
  return data;
}

Expected<BlendingData> read_blending(const Input& input) {
  auto lines = LineReader::open(input);
  if (!lines) return tl::unexpected(std::move(lines.error()));
  std::string text;
  for (;;) {
    const auto line = lines->next();
    if (!line) return tl::unexpected(line.error());
    if (!*line) break;
    text.append(**line).push_back('\n');
    if (text.size() > longest_file)
      return failure(ErrorCode::bad_data, formatted("found more than {} bytes, wanted fewer", longest_file),
                     {.file = input.name()});
  }
  return blending_from_json(text).map_error([&](Error error) {
    error.where.file = input.name();
    return error;
  });
}

std::string blending_json(const BlendingData& data) {
  Nlohmann json{{"name", data.name}, {"title", data.title}};
  const BlendingData silent;
  if (!data.parameters.empty()) json["parameters"] = Nlohmann::object();
  for (const auto& [name, initial, lowest, highest] : data.parameters)
    json["parameters"][name] = {{"default", initial}, {"min", lowest}, {"max", highest}};
  json["rows"] = data.rows;
  if (data.first) json["first"] = *data.first;
  if (data.ends != silent.ends) json["ends"] = data.ends;
  if (data.basis != silent.basis) json["basis"] = bases[static_cast<std::size_t>(data.basis)];
  return json.dump(-1, ' ', false, Nlohmann::error_handler_t::replace);
}

}}}  // namespace orispline::io
