// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/field_info.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// ` rad`, nothing without a unit.
std::string unit_after(const Quantity* quantity) { return quantity ? formatted(" {}", quantity->unit) : ""; }

struct Shown {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(bool flag) const { return flag ? "true" : ""; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const std::vector<SampleRun>& runs) const { return formatted("{}", runs.size()); }
  std::string operator()(const Measured& measured) const { return joined(measured.numbers, ","); }
  std::string operator()(auto number) const { return formatted("{}", number); }
  template <class T>
  std::string operator()(const std::vector<T>& list) const {
    return joined(list, ",");
  }
};

/// What a range is for.
std::vector<double> numbers_of(const FieldValue& value) {
  if (const double* number = std::get_if<double>(&value)) return {*number};
  if (const std::uint64_t* count = std::get_if<std::uint64_t>(&value)) return {static_cast<double>(*count)};
  if (const Measured* measured = std::get_if<Measured>(&value)) return measured->numbers;
  return {};
}

}  // namespace

const FieldInfo& field_named(std::span<const FieldInfo> fields, std::string_view name) {
  const auto found = std::ranges::find(fields, name, &FieldInfo::name);
  ORISPLINE_EXPECT(found != fields.end());
  return *found;
}

std::string name_with_unit(const FieldInfo& field) {
  return field.quantity ? formatted("{}_{}", field.name, field.quantity->suffix) : std::string(field.name);
}

std::string_view name_of(FieldType type) {
  static constexpr std::array names{"flag",   "count", "number",           "word",      "names",  "interval",
                                    "vector", "limit", "symmetric_matrix", "recording", "sample", "samples",
                                    "runs"};
  return names[static_cast<std::size_t>(type)];
}

bool is_absent(const FieldValue& value) noexcept {
  if (const double* number = std::get_if<double>(&value)) return *number == std::numeric_limits<double>::infinity();
  return std::holds_alternative<std::monostate>(value);
}

std::string text_of(const FieldValue& value) { return is_absent(value) ? std::string() : std::visit(Shown{}, value); }

std::string text_of(Interval range, const Quantity* quantity) {
  constexpr Interval all;
  const std::string unit = unit_after(quantity);
  if (range.lowest == all.lowest && range.highest == all.highest) return {};
  if (range.lowest == positive.lowest) return formatted("more than 0{}", unit);
  if (range.highest == all.highest) return formatted("{:.6g}{} or more", range.lowest, unit);
  return formatted("{:.6g} to {:.6g}{}", range.lowest, range.highest, unit);
}

namespace {

/// `more than 0 s and finite`
std::string wanted_text(const FieldInfo& field, double found) {
  const std::string range = text_of(field.range, field.quantity);
  if (range.empty()) return "a finite number";
  return range + (std::isinf(found) ? " and finite" : "");
}

}  // namespace

Expected<void> check_ranges(std::span<const FieldInfo> fields, const void* options) {
  for (const FieldInfo& field : fields) {
    const FieldValue value = field.get(options);
    for (const double x : numbers_of(value))
      if (!field.range.contains(x))
        return bad_option(field.name,
                          formatted("found {:.6g}{}, wanted {}", x, unit_after(field.quantity), wanted_text(field, x)));
  }
  return {};
}

}}  // namespace orispline
