// SPDX-License-Identifier: Apache-2.0
// A text as a file of sample times, relative to the first number in it or to zero.
#include <cmath>

#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>
#include <fuzz/temporary_file.hpp>
#include <orispline/io/times_file.hpp>

namespace orispline::fuzz { namespace {

void claim_sound(const io::TimesList& list) {
  claim(list.times.size() == list.lines.size(), "{} times, {} lines", list.times.size(), list.lines.size());
  for (std::size_t i = 0; i < list.times.size(); ++i) {
    claim(std::isfinite(list.times[i]), "time {} is {}", i, list.times[i]);
    claim(list.lines[i] > (i == 0 ? 0 : list.lines[i - 1]), "time {} is of line {}", i, list.lines[i]);
  }
}

/// The times written one to a line, as the shortest text, are the same times.
void claim_read_back(const TemporaryFolder& folder, const io::TimesList& list) {
  std::string text = "t_s\n";  // the unit of a huge time would be guessed
  for (const double t : list.times) text += Decimal::from_double(t).to_string() + "\n";
  const auto again = io::read_times(folder.write("again.csv", text), Decimal());
  claim(again.has_value() && again->times == list.times, "the times are not read back");
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  static const TemporaryFolder folder;
  FuzzInput input(data, size);
  Flags flags(input);
  const Decimal epoch = flags.next() ? Decimal::parse("1700000000.123456789").value() : Decimal();
  const std::string path = folder.write("times.csv", input.rest());
  const auto list = io::read_times(path, epoch);
  if (!list) return claim_plain(list.error()), 0;
  claim_sound(*list);
  claim_read_back(folder, *list);
  return 0;
}
