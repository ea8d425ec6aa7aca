// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/align.hpp>

#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/align_words.hpp>
#include <orispline/jobs/smoothing_words.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::string position_lines(const Alignment& a) {
  if (!a.translation) return "";
  const Eigen::Vector3d& d = *a.translation;
  const DistanceStatistics& left = *a.position_distance;
  return formatted("scale           {:.9g}{}\n", *a.scale, sigma_text(a.sigmas.scale, "")) +
         formatted("translation     {:.9g} m, {:.9g} m, {:.9g} m{}\n", d.x(), d.y(), d.z(),
                   sigmas_text(a.sigmas.translation, 1.0, " m")) +
         formatted("left            RMS {:.6g} m, median {:.6g} m, largest {:.6g} m between the positions\n", left.rms,
                   left.median, left.largest);
}

Json open_json(const std::vector<OpenDirection>& directions) {
  Json list = Json::array();
  for (const OpenDirection& open : directions)
    list.push_back({{"world", vector_json(open.world)},
                    {"body", vector_json(open.body)},
                    {"offset", open.offset},
                    {"scale", open.scale},
                    {"translation", vector_json(open.translation)}});
  return list;
}

}  // namespace

Expected<AlignOutcome> align(AlignRequest request, const Progress& progress) {
  auto alignment = orispline::align(*request.moved, *request.fixed, request.options, progress);
  if (!alignment) return tl::unexpected(std::move(alignment.error()));
  auto there = aligned(*request.moved, *request.fixed, *alignment);
  if (!there) return tl::unexpected(request.moved->located(std::move(there.error())));
  std::vector<Warning> warnings = std::exchange(alignment->warnings, {});
  return AlignOutcome{std::move(request), std::move(*alignment), std::move(*there), std::move(warnings)};
}

Json document_of(const AlignOutcome& outcome) {
  const Alignment& alignment = outcome.alignment;
  Json json{{"samples", outcome.request.moved->keys.size()},
            {"reference_samples", outcome.request.fixed->keys.size()},
            {"world", rotation_json(alignment.world)},
            {"body", rotation_json(alignment.body)}};
  const Places places = places_of(*outcome.request.fixed);
  for (const FieldInfo& field : fields_of<Alignment>()) put(json, alignment, {field.name}, places);
  json["open"] = open_json(alignment.open);
  return json;
}

std::string summary_of(const AlignOutcome& outcome) {
  const Alignment& a = outcome.alignment;
  const DistanceStatistics& left = a.distance;
  return formatted("{} onto {}\n", keys_text(*outcome.request.moved, "sample"),
                   keys_text(*outcome.request.fixed, "sample")) +
         formatted("offset          {} s{}\n", a.offset.to_string(), sigma_text(a.sigmas.offset, " s")) +
         formatted("world           {}{}\n", rotation_text(a.world), sigmas_text(a.sigmas.world, degrees, "°")) +
         formatted("body            {}{}\n", rotation_text(a.body), sigmas_text(a.sigmas.body, degrees, "°")) +
         formatted("left            RMS {:.6g}°, median {:.6g}°, largest {:.6g}° between the orientations\n",
                   left.rms * degrees, left.median * degrees, left.largest * degrees) +
         position_lines(a) +
         formatted("rejected        {} of {}{}\n", a.rejected.size(), counted(a.compared.size(), "sample"),
                   places_text(a.rejected, *outcome.request.fixed));
}

std::string line_of(const AlignOutcome& outcome) {
  const Alignment& a = outcome.alignment;
  return formatted("{} aligned, {} s late, RMS {:.4g}° from {}", counted(outcome.aligned.keys.size(), "sample"),
                   a.offset.to_string(), a.distance.rms * degrees,
                   shown_name(outcome.request.fixed->name, "the other recording"));
}

}}}  // namespace orispline::jobs
