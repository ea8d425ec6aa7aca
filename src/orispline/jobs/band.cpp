// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/band.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/families/measured.hpp>
#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

Expected<Band> band_of(const Track& keys, const Method& method, double share) {
  const auto placed = [&](Error error) {
    if (error.code == ErrorCode::bad_argument) error.option = "band";
    return keys.located(std::move(error));
  };
  if (SmoothedBand::is_of(keys, method))
    return SmoothedBand::make(keys, share)
        .map([](SmoothedBand band) { return Band(std::move(band)); })
        .map_error(placed);
  if (method.name != families::Measured::info.name)
    return bad_option("band", formatted("method '{}' has no band, wanted '{}', or keys that smooth wrote with `sigma`",
                                        method.name, families::Measured::info.name));
  return stretches_of(keys)
      .and_then([&](const std::vector<Stretch>& stretches) {
        return BandInStretches::make(method, keys.keys, stretches, share);
      })
      .map([](BandInStretches band) { return Band(std::move(band)); })
      .map_error(placed);
}

}}}  // namespace orispline::jobs
