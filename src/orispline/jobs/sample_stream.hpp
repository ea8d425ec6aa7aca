// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orispline/curve/key_check.hpp>
#include <orispline/jobs/sample_steps.hpp>
#include <orispline/online/track_sampler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// Successive keys of a file.
struct KeyPiece {
  KeyframeData keys{};
  std::map<std::string, std::vector<double>, std::less<>> settings{};  ///< one value per key
  std::vector<std::uint32_t> lines{};                                  ///< of the file, from 1
  Decimal epoch{};                                                     ///< of the first key of all [s]
  std::vector<Warning> warnings{};                                     ///< of reading
  bool is_last = false;
};

/// Keys that come in pieces, and which samples of the curve through them are wanted.
struct StreamRequest {
  std::string source{};  ///< name of the keys' file
  Method method{};       ///< without the settings that come with the keys
  Signs signs = Signs::shortest;
  TimeRequest times{};
  Extrapolation extrapolation = Extrapolation::hold;
  std::vector<std::string> settings{};               ///< names of those that come with the keys
  std::function<Expected<KeyPiece>()> next{};        ///< reads on; called until the last piece
  std::function<void(std::vector<Warning>)> warn{};  ///< told as they are found
  std::function<void(std::size_t samples)> ended{};  ///< called when it is known how many samples there are
};

/// Whether samples can be made while the keys come: those of a rate, of a method whose segments depend on a few keys.
[[nodiscard]] bool can_stream(const StreamRequest& request);

/// Samples of keys that come in pieces, in memory that grows with neither.
class StreamSamples final : public SampleSource {
 public:
  /// Precondition: can_stream().
  explicit StreamSamples(StreamRequest request);

  /// Errors: those of reading, of keys that none can be, and of times that no curve covers.
  [[nodiscard]] Expected<void> next(SampleBlock& block, std::size_t most, Work work) override;
  [[nodiscard]] std::optional<std::uint64_t> size() const override { return sampler_->grid()->size(); }
  [[nodiscard]] const TimeOrigin& origin() const override { return *origin_; }
  [[nodiscard]] Domain domain() const override;

  /// What was sampled, when all samples have been taken.
  [[nodiscard]] SampleOutcome outcome() const;

 private:
  /// Where the keys that are still needed stand in the file.
  class KeyLines {
   public:
    /// Adds those of the next keys, and forgets the ones of keys before that one.
    void add(const std::vector<std::uint32_t>& lines, std::uint64_t oldest);
    [[nodiscard]] Where located(Where where) const;

   private:
    std::uint64_t first_ = 0;
    std::vector<std::uint32_t> lines_;
  };

  [[nodiscard]] Expected<void> read();
  [[nodiscard]] Expected<void> begin(const KeyPiece& piece);
  [[nodiscard]] Expected<void> end();
  void warn_of_first(const KeyPiece& piece) const;
  [[nodiscard]] SampleTimes times() const;
  [[nodiscard]] Error placed(Error error) const;

  StreamRequest request_;
  KeyLines lines_;
  Decimal epoch_;
  std::optional<TrackSampler> sampler_;
  std::optional<TimeOrigin> origin_;
  std::size_t rate_orders_ = 0;
  bool inner_quaternions_ = false, is_at_end_ = false;
};

}}}  // namespace orispline::jobs
