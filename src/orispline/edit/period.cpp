// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/edit/channel_path.hpp>
#include <orispline/edit/loop.hpp>
#include <orispline/edit/up_axis.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double rate_weight = 0.1;  // a difference of rates counts as the angle that it makes in so long a time [s]

/// The numbers that a skeleton is compared by, one row for each time: squares of differences of rows add up.
class PoseRows {
 public:
  explicit PoseRows(std::vector<double> times) : times_(std::move(times)) {}

  /// Of a rotation: twice its quaternion, whose differences are angles where they are small; of the root where up is
  /// in its frame, which its heading does not change.
  Expected<void> add(const RotationChannel& channel, const Eigen::Vector3d* up) {
    if (rests(channel)) return {};
    return meant_curve(channel).map([&](const AnyCurve& curve) {
      const std::size_t width = (up ? 3 : 4) + 3;
      std::vector<double> column;
      for (const double t : times_) {
        const Motion motion = curve.motion(t);
        if (up) append(column, to_body<double>(motion.orientation, *up));
        else append(column, Eigen::Vector4d(2.0 * motion.orientation.coeffs()));
        append(column, Eigen::Vector3d(rate_weight * motion.angular_velocity));
      }
      columns_.push_back({width, !up, std::move(column)});
    });
  }

  /// Of a vector, as shares of its extent; of the root along up alone.
  Expected<void> add(const VectorChannel& channel, const Eigen::Vector3d* up) {
    if (rests(channel)) return {};
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& value : channel.values) box.extend(value);
    const double extent = box.diagonal().norm();
    return meant_curve(channel).map([&](const AnyPath& path) {
      std::vector<double> column;
      for (const double t : times_) {
        const LinearMotion motion = path.linear_motion(t);
        const auto counted = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
          return (up ? Eigen::Vector3d(*up * up->dot(v)) : v) / extent;
        };
        append(column, counted(motion.position));
        append(column, Eigen::Vector3d(rate_weight * counted(motion.velocity)));
      }
      columns_.push_back({6, false, std::move(column)});
    });
  }

  [[nodiscard]] double square_between(std::size_t i, std::size_t j) const {
    double sum = 0.0;
    for (const Column& column : columns_) {
      const double *a = &column.numbers[i * column.width], *b = &column.numbers[j * column.width];
      double sign = 1.0;
      if (column.is_quaternion) sign = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0.0 ? -1.0 : 1.0;
      for (std::size_t k = 0; k < column.width; ++k) {
        const double off = a[k] - (column.is_quaternion && k < 4 ? sign : 1.0) * b[k];
        sum += off * off;
      }
    }
    return sum;
  }

  [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }

 private:
  struct Column {
    std::size_t width;
    bool is_quaternion;  ///< its first four numbers
    std::vector<double> numbers;
  };

  static void append(std::vector<double>& column, const auto& numbers) {
    column.insert(column.end(), numbers.data(), numbers.data() + numbers.size());
  }

  std::vector<double> times_;
  std::vector<Column> columns_{};
};

Expected<PoseRows> rows_of(const Skeleton& skeleton, const Clip& clip, const LoopRoot& root) {
  PoseRows rows(key_times(clip));
  const Eigen::Vector3d up = root.joint == no_parent ? root.up : up_in_parent(skeleton, clip, root.joint, root.up);
  const auto up_of = [&](const auto& channel) { return channel.joint == root.joint ? &up : nullptr; };
  Expected<void> added{};
  const auto add = [&](const auto& channels) {
    for (const auto& channel : channels)
      if (added) added = rows.add(channel, up_of(channel));
  };
  add(clip.rotations);
  add(clip.translations);
  return added.map([&] { return std::move(rows); });
}

}  // namespace

Expected<Domain> best_period(const Skeleton& skeleton, const Clip& clip, Domain periods, const LoopRoot& root) {
  return rows_of(skeleton, clip, root).and_then([&](const PoseRows& rows) -> Expected<Domain> {
    const std::vector<double>& times = rows.times();
    const double rounding = times.empty() ? 0.0 : 0x1p-22 * std::max(std::abs(times.front()), std::abs(times.back()));
    double least = std::numeric_limits<double>::infinity();
    Domain best{0.0, 0.0};
    for (std::size_t i = 0; i < times.size(); ++i)
      for (std::size_t j = i + 2; j < times.size() && times[j] - times[i] <= periods.end + rounding; ++j) {
        if (times[j] - times[i] < periods.start - rounding) continue;
        const double square = rows.square_between(i, j);
        if (square < least) least = square, best = {times[i], times[j]};
      }
    if (best.start < best.end) return best;
    const std::string apart = std::isinf(periods.end) ? formatted("at least {:g} s", periods.start)
                                                      : formatted("{:g} s to {:g} s", periods.start, periods.end);
    return bad_option("period_from", formatted("clip {}: found no two keys {} apart with one between them, wanted a "
                                               "period that the clip has room for",
                                               in_quotes(clip.name), apart));
  });
}

}}  // namespace orispline
