// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/sample_layout.hpp>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

template <class T>
std::optional<Error> check_room(const Samples<T>& out, std::size_t wanted) {
  const auto error = [](std::string message) { return Error{ErrorCode::bad_argument, std::move(message), {}}; };
  if (out.plane != 0 && out.layout != Layout::planar)
    return error("found a distance between planes for samples that are interleaved, wanted a planar layout");
  if (out.plane != 0 && out.plane < wanted)
    return error(formatted("found planes {} numbers apart, wanted {} or more for as many samples", out.plane, wanted));
  struct Room {
    const char* what;
    std::span<T> span;
    std::size_t components;
  };
  for (const auto& [what, span, components] :
       {Room{"orientations", out.orientations, 4}, Room{"angular velocities", out.angular_velocities, 3},
        Room{"angular accelerations", out.angular_accelerations, 3}, Room{"angular jerks", out.angular_jerks, 3},
        Room{"positions", out.positions, 3}, Room{"velocities", out.velocities, 3},
        Room{"accelerations", out.accelerations, 3}, Room{"linear jerks", out.linear_jerks, 3}}) {
    const std::size_t numbers = (components - 1) * (out.plane == 0 ? wanted : out.plane) + wanted;
    const bool may_be_empty = components == 3 || wanted == 0;
    if ((may_be_empty && span.empty()) || span.size() == numbers) continue;
    return error(formatted("found room for {} numbers of {}, wanted {} numbers for {} samples", span.size(), what,
                           numbers, wanted));
  }
  return std::nullopt;
}

template <class T>
std::optional<Error> check_positions(const PoseCurve& curve, const Samples<T>& out) {
  if (!wants_positions(out) || curve.position) return std::nullopt;
  return Error{
      ErrorCode::bad_argument, "found room for positions, wanted none: the keys of the curve have no positions", {}};
}

template std::optional<Error> check_positions(const PoseCurve&, const Samples<double>&);
template std::optional<Error> check_positions(const PoseCurve&, const Samples<float>&);
template std::optional<Error> check_room(const Samples<double>&, std::size_t);
template std::optional<Error> check_room(const Samples<float>&, std::size_t);

}}}  // namespace orispline::batch
