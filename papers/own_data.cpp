// SPDX-License-Identifier: Apache-2.0
#include "papers/own_data.hpp"

#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/track_file.hpp>

#include "output/standard_output.hpp"
#include "papers/flight.hpp"

namespace orispline::cli {

namespace {

Expected<Flight> own_flight(const io::TrackFile& keys, const std::string& reference, const std::string& note) {
  return io::read_track_beside(keys, reference, {}).and_then([&](const io::TrackFile& recording) {
    warn(recording.warnings);
    return beside_recording(keys.track, recording.track).and_then([&](const ComparedData& data) {
      warn(data.warnings);
      return flight_of(data,
                       formatted("{} keys of {}", keys.track.keys.size(), printable(file_name_of(keys.track.name))))
          .map([&](Flight flight) {
            flight.note = formatted(
                "{} The truth is that of {}{}.", note, printable(reference),
                any_given(data.samples.angular_velocities()) ? "" : "; its rates are those of `auto` through it");
            return flight;
          });
    });
  });
}

KeysInstead instead(const Track& track, std::string note) {
  KeysInstead keys{track.keys, std::move(note), track.as_read};
  for (Eigen::Quaterniond& q : keys.as_given) q.normalize();
  return keys;
}

}  // namespace

Expected<OwnData> read_own_data(const std::string& keys, const std::optional<std::string>& reference) {
  constexpr std::size_t least = 4;  // that every scheme takes
  const auto file = io::read_track(keys, {.keep_as_read = true});
  if (!file) return tl::unexpected(file.error());
  warn(file->warnings);
  if (const std::size_t count = file->track.keys.size(); count < least)
    return failure(ErrorCode::bad_data, formatted("found {} keys, wanted {} at least", count, least), {.file = keys});
  const std::string note = formatted("The keys are those of {}.", printable(keys));
  OwnData own{instead(file->track, note)};
  if (!reference) return own;
  return own_flight(*file, *reference, note).map([&](Flight flight) {
    own.flight = std::move(flight);
    return std::move(own);
  });
}

}  // namespace orispline::cli
