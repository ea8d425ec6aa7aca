// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

// Here and not in the header, where GCC 12 warns of the variant that they move.
Json::Json(std::nullptr_t) {}
Json::Json(const Json& other) = default;
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(const Json& other) = default;
Json& Json::operator=(Json&& other) noexcept = default;
Json::~Json() = default;

Json::Json(std::initializer_list<Member> members) : value_(Object(members)) {}

void Json::push_back(Json value) { std::get<Array>(value_).push_back(std::move(value)); }

Json& Json::operator[](std::string_view name) {
  if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Object();
  Object& members = std::get<Object>(value_);
  for (Member& member : members)
    if (member.first == name) return member.second;
  return members.emplace_back(std::string(name), Json()).second;
}

void Json::update(Json other) {
  for (Member& member : std::get<Object>(other.value_)) (*this)[member.first] = std::move(member.second);
}

}}  // namespace orispline
