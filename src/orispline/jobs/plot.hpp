// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

enum class BodyAxis { x, y, z };

/// What a picture of curves shows beside them.
struct PictureLook {
  std::string title{};
  BodyAxis axis = BodyAxis::x;  ///< whose way over the unit sphere is drawn
  std::size_t ghosts = 0;       ///< as in report::MotionPicture
};

/// One of its curves, and what it is called there.
struct NamedCurve {
  std::string name;
  const PoseCurve& curve;
};

/// Curves through the same keys as an SVG: at most report::most_drawn_methods.
[[nodiscard]] ORISPLINE_EXPORT std::string picture_of(const PictureLook& look, const Keyframes& keys,
                                                      std::span<const NamedCurve> curves);

/// Curves through the same keys that are to be drawn.
struct PlotRequest {
  std::string name{};  ///< of the keys, for people
  std::shared_ptr<const Track> keys;
  std::vector<Method> methods{};  ///< at most report::most_drawn_methods
  BodyAxis axis = BodyAxis::x;    ///< whose way over the unit sphere is drawn
  std::size_t ghosts = 0;         ///< as in report::MotionPicture
};

struct PlotOutcome {
  std::string svg;
  std::vector<Warning> warnings{};  ///< of the methods
};

/// Errors: those of shaped_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<PlotOutcome> plot(const PlotRequest& request);

}}}  // namespace orispline::jobs
