// SPDX-License-Identifier: Apache-2.0
#include "papers/identities.hpp"

#include <algorithm>

namespace orispline::cli {

namespace {

using report::Notation;

double largest_of(double (*error)(Dice&)) {
  Dice dice(20180101);
  double largest = 0.0;
  for (int k = 0; k < draws_of_identities; ++k) largest = std::max(largest, error(dice));
  return largest;
}

}  // namespace

report::Table identities_table(std::string title, std::span<const std::span<const Identity>> parts,
                               std::vector<std::string> notes) {
  report::Table table{.title = std::move(title),
                      .columns = {{"equation"}, {"statement"}, {"largest error", Notation::scientific, 1}},
                      .notes = std::move(notes)};
  for (const std::span<const Identity> part : parts)
    for (const Identity& identity : part)
      table.rows.push_back({std::string(identity.number), std::string(identity.statement), largest_of(identity.error)});
  return table;
}

report::Table misprints_table(std::span<const Misprint> misprints) {
  report::Table table{.title = "What is wrong as printed",
                      .columns = {{"equation"},
                                  {"printed"},
                                  {"error", Notation::scientific, 1},
                                  {"right"},
                                  {"its error", Notation::scientific, 1}}};
  for (const Misprint& m : misprints)
    table.rows.push_back({std::string(m.number), std::string(m.printed), largest_of(m.error_as_printed),
                          std::string(m.right), largest_of(m.error_corrected)});
  table.notes = {"docs/errata.md has more of these, and how we know."};
  return table;
}

}  // namespace orispline::cli
