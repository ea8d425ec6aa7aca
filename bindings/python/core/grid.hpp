// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <orispline/batch/sample_grid.hpp>

namespace orispline::python {

/// The even times that Python asks for, as text: a rate (a number or a fraction) or a count, and where they begin and
/// end.
struct GridText {
  std::optional<std::string> rate;
  std::optional<std::size_t> count;
  std::optional<std::string> start, end;
  bool include_end = false;

  /// Where they begin, if that is said.
  [[nodiscard]] Expected<std::optional<Decimal>> begin() const;
  /// Of a curve from `first` to `last` [s], as the command has them.
  [[nodiscard]] Expected<SampleGrid> grid(double first, double last) const;
};

}  // namespace orispline::python
