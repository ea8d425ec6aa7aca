// SPDX-License-Identifier: Apache-2.0
#include "commands/tasks/tasks_info.hpp"

#include <orispline/fields.hpp>

namespace orispline::cli {

namespace {

template <class... Structs>
std::vector<FieldInfo> fields() {
  std::vector<FieldInfo> all;
  const auto append = [&](std::span<const FieldInfo> some) { all.insert(all.end(), some.begin(), some.end()); };
  (append(fields_of<Structs>()), ...);
  return all;
}

}  // namespace

std::vector<TaskInfo> tasks_info() {
  return {
      {"smooth", "A noisy recording as a smooth motion with rates", fields<SmoothOptions>(), fields<Smoothing>()},
      {"tune", "The tensions that make a curve smoothest, or nearest to a recording", fields<TuneOptions>(),
       fields<Tuning>()},
      {"reduce", "The fewest keys that reproduce a recording within a tolerance", fields<ReduceOptions>(),
       fields<Reduction>()},
      {"retime", "The least slowing that keeps a motion within limits", fields<RetimeOptions>(), fields<Retiming>()},
      {"mean", "The mean or the median of many orientations", fields<MeanOptions>(), fields<Mean>()},
      {"align", "What brings one recording onto another one of the same motion", fields<AlignOptions>(),
       fields<Alignment>(), fields<RateAlignment>()},
      {"compare", "How near the curves of methods come to a recording", fields<Decimation, MeasureOptions>(), {}}};
}

}  // namespace orispline::cli
