// SPDX-License-Identifier: Apache-2.0
// Some bytes of options, then a file of any format: what is read is whole, and the same when it is read in pieces or
// from the table that it was written to.
#include <array>
#include <cmath>
#include <concepts>
#include <cstring>
#include <type_traits>

#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>
#include <fuzz/temporary_file.hpp>
#include <orispline/curve/key_parts.hpp>
#include <orispline/io/key_reader.hpp>
#include <orispline/io/key_table.hpp>
#include <orispline/io/track_file.hpp>

namespace orispline::fuzz { namespace {

using io::KeyFile;
using io::ReadOptions;

constexpr std::array euler_orders{"ZYX", "XYZ", "ZXZ", "zyx", "xzy", "YXY", "yzx"};
constexpr std::array time_scales{"0.001", "1e-9", "60", "1e3", "3.3", "1e-30", "1e30"};
constexpr std::array<std::array<const char*, 2>, 7> mapped_names{
    {{"t", "time_ms"}, {"qw", "w"}, {"wx", "wx"}, {"px", "x_mm"}, {"e1", "a_deg"}, {"r11", "m"}, {"rx", "v"}}};

/// Nothing for zero, else one of the list.
template <class List>
auto chosen(FuzzInput& input, const List& list) -> std::optional<typename List::value_type> {
  const std::size_t choice = input.below(list.size() + 1);
  return choice == 0 ? std::nullopt : std::optional(list[choice - 1]);
}

io::OrientationReading orientation_reading(FuzzInput& input) {
  using enum io::Representation;
  io::OrientationReading reading;
  reading.representation = chosen(input, std::array{quaternion, euler, matrix, rotation_vector});
  if (const auto order = chosen(input, euler_orders)) reading.euler = euler_order_of(*order);
  reading.angle_unit = chosen(input, std::array{io::AngleUnit::degrees, io::AngleUnit::radians});
  return reading;
}

FrameChange axes(std::string_view world, std::string_view body) {
  return {.world = {.axes = axis_change_of(world, AxesOf::world).value()},
          .body = {.axes = axis_change_of(body, AxesOf::body).value()}};
}

const std::array frame_changes{FrameChange{}, axes("NED:ENU", "FRD:FLU"), axes("RUF:FLU", "RUF:FLU"),
                               FrameChange{.body = {.rotation = quaternion_wxyz(0.8, 0.0, 0.36, 0.48)}}};

ReadOptions read_options(FuzzInput& input) {
  ReadOptions options;
  options.format = chosen(input, io::formats_read()).value_or(nullptr);
  Flags flags(input);
  options.conjugate = flags.next();
  options.world_rates = flags.next();
  options.drop_duplicates = flags.next();
  options.drop_invalid = flags.next();
  options.sort = flags.next();
  options.keep_exact_times = flags.next();
  options.keep_as_read = flags.next();
  options.keep_table = flags.next();
  Flags more(input);
  options.rate_orders = static_cast<int>(more.next(4));
  if (more.next()) options.order = more.next() ? io::QuaternionOrder::xyzw : io::QuaternionOrder::wxyz;
  const bool is_plain = !more.next();
  options.frames = frame_changes[more.next(4)];
  options.inverse_poses = more.next() && !options.conjugate;
  options.inner_quaternions = more.next();
  if (is_plain) return options;
  options.orientation = orientation_reading(input);
  if (const auto scale = chosen(input, time_scales)) options.time_scale = Decimal::parse(*scale).value();
  if (const auto name = chosen(input, mapped_names)) options.columns.emplace((*name)[0], (*name)[1]);
  if (input.below(2) == 1) options.parameters = {"tension", "bias"};
  return options;
}

template <class T>
void claim_one_each(const char* what, const std::vector<T>& list, std::size_t keys) {
  claim(list.empty() || list.size() == keys, "{} {} of {} keys", list.size(), what, keys);
}

void claim_whole(const KeyFile& file, const ReadOptions& options) {
  const KeyframeData& data = file.data;
  const std::size_t keys = data.times.size();
  claim(keys > 0 && data.orientations.size() == keys, "{} times, {} orientations", keys, data.orientations.size());
  claim(data.times.front() == 0.0, "the first time is {} after the epoch", data.times.front());
  for (std::size_t i = 0; i < keys; ++i) {
    claim(std::isfinite(data.times[i]) && (i == 0 || data.times[i] > data.times[i - 1]), "time {} is {}", i,
          data.times[i]);
    claim(data.orientations[i].coeffs().allFinite(), "orientation {} is not finite", i);
  }
  for_each_part([&](const auto& part) {
    const auto& list = data.*part.list;
    claim_one_each(part.many, list, keys);
    for (std::size_t i = 0; i < list.size(); ++i)
      if constexpr (std::same_as<std::remove_cvref_t<decltype(list[i])>, Eigen::Vector3d>)
        claim(list[i].allFinite() || (part.check == check_rate && is_free(list[i])), "{} {} is not finite", part.one,
              i);
      else claim(!part.check(i, part.one, list[i]), "{} {} is none", part.one, i);
  });
  claim_one_each("lines", file.lines, keys);
  for (const auto& [name, values] : file.parameters) {
    claim_one_each("values", values, keys);
    for (const double value : values) claim(std::isfinite(value), "{} is {}", name, value);
  }
  claim(file.exact_times.size() == (options.keep_exact_times ? keys : 0), "{} exact times", file.exact_times.size());
  for (std::size_t i = 1; i < file.exact_times.size(); ++i)
    claim(file.exact_times[i - 1] < file.exact_times[i], "exact time {} does not rise", i);
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), sizeof(a[0]) * a.size()) == 0);
}

void claim_same(const KeyFile& found, const KeyFile& wanted) {
  const KeyframeData &a = found.data, &b = wanted.data;
  claim(found.epoch == wanted.epoch && a.times == b.times, "other times");
  claim(same_bits(a.orientations, b.orientations), "other orientations");
  for_each_part([&](const auto& part) { claim(same_bits(a.*part.list, b.*part.list), "other {}", part.many); });
  claim(found.parameters == wanted.parameters, "other parameters");
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Two keys at a time.
void claim_same_in_pieces(const std::string& path, const ReadOptions& options, const KeyFile& wanted) {
  auto reader = io::KeyReader::open(path, options);
  claim(reader.has_value(), "a file that is read whole cannot be read in pieces");
  KeyFile all{.epoch = wanted.epoch};
  for (const auto& [name, values] : wanted.parameters) all.parameters[name] = {};
  while (!reader->is_at_end()) {
    const auto piece = reader->next(2);
    claim(piece.has_value(), "a piece is refused: {}", piece ? "" : describe(piece.error()));
    append(all.data.times, piece->data.times);
    append(all.data.orientations, piece->data.orientations);
    for_each_part([&](const auto& part) { append(all.data.*part.list, piece->data.*part.list); });
    for (const auto& [name, values] : piece->parameters) append(all.parameters[name], values);
  }
  claim_same(all, wanted);
}

/// The rows that stayed, written as CSV, are read as the same keys.
void claim_same_from_its_table(const TemporaryFolder& folder, ReadOptions options, const KeyFile& wanted) {
  if (wanted.format->writing.table == nullptr || wanted.table.names.empty()) return;
  claim(wanted.table.rows.size() == wanted.data.times.size(), "a table of {} rows", wanted.table.rows.size());
  for (const auto& row : wanted.table.rows)
    claim(row.size() == wanted.table.names.size(), "a row of {} cells, {} names", row.size(),
          wanted.table.names.size());
  const std::string text = io::csv_with_columns(wanted.table, {});
  const Situation situation([&] { return "as CSV:\n" + text; });
  options.format = &io::csv_format;
  options.order.reset();  // it has a header
  const auto again = io::read_keys(folder.write("again.csv", text), options);
  claim(again.has_value(), "the table is refused: {}", again ? "" : describe(again.error()));
  claim_same(*again, wanted);
}

void claim_track_or_plain_error(const KeyFile& file) {
  for (const Signs signs : {Signs::shortest, Signs::as_given}) {
    const auto keys = Keyframes::make(file.data, signs);
    if (!keys) {
      claim_plain(io::located(file, keys.error()));
      continue;
    }
    for (const Eigen::Quaterniond& q : keys->orientations())
      claim(std::abs(q.norm() - 1.0) <= 1e-15, "a key of the norm {}", q.norm());
  }
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  static const TemporaryFolder folder;
  FuzzInput input(data, size);
  const ReadOptions options = read_options(input);
  const std::string_view text = input.rest();
  const std::string path = folder.write("keys.txt", text);
  const auto files = io::read_all_keys(path, options);
  if (!files) return claim_plain(files.error()), 0;
  claim(!files->empty(), "no track");
  for (const KeyFile& file : *files) {
    claim_whole(file, options);
    claim_track_or_plain_error(file);
  }
  if (files->size() > 1) return 0;
  claim_same_in_pieces(path, options, files->front());
  claim_same_from_its_table(folder, options, files->front());
  return 0;
}
