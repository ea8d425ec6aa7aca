// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/round_clock.hpp>
#include <orispline/io/row_reader.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

struct KeyRow;

/// Of a quaternion that is too far from a unit one to be read without being asked.
[[nodiscard]] Error norm_refused(double norm, Where where);

/// Gathers the keys of a table row by row, checks and repairs them. They may be taken out in pieces.
class KeyRows {
 public:
  KeyRows(std::string path, const FormatInfo& format, KeyColumns columns, const ReadOptions& options);

  /// Reads the row that the table stands at. Errors (bad_data): a cell is no number, the time does not increase.
  [[nodiscard]] Expected<void> add(const TextTable& table);
  /// Says that there are no more rows, and orders those that were gathered. Errors (bad_data): there were no keys at
  /// all; two that were sorted have the same time.
  [[nodiscard]] Expected<void> complete();
  /// Takes the gathered keys out.
  [[nodiscard]] KeyFile take();

  /// Keys that are gathered.
  [[nodiscard]] std::size_t size() const noexcept { return file_.lines.size(); }
  /// Whether all rows must be there before any of them is a key.
  [[nodiscard]] bool needs_all() const noexcept { return options_.sort || options_.session || options_.clock.round; }
  /// Whether the rows, of which there are no more, have orientations and positions at different times.
  [[nodiscard]] bool are_two_tracks() const noexcept { return !file_.positions_apart.is_empty(); }
  /// Recordings in the rows of one that needs all.
  [[nodiscard]] std::size_t sessions() const { return recordings().size(); }
  [[nodiscard]] const KeyColumns& columns() const noexcept { return columns_; }

 private:
  /// Where a row stands, for what is said of it, and what is kept of it.
  struct Place {
    std::size_t line;
    std::string_view time;  // as it is written
    std::span<const std::string_view> cells;
  };
  /// A row with an orientation or a position only.
  struct Part {
    KeyRow key;
    Error missing;
    std::size_t line;
    std::string time;
    std::vector<std::string> cells;
  };
  /// A row whose time does not rise: what that means shows in the rows behind it.
  struct Unrising {
    Decimal time;
    std::string text;
    std::size_t line = 0;
    std::vector<Decimal> after{};
    double turn = 0.0;  // [rad] from the row before
  };
  struct Pose {
    Eigen::Quaterniond orientation;
    Eigen::Vector3d position, rate;
  };
  using InnerQuaternions = std::array<Eigen::Quaterniond, inner_names.size()>;

  [[nodiscard]] Place place_of(const TextTable& table) const;
  [[nodiscard]] Where where(std::size_t line, std::optional<std::size_t> column = std::nullopt) const;
  [[nodiscard]] Expected<void> refused(Error error) const;
  [[nodiscard]] Expected<void> add_part(KeyRow key, Error missing, const TextTable& table);
  [[nodiscard]] Expected<void> settle_parts();
  [[nodiscard]] Expected<void> take_two_tracks();
  [[nodiscard]] Expected<void> append(const KeyRow& key, const Place& place);
  [[nodiscard]] Expected<void> append_between(const KeyRow& key, const Place& place);
  [[nodiscard]] Expected<Eigen::Quaterniond> orientation_of(const Eigen::Quaterniond& stated, std::size_t line,
                                                            std::optional<std::size_t> column = std::nullopt);
  [[nodiscard]] Expected<InnerQuaternions> inner_of(const KeyRow& key, std::size_t line);
  [[nodiscard]] Eigen::Vector3d position_in_world(const Eigen::Vector3d& stated) const;
  void append_motion(const KeyRow& key, const Eigen::Quaterniond& orientation);
  [[nodiscard]] Expected<void> add_unposed(const KeyRow& key, const TextTable& table);
  [[nodiscard]] Expected<Eigen::Quaterniond> normalised(Eigen::Quaterniond q, std::size_t line,
                                                        std::optional<std::size_t> column);
  [[nodiscard]] Expected<void> settle_clock(KeyRow& key, const TextTable& table);
  void settle_time_unit(const Decimal& first);
  void warn_of_long_steps();

  // The order of the rows, in key_order.cpp.
  [[nodiscard]] Expected<void> look_ahead(const TextTable& table);
  [[nodiscard]] Expected<bool> append_time(const Decimal& time, std::string_view text, std::size_t line,
                                           const Pose& pose);
  [[nodiscard]] Error out_of_order() const;
  [[nodiscard]] std::string beside_leap_second(const Unrising& row) const;
  [[nodiscard]] bool is_zero_stamp() const;
  [[nodiscard]] double turn_to(const Pose& pose) const;
  [[nodiscard]] bool jumps_to(const Pose& pose) const;
  void note_duplicate(const Pose& dropped);
  void warn_of_duplicates();
  [[nodiscard]] std::vector<std::size_t> recordings() const;
  [[nodiscard]] Expected<std::vector<std::uint32_t>> chosen_rows();
  [[nodiscard]] Expected<void> arrange();
  void choose_unposed(std::size_t first, std::size_t end);

  KeyColumns columns_;
  ReadOptions options_;
  NewFrames frames_;
  KeyFile file_;
  std::optional<RoundClock> round_clock_{};
  bool saw_leap_second_ = false;
  std::optional<bool> has_iso_times_{};  // unknown before the first row
  bool unit_is_assumed_ = false;         // seconds, since nothing tells
  bool looked_at_steps_ = false;
  std::size_t taken_ = 0;        // keys that are no longer in the file
  Decimal first_, latest_;       // times in the unit of the file
  double latest_seconds_ = 0.0;  // of `latest_` since the first [s]
  std::size_t latest_line_ = 0;  // of `latest_`
  std::optional<Pose> latest_pose_{};
  bool latest_jumps_ = false;  // it has the time of the one before
  std::size_t differing_duplicates_ = 0;
  std::optional<Unrising> unrising_{};
  EulerTurns turns_;                // that the keys so far lose
  std::vector<Decimal> times_;      // of all rows, gathered only to be ordered
  std::vector<Part> parts_{};       // before the first row that has both
  bool may_be_parts_;               // until then
  std::optional<KeyRow> before_{};  // of which the turns are counted to the next
};

}}}  // namespace orispline::io
