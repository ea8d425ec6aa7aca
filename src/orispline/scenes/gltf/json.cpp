// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/json.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// Nothing of the text is kept, so that no text takes memory that is refused.
Expected<void> check_size(std::string_view text) {
  std::size_t depth = 0, values = 1;
  bool is_in_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_in_quotes && c == '\\') {
      ++i;
    } else if (c == '"') {
      is_in_quotes = !is_in_quotes;
    } else if (!is_in_quotes && (c == '[' || c == '{' || c == ',')) {
      if (++values > most_values)
        return failure(ErrorCode::bad_data, formatted("found JSON of more than {} values, wanted fewer", most_values));
      if (c != ',' && ++depth > deepest_nesting)
        return failure(ErrorCode::bad_data,
                       formatted("found JSON nested deeper than {} levels, wanted fewer", deepest_nesting));
    } else if (!is_in_quotes && (c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return {};
}

tl::unexpected<Error> no_json() {
  return failure(ErrorCode::bad_data, "found text that is not valid JSON, wanted a glTF document");
}

/// Also of `3.0`, which is the same number to JSON.
std::optional<std::size_t> whole_number(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::size_t>();
  if (!value.is_number_float()) return std::nullopt;
  const double number = value.get<double>();
  constexpr double largest = 9007199254740992.0;  // 2^53
  if (!(number >= 0.0 && number <= largest) || std::floor(number) != number) return std::nullopt;
  return static_cast<std::size_t>(number);
}

}  // namespace

Expected<void> check_start_of_json(std::string_view start) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF", blanks = " \t\r\n", beginnings = "{[\"-0123456789tfn";
  if (start.starts_with(byte_order_mark)) start.remove_prefix(byte_order_mark.size());
  const std::size_t first = start.find_first_not_of(blanks);
  if (first != start.npos && beginnings.find(start[first]) == beginnings.npos) return no_json();
  return {};
}

Expected<Json> parsed(std::string_view text) {
  if (auto sound = check_size(text); !sound) return tl::unexpected(std::move(sound.error()));
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return no_json();
  return json;
}

std::string shown(const Json& value) {
  if (const auto* text = value.get_ptr<const Json::string_t*>()) return in_quotes(*text);
  if (value.is_array()) return "a list";
  if (value.is_object()) return "an object";
  return value.dump();
}

Error within(std::string_view place, Error error) {
  const auto key = std::exchange(error.where.key, std::nullopt);
  error.message =
      key ? formatted("{}, key {}: {}", place, *key, error.message) : formatted("{}: {}", place, error.message);
  return error;
}

Expected<Object> Object::of(const Json& value, std::string name) {
  Object object(value, std::move(name));
  if (!value.is_object()) return object.fault(formatted("found {}, wanted an object", shown(value)));
  return object;
}

const Json* Object::find(const char* key) const {
  const auto found = json_->find(key);
  return found == json_->end() ? nullptr : &*found;
}

Expected<std::size_t> Object::index(const char* key, std::size_t size) const {
  const Json* value = find(key);
  const auto number = value == nullptr ? std::nullopt : whole_number(*value);
  if (!number) return wrong(key, value, "a whole number from 0");
  if (*number >= size)
    return wrong(key, value, size == 0 ? "none, for there is nothing of that kind" : formatted("less than {}", size));
  return *number;
}

Expected<std::size_t> Object::count(const char* key) const {
  const Json* value = find(key);
  const auto number = value == nullptr ? std::nullopt : whole_number(*value);
  if (!number) return wrong(key, value, "a whole number from 0");
  if (*number > largest_scene_file) return wrong(key, value, formatted("{} at most", largest_scene_file));
  return *number;
}

Expected<std::size_t> Object::count_or(const char* key, std::size_t absent) const {
  return has(key) ? count(key) : absent;
}

Expected<std::string> Object::text(const char* key) const {
  const Json* value = find(key);
  const auto* text = value == nullptr ? nullptr : value->get_ptr<const Json::string_t*>();
  if (text == nullptr) return wrong(key, value, "text");
  return *text;
}

Expected<std::string> Object::text_or(const char* key, std::string absent) const {
  return has(key) ? text(key) : std::move(absent);
}

Expected<bool> Object::flag(const char* key) const {
  const Json* value = find(key);
  if (value == nullptr) return false;
  if (!value->is_boolean()) return wrong(key, value, "true or false");
  return value->get<bool>();
}

Expected<Object> Object::object(const char* key) const {
  const Json* value = find(key);
  if (value == nullptr || !value->is_object()) return wrong(key, value, "an object");
  return Object(*value, name_.empty() ? key : formatted("{}, {}", name_, key));
}

Expected<const Json*> Object::list(const char* key) const {
  static const Json nothing = Json::array();
  const Json* value = find(key);
  if (value == nullptr) return &nothing;
  if (!value->is_array()) return wrong(key, value, "a list");
  return value;
}

Expected<std::vector<std::size_t>> Object::indices(const char* key, std::size_t size) const {
  const auto all = list(key);
  if (!all) return tl::unexpected(all.error());
  std::vector<std::size_t> found;
  for (const Json& value : **all) {
    const auto number = whole_number(value);
    if (!number || *number >= size)
      return fault(formatted("found {} in {}, wanted whole numbers less than {}", shown(value), key, size));
    found.push_back(*number);
  }
  return found;
}

Expected<Object> Object::entry(const char* key, std::string_view noun, std::size_t index) const {
  const auto all = list(key);
  if (!all) return tl::unexpected(all.error());
  std::string name = formatted("{}{}{} {}", name_, name_.empty() ? "" : ", ", noun, index);
  if (index >= (*all)->size()) return failure(ErrorCode::bad_data, formatted("found no {}, wanted one", name));
  return of((**all)[index], std::move(name));
}

tl::unexpected<Error> Object::fault(std::string_view message) const {
  return failure(ErrorCode::bad_data, name_.empty() ? std::string(message) : formatted("{}: {}", name_, message));
}

tl::unexpected<Error> Object::wrong(const char* key, const Json* value, std::string_view wanted) const {
  if (value == nullptr) return fault(formatted("found no {}, wanted {}", key, wanted));
  return fault(formatted("found {} as {}, wanted {}", shown(*value), key, wanted));
}

Expected<const Json*> Object::list_of_numbers(const char* key, std::size_t size) const {
  const Json* value = find(key);
  if (!value->is_array() || value->size() != size ||
      !std::ranges::all_of(*value, [](const Json& number) { return number.is_number(); }))
    return wrong(key, value, formatted("a list of {} numbers", size));
  return value;
}

}}}  // namespace orispline::scenes::gltf
