// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <list>
#include <optional>
#include <span>
#include <vector>

#include <orispline/batch/sample.hpp>
#include <orispline/batch/sample_grid.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/online/stream_method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which samples a track has: those of steps that lie between its keys, or those of a request.
struct TrackGrid {
  double step = 0.01;             ///< [s], greater than 0: sample k at k * step / parts + start
  double parts = 1.0;             ///< samples in a step, greater than 0
  std::optional<double> start{};  ///< [s]; absent: where the first curve begins
  /// Instead of both the grid of a rate or a count, where it is absent from the start of the first curve to the end of
  /// the last: all of its samples, which before the one and after the other hold the end orientation at rest.
  std::optional<SampleGrid::Request> request{};
};

/// How the keys of a track become curves.
struct TrackOptions {
  Signs signs = Signs::shortest;
  /// A longer interval between two keys [s] ends one curve and begins the next. Absent: one curve.
  std::optional<double> gap{};
};

class TrackStretch;

/// Even samples of a track whose keys arrive in pieces, and whose state can be put away between them as bytes.
///
/// However the keys are cut into pieces, and through any number of states, the samples are bit for bit those that
/// sample() takes of the curve through all keys of a stretch. A sample is final when the keys on which its segment
/// depends have come; of a method that solves equations over all keys when the stretch has ended. Keys on which no
/// coming sample depends are forgotten: the memory grows with the samples that are not taken, and of global methods
/// with the stretch. The signs of the keys are aligned from the first key of a stretch on. Between stretches there are
/// no samples.
class ORISPLINE_EXPORT TrackSampler {
 public:
  /// A parameter of the method that has no values has them with the keys.
  ///
  /// Errors (bad_argument): a grid without a step greater than 0, a gap that is not greater than 0, an unknown method,
  /// a loop, options that the method does not accept.
  [[nodiscard]] static Expected<TrackSampler> make(const Method& method, const TrackGrid& grid,
                                                   const TrackOptions& options = {});
  TrackSampler(const TrackSampler& other);
  TrackSampler(TrackSampler&& other) noexcept;
  TrackSampler& operator=(const TrackSampler& other);
  TrackSampler& operator=(TrackSampler&& other) noexcept;
  ~TrackSampler();

  /// Takes the next key. Errors as of OnlineCurve::append; after a gap also those of finish() for the stretch before. A
  /// refused key changes nothing. Those of SampleGrid::make() too, of which the track does not recover.
  [[nodiscard]] Expected<void> append(StreamKey key);
  /// Takes many keys, until the first that is refused. `settings`: a value per key of every parameter that comes
  /// with the keys.
  [[nodiscard]] Expected<void> append(const KeyframeData& keys,
                                      const std::map<std::string, std::vector<double>, std::less<>>& settings = {});

  /// Declares the last key to be the end. Errors: bad_data without keys, with fewer than the end rules need or another
  /// count than the method takes.
  [[nodiscard]] Expected<void> finish();

  /// How many samples are final and not taken.
  [[nodiscard]] std::uint64_t ready() const noexcept;
  /// Builds the curves of the samples that are ready, as take() does else. Errors: those of make_curve().
  [[nodiscard]] Expected<void> prepare();
  /// The next samples, as many as there is room for in either layout; their times too where they are wanted.
  ///
  /// Errors: bad_argument for more than are ready and for what sample() refuses; those of make_curve(). Nothing is
  /// taken then.
  [[nodiscard]] Expected<void> take(const Samples<double>& out, std::span<double> times = {}, Work work = {});

  /// The grid, once it is known where it starts; open until its end is known.
  [[nodiscard]] const std::optional<SampleGrid>& grid() const noexcept { return times_; }
  /// The index in the grid of the next sample. Those of a request come without a break where there are no gaps.
  [[nodiscard]] std::uint64_t next() const noexcept { return next_; }
  /// When the first curve begins and the last one ends, once the keys say so [s].
  [[nodiscard]] std::optional<double> start() const noexcept { return start_; }
  [[nodiscard]] std::optional<double> end() const noexcept { return end_; }
  /// Whether samples are final only when a stretch ends, for they depend on all of its keys.
  [[nodiscard]] bool is_global() const noexcept { return !method_.keys_beside; }
  /// What was noticed about the keys so far.
  [[nodiscard]] const KeyframeReport& report() const noexcept { return alignment_.report; }
  /// Keys taken so far.
  [[nodiscard]] std::uint64_t keys() const noexcept { return keys_; }
  /// So many samples, about, are between the newest key and one at that time; 0 where there is none or no such time,
  /// and across a gap.
  [[nodiscard]] double samples_until(double time) const noexcept;
  /// Of them those that are still there.
  [[nodiscard]] std::size_t kept() const noexcept;

  /// All that is needed to go on elsewhere, the same on every machine.
  [[nodiscard]] std::vector<std::byte> state() const;
  /// Errors: bad_data for bytes that are no state.
  [[nodiscard]] static Expected<TrackSampler> from_state(std::span<const std::byte> bytes);

 private:
  friend class TrackState;

  TrackSampler(const Method& given, StreamMethod method, const TrackGrid& grid, const TrackOptions& options);

  /// The samples of a stretch that are final and not taken.
  struct Part {
    TrackStretch* stretch;
    SampleRange samples;
  };
  [[nodiscard]] std::vector<Part> parts_ready();
  [[nodiscard]] Expected<void> push(StreamKey key);
  [[nodiscard]] Expected<void> place_grid();
  [[nodiscard]] SampleRange final_samples(const TrackStretch& stretch, std::uint64_t next) const;
  void forget();
  /// That the stretches of a state follow each other, all but the last finished, and are those of its keys.
  [[nodiscard]] Expected<void> check_order() const;

  Method given_;
  StreamMethod method_;
  TrackGrid grid_;
  TrackOptions options_;
  std::list<TrackStretch> stretches_;
  std::uint64_t keys_ = 0, next_ = 0;  ///< keys taken; the next sample
  std::optional<double> newest_;       ///< time of the newest key [s]
  std::optional<double> start_, end_;  ///< of the first curve and of the last one [s]
  std::optional<SampleGrid> times_;    ///< the grid, when it is known where it starts
  KeyAlignment alignment_;
  KeyParts parts_;
  bool finished_ = false;
};

}}  // namespace orispline
