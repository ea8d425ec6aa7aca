// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/blending/rows.hpp>

#include <algorithm>
#include <cstdlib>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/blending/blending_family.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

namespace {

tl::unexpected<Error> refused(std::string message) { return failure(ErrorCode::bad_argument, std::move(message)); }

std::string entries(std::size_t count) { return formatted("{} {}", count, count == 1 ? "entry" : "entries"); }

/// The first increment, and that there are increments on the segment.
Expected<int> first_of(const BlendingData& data, std::size_t increments) {
  const int count = static_cast<int>(increments);
  if (!data.first) {
    if (count % 2 == 1) return -(count / 2);
    return refused(formatted("first: {} do not say where they begin, wanted 'first', 0 being the segment's own",
                             counted(increments, "increment")));
  }
  if (*data.first > 0 || *data.first + count - 1 < 0)
    return refused(formatted("first: found {} for {}, wanted {} to 0, so that the segment's own is among them",
                             *data.first, counted(increments, "increment"), 1 - count));
  return *data.first;
}

}  // namespace

Expected<Rows> Rows::parse(const BlendingData& data) {
  Rows made;
  made.basis_ = data.basis;
  const std::size_t extra = made.is_bezier() ? 1 : 0, rows = data.rows.size();
  if (rows < 1 + extra || rows > BlendingFamily::most_rows + extra)
    return refused(formatted("rows: found {}, wanted {} to {}", rows, 1 + extra, BlendingFamily::most_rows + extra));
  std::size_t characters = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    const auto& row = data.rows[k];
    if (row.size() != data.rows.front().size())
      return refused(
          formatted("row {}: found {}, wanted {} as in row 1", k + 1, entries(row.size()), data.rows.front().size()));
    if (row.size() < 2 || row.size() > BlendingFamily::highest_degree + 1)
      return refused(formatted("row {}: found {}, wanted 2 to {}, for degree 1 to {}", k + 1, entries(row.size()),
                               BlendingFamily::highest_degree + 1, BlendingFamily::highest_degree));
    auto& parsed = made.rows_.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      characters += row[i].size();
      if (characters > BlendingFamily::most_characters)
        return refused(formatted("rows: found more than {} characters, wanted fewer", BlendingFamily::most_characters));
      auto entry = Expression::parse(row[i], data.parameters.size());
      if (!entry) return refused(formatted("row {}, entry {}, {}", k + 1, i + 1, entry.error().message));
      parsed.push_back(std::move(*entry));
    }
  }
  return first_of(data, made.increments()).map([&](int first) {
    made.first_ = first;
    return std::move(made);
  });
}

int Rows::coefficient_reach() const noexcept {
  int farthest = 0;
  for (const auto& row : rows_)
    for (const Expression& entry : row)
      for (const Quantity& q : entry.quantities()) {
        const int behind = q.kind == Quantity::Kind::parameter ? q.offset - 1 : q.offset;
        farthest = std::max({farthest, -q.offset, behind});
      }
  return farthest;
}

bool Rows::parameters_reach_out() const noexcept {
  const auto is_out = [](const Quantity& q) {
    return q.kind == Quantity::Kind::parameter && q.offset != 0 && q.offset != 1;
  };
  return std::ranges::any_of(rows_, [&](const auto& row) {
    return std::ranges::any_of(row, [&](const Expression& e) { return std::ranges::any_of(e.quantities(), is_out); });
  });
}

std::vector<std::string> Rows::doubtful_divisors() const {
  std::vector<std::string> divisors;
  for (const auto& row : rows_)
    for (const Expression& entry : row)
      for (const std::string& divisor : entry.doubtful_divisors())
        if (std::ranges::find(divisors, divisor) == divisors.end()) divisors.push_back(divisor);
  return divisors;
}

}}}  // namespace orispline::blending
