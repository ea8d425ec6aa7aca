// SPDX-License-Identifier: Apache-2.0
#include "commands/align/align_recordings.hpp"

#include <utility>

#include <orispline/io/rates_file.hpp>

#include "output/gathered_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

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
