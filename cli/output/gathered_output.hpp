// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>

#include "output/noted_output.hpp"

namespace orispline::cli {

/// When an output takes its place.
enum class Finishing { at_once, with_the_others };

/// What the work on one of several inputs says and makes. It is kept until its turn, for threads work side by side.
struct Gathered {
  std::string input;  ///< its path, which messages name
  Finishing finishing = Finishing::at_once;
  std::vector<std::string> warnings{};                        ///< what they say, without the input
  std::string told{};                                         ///< for standard error
  std::vector<std::string> documents{};                       ///< for standard output
  std::vector<std::function<Expected<void>()>> unfinished{};  ///< outputs that are complete, beside their places
  std::size_t finished = 0;                                   ///< outputs in their places
};

/// While it lives, what this thread would say goes there.
class GatheringHere {
 public:
  explicit GatheringHere(Gathered& gathered) noexcept;
  ~GatheringHere();
  GatheringHere(const GatheringHere&) = delete;
  GatheringHere& operator=(const GatheringHere&) = delete;
};

/// Where what this thread would say goes; null: to the user.
[[nodiscard]] Gathered* gathered_here() noexcept;

/// The warnings of this thread, since GatheringHere where it gathers; each once.
[[nodiscard]] std::vector<Warning>& warned_here() noexcept;

/// Finishes an output that has been written, now or when the others are finished. Error: bad_access.
template <class File>
[[nodiscard]] Expected<void> put_in_place(Noted<File> output) {
  Gathered* const gathered = gathered_here();
  if (!gathered) return output.file.finish();
  if (gathered->finishing == Finishing::at_once) return output.file.finish().map([&] { ++gathered->finished; });
  return output.file.close().map([&] {
    auto closed = std::make_shared<Noted<File>>(std::move(output));
    gathered->unfinished.emplace_back([closed] { return closed->file.finish(); });
  });
}

}  // namespace orispline::cli
