// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/gyro_input.hpp"

#include <utility>

#include <orispline/io/rates_file.hpp>

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

}  // namespace

Expected<std::shared_ptr<const GyroRates>> gyro_input(const io::TrackFile& file,
                                                      const std::optional<std::string>& gyro_file,
                                                      const io::ReadOptions& read) {
  const auto shared = [](GyroRates gyro) { return std::make_shared<const GyroRates>(std::move(gyro)); };
  if (!gyro_file)
    return rates_of_rows(file).map(shared).map_error([&](Error error) { return file.track.located(std::move(error)); });
  return io::read_rates(*gyro_file, read).map([&](const io::RateRows& rows) {
    warn(rows.warnings);
    return shared(rates_of_file(*gyro_file, rows, file.track.epoch));
  });
}

}  // namespace orispline::cli
