// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <orispline/batch/sample.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/online/stream_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The keys that the next segments need, and the segments of one method by their place in a ring.
class OnlineSegments {
 public:
  virtual ~OnlineSegments() = default;
  /// True where keys and segments are put on the heap one by one.
  [[nodiscard]] virtual bool allocates() const noexcept = 0;

  /// Takes the next key, which is checked: its orientation is of unit norm as `unit` says, with the sign chosen.
  virtual void push(const StreamKey& key, const Eigen::Quaterniond& unit) = 0;
  /// Takes the newest key back.
  virtual void pop() noexcept = 0;
  virtual void reset() noexcept = 0;
  /// Makes the segment whose first key came `behind` keys before the newest. Errors: those of make_curve().
  [[nodiscard]] virtual Expected<Domain> store(std::size_t place, std::size_t behind, Stream stream) = 0;

  [[nodiscard]] virtual Eigen::Quaterniond orientation(double t, std::size_t place) const noexcept = 0;
  [[nodiscard]] virtual Motion motion(double t, Side side, std::size_t place) const noexcept = 0;
  [[nodiscard]] virtual LinearMotion linear_motion(double t, Side side, std::size_t place) const noexcept = 0;

  /// Writes samples of one segment, from sample `at` on, with the bits that the whole curve has in bulk.
  virtual void sample(std::span<const double> times, std::size_t place, const Samples<double>& out,
                      std::size_t at) const = 0;
};

/// The samples of a curve on one of its segments, from sample `at` on.
ORISPLINE_EXPORT void sample_on_segment(const PoseCurve& curve, std::size_t segment, std::span<const double> times,
                                        const Samples<double>& out, std::size_t at);

/// Segments that blend two or four keys and hold all that they depend on: nothing is allocated after construction. Null
/// where the method has no such segments, or its keys bring settings of their own.
[[nodiscard]] ORISPLINE_EXPORT std::unique_ptr<OnlineSegments> segments_in_place(const StreamMethod& method,
                                                                                 std::size_t places);

/// Segments of any local method: each is the middle of a curve through its own keys and those beside them.
[[nodiscard]] ORISPLINE_EXPORT std::unique_ptr<OnlineSegments> segments_of_windows(const StreamMethod& method,
                                                                                   std::size_t places);

/// The names of the methods whose segments depend on a few keys.
[[nodiscard]] ORISPLINE_EXPORT std::span<const std::string_view> online_methods() noexcept;

}}  // namespace orispline
