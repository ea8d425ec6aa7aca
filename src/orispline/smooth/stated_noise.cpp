// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/stated_noise.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// One way to state it: a column for all axes, or one for each.
struct Form {
  std::span<const std::string_view> names;
  double unit;  // [rad], of variances [rad²]
  bool are_variances;
};

constexpr std::array forms{Form{std::span(noise_columns).subspan(0, 1), 1.0, false},
                           Form{std::span(noise_columns).subspan(1, 1), 1.0 / degrees, false},
                           Form{std::span(noise_columns).subspan(2, 3), 1.0, false},
                           Form{std::span(noise_columns).subspan(5, 3), 1.0, true}};

Expected<std::vector<double>> noise_of(const Track& recording, const Form& form) {
  std::vector<double> sums(recording.keys.size(), 0.0);
  for (const std::string_view name : form.names) {
    const auto column = recording.settings.find(name);
    if (column == recording.settings.end())
      return failure(ErrorCode::bad_data, formatted("found no {}, wanted it beside the noise of the other axes", name));
    for (std::size_t key = 0; key < sums.size(); ++key) {
      const double value = column->second[key];
      if (!(value > 0.0) || !std::isfinite(value))
        return failure(ErrorCode::bad_data, formatted("{}: found {}, wanted a finite number above 0", name, value),
                       {.key = key});
      sums[key] += form.are_variances ? value : value * value;
    }
  }
  for (double& sum : sums) sum = form.unit * std::sqrt(sum / static_cast<double>(form.names.size()));
  return sums;
}

bool is_stated(const Track& recording, const Form& form) {
  return std::ranges::any_of(form.names, [&](std::string_view name) { return recording.settings.contains(name); });
}

}  // namespace

Expected<std::vector<double>> stated_noise(const Track& recording) {
  const Form* found = nullptr;
  for (const Form& form : forms) {
    if (!is_stated(recording, form)) continue;
    if (found)
      return failure(ErrorCode::bad_data, formatted("found {} and {}, wanted the noise of the samples in one form",
                                                    found->names.front(), form.names.front()));
    found = &form;
  }
  return found ? noise_of(recording, *found) : Expected<std::vector<double>>();
}

void forget_stated_noise(Track& track) {
  for (const std::string_view name : noise_columns)
    if (const auto column = track.settings.find(name); column != track.settings.end()) track.settings.erase(column);
  track.forget_band();
}

}}  // namespace orispline
