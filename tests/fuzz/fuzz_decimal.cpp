// SPDX-License-Identifier: Apache-2.0
// Two lines of text as decimals: what is written reads back the same, they are ordered and rounded as the numbers are.
#include <cmath>
#include <limits>
#include <string>

#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>
#include <orispline/base/decimal.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline::fuzz { namespace {

void claim_written_and_read_back(const Decimal& x) {
  const auto again = Decimal::parse(x.to_string());
  claim(again.has_value() && *again == x, "{} is not read back", x.to_string());
  std::string appended = "t";
  x.append_to(appended);
  claim(appended == "t" + x.to_string(), "append_to() writes {}", appended);
}

/// A cell that is a decimal is a number, and the other way round where it is finite and within the range of decimals.
void claim_agreement_with_number_of(std::string_view text) {
  const auto decimal = Decimal::parse(text);
  const auto number = io::number_of(text);
  if (!number) return claim(!decimal, "a decimal that is no number: '{}'", text);
  if (decimal) claim(decimal->to_double() == *number, "{} is {} as a number", decimal->to_double(), *number);
  const auto cell = io::decimal_of(text);
  if (cell && *cell) claim(decimal && **cell == *decimal, "the cell '{}' is another decimal", text);
  if (cell && !*cell) claim(!std::isfinite(*number), "the cell '{}' is no decimal", text);
  if (!cell) claim_plain(cell.error());
}

void claim_shortest_text(double x) {
  if (!std::isfinite(x)) return;
  char room[shortest_text_room];
  const std::string_view text(room, static_cast<std::size_t>(write_shortest_text(room, x) - room));
  claim(text.size() <= longest_shortest_text, "a text of {} characters", text.size());
  claim(io::number_of(text).value() == x, "{} reads as another number", text);
  claim(Decimal::from_double(x).to_double() == x, "{} is another number as a decimal", text);
}

void claim_order(const Decimal& a, const Decimal& b) {
  claim((a < b) == (b > a) && (a == b) == (b == a) && (a < b) + (a == b) + (b < a) == 1, "no order");
  if (a < b)
    claim(a.to_double() <= b.to_double(), "rounding turns the order of {} and {}", a.to_string(), b.to_string());
  claim(a + b == b + a && a * b == b * a, "sum or product depend on the order");
  claim(-(-a) == a && (a - a) == Decimal(), "minus twice, or a difference, is another number");
  claim(a.rounded().is_whole(), "{} is not whole", a.rounded().to_string());
}

void claim_origin(const Decimal& time, double offset) {
  if (!std::isfinite(offset)) return;
  const TimeOrigin origin(time);
  const double wanted = origin.plus(offset).to_double(), found = origin.nearest_plus(offset);
  claim(found == wanted, "nearest_plus() gives {}, wanted {}", found, wanted);
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  const std::string_view text = FuzzInput(data, size).rest();
  const std::string_view first = text.substr(0, text.find('\n'));
  const std::string_view second = text.substr(std::min(text.size(), first.size() + 1));
  const Situation situation([&] { return fmt::format("decimals '{}' and '{}'", first, second); });
  for (const std::string_view one : {first, second}) {
    claim_agreement_with_number_of(one);
    if (const auto number = io::number_of(one)) claim_shortest_text(*number);
    if (const auto decimal = Decimal::parse(one)) claim_written_and_read_back(*decimal);
    else claim_plain(decimal.error());
  }
  const auto a = Decimal::parse(first), b = Decimal::parse(second);
  if (a && b) {
    claim_order(*a, *b);
    claim_origin(*a, b->to_double());
  }
  return 0;
}
