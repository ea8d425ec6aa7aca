// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/batch/kernel/record.hpp>
#include <orispline/batch/sample.hpp>
#include <orispline/batch/segment_runs.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// A segment of a path for the kernel, where it is a polynomial.
template <class T>
[[nodiscard]] std::optional<PathRecord<T>> record_of(const AnyPath& path, std::size_t segment) noexcept;

/// Writes runs of positions that lie on one segment: by the kernel, or where the segment is no polynomial by the scalar
/// evaluator. Segments are compiled one after the other, each when it is first needed.
template <class T>
class PathSampler {
 public:
  PathSampler(const AnyPath& path, const Samples<T>& out) noexcept : path_(path), out_(out) {}

  [[nodiscard]] const Knots& knots() const noexcept { return path_.knots(); }
  void on_segment(std::size_t segment, const Clock& clock, std::size_t at, std::size_t count) noexcept;
  void hold(Held held, std::size_t at, std::size_t count) noexcept;

 private:
  [[nodiscard]] PathTarget<T> target_from(std::size_t at) const noexcept;

  const AnyPath& path_;
  const Samples<T>& out_;
  std::optional<std::size_t> segment_{};  ///< whose record is there
  std::optional<PathRecord<T>> record_{};
};

}}}  // namespace orispline::batch
