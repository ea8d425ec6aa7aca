// SPDX-License-Identifier: Apache-2.0
#include "keys.hpp"

#include <array>
#include <limits>
#include <span>
#include <vector>

#include <orispline/base/formatted.hpp>

#include "errors.hpp"

namespace orispline::c {

namespace {

/// More keys than that have no room in memory.
constexpr std::size_t most_keys = std::numeric_limits<std::size_t>::max() / (8 * sizeof(double));

using Vectors = std::vector<Eigen::Vector3d>;
using Quaternions = std::vector<Eigen::Quaterniond>;

/// The columns that are no settings.
constexpr std::array<std::pair<std::string_view, Vectors KeyframeData::*>, 4> columns_of_vectors{
    {{"positions", &KeyframeData::positions},
     {"angular_velocities", &KeyframeData::angular_velocities},
     {"angular_accelerations", &KeyframeData::angular_accelerations},
     {"angular_jerks", &KeyframeData::angular_jerks}}};
constexpr std::array<std::pair<std::string_view, Quaternions KeyframeData::*>, 3> columns_of_quaternions{
    {{"orientations", &KeyframeData::orientations},
     {"inner_leaving", &KeyframeData::inner_leaving},
     {"inner_arriving", &KeyframeData::inner_arriving}}};

template <class List>
auto member_named(const List& list, std::string_view name) {
  for (const auto& [known, member] : list)
    if (known == name) return member;
  return decltype(list.front().second){nullptr};
}

Vectors vectors_in(std::span<const double> numbers) {
  Vectors rows;
  rows.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); i += 3) rows.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return rows;
}

Quaternions quaternions_in(std::span<const double> numbers, orispline_order order) {
  const std::size_t w = order == ORISPLINE_WXYZ ? 0 : 3, x = order == ORISPLINE_WXYZ ? 1 : 0;
  Quaternions rows;
  rows.reserve(numbers.size() / 4);
  for (std::size_t i = 0; i < numbers.size(); i += 4)
    rows.emplace_back(numbers[i + w], numbers[i + x], numbers[i + x + 1], numbers[i + x + 2]);
  return rows;
}

Expected<void> check_count(std::string_view name, std::size_t found, std::size_t keys, std::size_t width) {
  if (found == keys * width) return {};
  return bad_option(name, formatted("found {} numbers, wanted {} for {} keys", found, keys * width, keys));
}

/// Keys that are being made of the caller's arrays.
struct Arrays {
  std::size_t count;
  orispline_order order;
  KeyframeData data{};
  std::map<std::string, std::vector<double>, std::less<>> settings{};

  [[nodiscard]] Expected<void> take(const orispline_column& column) {
    if (!column.name) return bad_option("columns", "found a column without a name, wanted one");
    const std::string_view name = column.name;
    if (auto there = check_pointer(column.numbers, name); !there) return there;
    const std::span<const double> numbers(column.numbers, column.count);
    if (const auto vectors = member_named(columns_of_vectors, name))
      return check_count(name, column.count, count, 3).and_then([&] {
        return put(name, data.*vectors, vectors_in(numbers));
      });
    if (const auto quaternions = member_named(columns_of_quaternions, name))
      return check_count(name, column.count, count, 4).and_then([&] {
        return put(name, data.*quaternions, quaternions_in(numbers, order));
      });
    if (name.empty() || name == "times") return bad_option("columns", formatted("found '{}', wanted a column", name));
    return check_count(name, column.count, count, 1).and_then([&] {
      return put(name, settings[std::string(name)], {numbers.begin(), numbers.end()});
    });
  }

  template <class Rows>
  [[nodiscard]] static Expected<void> put(std::string_view name, Rows& to, Rows rows) {
    if (!to.empty()) return bad_option(name, "found it twice, wanted it once");
    to = std::move(rows);
    return {};
  }
};

Expected<Keys> keys_of(Arrays arrays, orispline_signs signs) {
  const Signs how = signs == ORISPLINE_AS_GIVEN ? Signs::as_given : Signs::shortest;
  return Keyframes::make(std::move(arrays.data), how).map([&](const Keyframes& keys) {
    Track track(keys);
    track.recipe.signs = how;
    track.settings = std::move(arrays.settings);
    return Keys{std::make_shared<const Track>(std::move(track))};
  });
}

Expected<void> check_sizes(const double* times, const double* orientations, std::size_t count) {
  if (count > most_keys) return bad_option("count", formatted("found {} keys, wanted fewer", count));
  if (count == 0) return {};
  return check_pointer(times, "times").and_then([&] { return check_pointer(orientations, "orientations"); });
}

Expected<void> check_signs(orispline_signs signs) {
  if (signs == ORISPLINE_SHORTEST || signs == ORISPLINE_AS_GIVEN) return {};
  return bad_option("signs", formatted("found {}, wanted ORISPLINE_SHORTEST or ORISPLINE_AS_GIVEN", signs));
}

/// The numbers of a column as the caller wants them.
struct Copy {
  const KeyframeData& data;
  orispline_order order;
  std::span<double> to;

  [[nodiscard]] Expected<void> numbers(std::string_view name, std::span<const double> rows) const {
    if (auto fits = check_count(name, to.size(), data.times.size(), 1); !fits) return fits;
    std::ranges::copy(rows, to.begin());
    return {};
  }
  [[nodiscard]] Expected<void> vectors(std::string_view name, const Vectors& rows) const {
    if (auto fits = check_count(name, to.size(), data.times.size(), 3); !fits) return fits;
    for (std::size_t i = 0; i < rows.size(); ++i)
      std::ranges::copy(rows[i], to.begin() + static_cast<std::ptrdiff_t>(3 * i));
    return {};
  }
  [[nodiscard]] Expected<void> quaternions(std::string_view name, const Quaternions& rows) const {
    if (auto fits = check_count(name, to.size(), data.times.size(), 4); !fits) return fits;
    if (auto fits = check_order(order); !fits) return fits;
    for (std::size_t i = 0; i < rows.size(); ++i) put_quaternion(to.data() + 4 * i, rows[i], order);
    return {};
  }
};

Expected<void> copy_column(const Track& track, std::string_view name, const Copy& copy) {
  const KeyframeData& data = track.keys.data();
  if (name == "times") return copy.numbers(name, data.times);
  if (const auto member = member_named(columns_of_vectors, name); member && !(data.*member).empty())
    return copy.vectors(name, data.*member);
  if (const auto member = member_named(columns_of_quaternions, name); member && !(data.*member).empty())
    return copy.quaternions(name, data.*member);
  if (const auto found = track.settings.find(name); found != track.settings.end())
    return copy.numbers(name, found->second);
  return bad_option("name", formatted("found '{}', wanted a column that the keys have", name));
}

}  // namespace

std::vector<ColumnOfKeys> columns_of(const Track& track) {
  const KeyframeData& data = track.keys.data();
  std::vector<ColumnOfKeys> columns{{"times", 1}};
  for (const auto& [name, member] : columns_of_quaternions)
    if (!(data.*member).empty()) columns.push_back({name, 4});
  for (const auto& [name, member] : columns_of_vectors)
    if (!(data.*member).empty()) columns.push_back({name, 3});
  for (const auto& [name, values] : track.settings) columns.push_back({name, 1});
  return columns;
}

Expected<void> check_order(orispline_order order) {
  if (order == ORISPLINE_WXYZ || order == ORISPLINE_XYZW) return {};
  return bad_option("order", formatted("found {}, wanted ORISPLINE_WXYZ or ORISPLINE_XYZW", order));
}

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_keys_make(const double* times, const double* orientations, size_t count, orispline_order order,
                                   orispline_signs signs, const orispline_column* columns, size_t column_count,
                                   orispline_keys** keys, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(keys, "keys")
        .and_then([&] { return check_sizes(times, orientations, count); })
        .and_then([&] { return check_order(order); })
        .and_then([&] { return check_signs(signs); })
        .and_then([&] { return column_count == 0 ? Expected<void>() : check_pointer(columns, "columns"); })
        .and_then([&]() -> Expected<Keys> {
          Arrays arrays{count, order};
          arrays.data.times.assign(times, times + count);
          arrays.data.orientations = quaternions_in({orientations, 4 * count}, order);
          for (const orispline_column& column : std::span(columns, column_count))
            if (auto taken = arrays.take(column); !taken) return tl::unexpected(std::move(taken.error()));
          return keys_of(std::move(arrays), signs);
        })
        .map([&](Keys made) { *keys = handle_of<orispline_keys>(std::move(made)); });
  });
}

size_t orispline_keys_count(const orispline_keys* keys) {
  const Keys* const body = body_of(keys);
  return body ? body->track->keys.size() : 0;
}

orispline_code orispline_keys_column(const orispline_keys* keys, const char* name, orispline_order order,
                                     double* numbers, size_t count, orispline_error** error) {
  return guarded(error, [&]() -> Expected<void> {
    const auto body = checked(keys);
    if (!body) return tl::unexpected(body.error());
    return check_pointer(name, "name").and_then([&] { return check_pointer(numbers, "numbers"); }).and_then([&] {
      const Track& track = *(*body)->track;
      return copy_column(track, name, {track.keys.data(), order, {numbers, count}});
    });
  });
}

void orispline_keys_free(orispline_keys* keys) { free_handle(keys); }
