// SPDX-License-Identifier: Apache-2.0
#include "commands/gyro_files.hpp"

#include <utility>

#include <orispline/io/key_input.hpp>
#include <orispline/io/rates_file.hpp>

#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

void append(GyroRates& gyro, const io::RateRows& rows, std::size_t k, const Decimal& epoch) {
  gyro.times.push_back((rows.exact_times[k] - epoch).to_double());
  gyro.rates.push_back(rows.rates[k]);
  gyro.exact_times.push_back(rows.exact_times[k]);
  gyro.lines.push_back(rows.lines[k]);
}

GyroRates rates_of_file(const std::string& path, const io::RateRows& rows, const Decimal& epoch) {
  GyroRates gyro{.clock = GyroRates::Clock::own, .name = path};
  for (std::size_t k = 0; k < rows.rates.size(); ++k) append(gyro, rows, k, epoch);
  return gyro;
}

/// The rates of all rows, in the order of their times.
Expected<GyroRates> rates_of_rows(const io::TrackFile& file) {
  const io::RateRows& unposed = file.unposed;
  if (unposed.rates.empty()) return gyro_rates_in(file.track);
  const Track& track = file.track;
  GyroRates gyro;
  std::size_t row = 0;
  const auto rates = track.keys.angular_velocities();
  for (std::size_t key = 0; key <= track.keys.size(); ++key) {
    const bool is_end = key == track.keys.size();
    for (; row < unposed.rates.size() && (is_end || unposed.exact_times[row] < track.exact_times[key]); ++row)
      append(gyro, unposed, row, track.epoch);
    if (is_end) break;
    if (row < unposed.rates.size() && unposed.exact_times[row] == track.exact_times[key]) ++row;
    if (is_free(rates[key])) continue;
    gyro.times.push_back(track.keys.times()[key]);
    gyro.rates.push_back(rates[key]);
    gyro.exact_times.push_back(track.exact_times[key]);
    gyro.lines.push_back(track.lines[key]);
  }
  return gyro;
}

GyroTrack gyro_of(const std::string& path, io::RateRows rows) {
  GyroTrack gyro{.epoch = rows.exact_times.front()};
  gyro.rates.clock = GyroRates::Clock::own;
  gyro.rates.name = path;
  for (const Decimal& time : rows.exact_times) gyro.rates.times.push_back((time - gyro.epoch).to_double());
  gyro.rates.rates = std::move(rows.rates);
  gyro.rates.exact_times = std::move(rows.exact_times);
  gyro.rates.lines = std::move(rows.lines);
  return gyro;
}

Expected<AlignedFile> read_gyro(io::KeyInput input, const io::ReadOptions& read) {
  const std::string path = input.path();
  return io::read_rates(std::move(input), read).map([&](io::RateRows rows) -> AlignedFile {
    warn(rows.warnings);
    return gyro_of(path, std::move(rows));
  });
}

AlignedFile told(io::TrackFile file) {
  warn(file.warnings);
  return file;
}

}  // namespace

Expected<GyroTrack> gyro_beside(const io::TrackFile& file, const std::optional<std::string>& gyro_file,
                                const io::ReadOptions& read) {
  const auto track = [&](GyroRates gyro) { return GyroTrack{.rates = std::move(gyro), .epoch = file.track.epoch}; };
  if (!gyro_file)
    return rates_of_rows(file).map(track).map_error([&](Error error) { return file.track.located(std::move(error)); });
  return io::read_rates(*gyro_file, read).map([&](const io::RateRows& rows) {
    warn(rows.warnings);
    return track(rates_of_file(*gyro_file, rows, file.track.epoch));
  });
}

Expected<AlignedFile> read_moved(const InputRequest& request) {
  return io::KeyInput::open(request.path, request.read).and_then([&](io::KeyInput input) -> Expected<AlignedFile> {
    if (io::holds_rates_alone(input, request.read)) return read_gyro(std::move(input), request.read);
    return io::read_track(std::move(input), request.read, request.signs).map(told);
  });
}

Expected<AlignedFile> read_fixed(const AlignedFile& moved, const std::string& path, const io::ReadOptions& read) {
  io::ReadOptions beside = read;
  beside.recipe = io::RecipeUse::ignored;
  auto input = io::KeyInput::open(path, beside);
  if (!input) return tl::unexpected(std::move(input.error()));
  if (io::holds_rates_alone(*input, beside)) return read_gyro(std::move(*input), beside);
  const auto* const other = std::get_if<io::TrackFile>(&moved);
  if (other && path != io::standard_stream) return io::read_track_beside(*other, path, read).map(told);
  return io::read_track(std::move(*input), beside, Signs::shortest).map(told);
}

Expected<void> write_aligned_rates(const std::string& path, const GyroTrack& gyro) {
  io::RateRows rows{.rates = gyro.rates.rates};
  for (std::size_t k = 0; k < rows.rates.size(); ++k) rows.exact_times.push_back(gyro.time_of(k));
  return open_output(path).and_then([&](Noted<io::OutputFile> output) {
    return io::write_rates(output.file, rows).and_then([&] { return put_in_place(std::move(output)); });
  });
}

}  // namespace orispline::cli
