// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/inspect.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/jobs/curve_of_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

Expected<InspectOutcome> inspect(InspectRequest request) {
  const Track& keys = *request.keys;
  InspectOutcome outcome{
      .request = std::move(request), .statistics = key_statistics(keys.keys), .keyframes = keys.keys.report()};
  auto stretches = stretches_of(keys);
  if (!stretches) return tl::unexpected(placed(keys, std::move(stretches.error())));
  outcome.stretches = stretches->empty() ? std::vector<Stretch>{{0, keys.keys.size()}} : std::move(*stretches);
  const KeyFaults& faults = outcome.request.faults;
  outcome.keyframes.non_unit_keys += faults.wrong_norms;
  outcome.keyframes.largest_norm_error = std::max(outcome.keyframes.largest_norm_error, faults.largest_norm_error);
  const auto labels = labels_of(outcome.request.methods);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Method& method = outcome.request.methods[i];
    auto shaped = curve_of_keys(method, keys);
    if (!shaped) return tl::unexpected(std::move(shaped.error()));
    const AnyCurve& curve = shaped->curve.orientation;
    const Seam seam = method.options.loop ? Seam::closed : Seam::open;
    const Continuities found = continuities_at_keys(curve, seam);
    outcome.methods.push_back({labels[i], found.in_time, found.of_shape, shaped->findings});
    outcome.curves.push_back(std::move(shaped->curve));
    std::ranges::move(shaped->warnings, std::back_inserter(outcome.warnings));
  }
  return outcome;
}

}}}  // namespace orispline::jobs
