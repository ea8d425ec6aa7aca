// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/batch/baked_motion.hpp>
#include <orispline/jobs/curve_of_keys.hpp>

#include "blocks.hpp"
#include "curve.hpp"
#include "errors.hpp"
#include "progress.hpp"

namespace orispline::c {

namespace {

/// A baked curve, and what it is made of as flat arrays.
template <class T>
struct Baked {
  BakedCurve<T> curve;
  std::vector<double> scales{};
  std::vector<T> coefficients{};

  explicit Baked(BakedCurve<T> baked) : curve(std::move(baked)) {
    for (const batch::BakedRecord<T>& piece : curve.pieces()) {
      scales.insert(scales.end(), {piece.middle, piece.per_step});
      const T* const first = &piece.coefficients[0][0];
      coefficients.insert(coefficients.end(), first, first + per_piece);
    }
  }

  static constexpr int degree = batch::baked_degree<T>;
  static constexpr std::size_t per_piece = 4 * (degree + 1);
  static constexpr orispline_type type = std::is_same_v<T, double> ? ORISPLINE_DOUBLE : ORISPLINE_FLOAT;
};

}  // namespace

using AnyBaked = std::variant<Baked<double>, Baked<float>>;

template <>
struct HandleOf<orispline_baked> {
  using Body = AnyBaked;
  static constexpr Kind kind = Kind::baked;
  static constexpr std::string_view name = "baked";
};

namespace {

template <class T>
Expected<AnyBaked> baked(const HeldCurve& curve, double tolerance, const Progress& progress) {
  return jobs::check_without_gaps(*curve.track)
      .and_then([&] { return bake<T>(curve.pose().orientation, tolerance, {}, progress); })
      .map([](BakedCurve<T> made) { return AnyBaked(Baked<T>(std::move(made))); });
}

template <class T>
Expected<AnyBaked> restored(const orispline_baked_parts& parts) {
  using Of = Baked<T>;
  if (parts.degree != Of::degree)
    return bad_option("degree", formatted("found {}, wanted {} for this type", parts.degree, Of::degree));
  std::vector<batch::BakedRecord<T>> pieces(parts.pieces);
  const T* from = static_cast<const T*>(parts.coefficients);
  for (std::size_t i = 0; i < pieces.size(); ++i, from += Of::per_piece) {
    std::copy_n(from, Of::per_piece, &pieces[i].coefficients[0][0]);
    pieces[i].middle = parts.scales[2 * i];
    pieces[i].per_step = parts.scales[2 * i + 1];
  }
  return BakedCurve<T>::restored({parts.ends, parts.ends + parts.end_count}, std::move(pieces),
                                 parts.largest_difference)
      .map([](BakedCurve<T> curve) { return AnyBaked(Of(std::move(curve))); });
}

Expected<void> check_parts(const orispline_baked_parts& parts) {
  return check_type(parts.type)
      .and_then([&] { return check_pointer(parts.ends, "ends"); })
      .and_then([&] { return check_pointer(parts.scales, "scales"); })
      .and_then([&] { return check_pointer(parts.coefficients, "coefficients"); })
      .and_then([&]() -> Expected<void> {
        // Before anything is read: of a curve of a single key there is one of either.
        if (parts.end_count > 0 && parts.pieces == std::max<std::size_t>(parts.end_count, 2) - 1) return {};
        const std::string message =
            formatted("found {} for {} ends, wanted one between two ends each", parts.pieces, parts.end_count);
        if (parts.pieces == 0 || parts.pieces > parts.end_count) return bad_option("pieces", message);
        return failure(ErrorCode::bad_data, "pieces: " + message);
      });
}

template <class T>
Expected<void> sample(const Baked<T>& baked, const Times& times, orispline_order order, Outputs outputs) {
  for (const orispline_output& output : outputs) {
    if (output.type != Baked<T>::type) return bad_option("type", "found another one, wanted that of the coefficients");
    if (is_of_position(output.quantity))
      return bad_option("quantity", "found positions, wanted orientations or angular rates");
  }
  return fill_all<T>(outputs, order, times, {},
                     [&](std::span<const double> some, const Samples<T>& samples, RateFrame frame) {
                       auto done = sample_at<T>(baked.curve, some, samples);
                       if (done && frame == RateFrame::world) turn_to_world(samples);
                       return done;
                     });
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_bake(const orispline_curve* curve, double tolerance, orispline_type type,
                              orispline_progress progress, void* context, orispline_baked** baked,
                              orispline_error** error) {
  return guarded(error, [&] {
    return cleared(baked, "baked")
        .and_then([&] { return check_type(type); })
        .and_then([&] { return checked(curve); })
        .and_then([&](const HeldCurve* body) {
          const Progress watched = progress_by(progress, context);
          return type == ORISPLINE_FLOAT ? c::baked<float>(*body, tolerance, watched)
                                         : c::baked<double>(*body, tolerance, watched);
        })
        .map([&](AnyBaked made) { *baked = handle_of<orispline_baked>(std::move(made)); });
  });
}

orispline_code orispline_baked_look(const orispline_baked* baked, orispline_baked_parts* parts,
                                    orispline_error** error) {
  return guarded(error, [&] {
    return check_pointer(parts, "parts").and_then([&] { return checked(baked); }).map([&](const AnyBaked* any) {
      std::visit(
          [&](const auto& body) {
            const auto ends = body.curve.knots().times();
            *parts = {.ends = ends.data(),
                      .scales = body.scales.data(),
                      .coefficients = body.coefficients.data(),
                      .end_count = ends.size(),
                      .pieces = body.curve.pieces().size(),
                      .degree = body.degree,
                      .type = body.type,
                      .largest_difference = body.curve.largest_difference()};
          },
          *any);
    });
  });
}

orispline_code orispline_baked_make(const orispline_baked_parts* parts, orispline_baked** baked,
                                    orispline_error** error) {
  return guarded(error, [&] {
    return cleared(baked, "baked")
        .and_then([&] { return check_pointer(parts, "parts"); })
        .and_then([&] { return check_parts(*parts); })
        .and_then([&] { return parts->type == ORISPLINE_FLOAT ? restored<float>(*parts) : restored<double>(*parts); })
        .map([&](AnyBaked made) { *baked = handle_of<orispline_baked>(std::move(made)); });
  });
}

orispline_code orispline_baked_sample_at(const orispline_baked* baked, const double* times, size_t count,
                                         orispline_order order, const orispline_output* outputs, size_t output_count,
                                         orispline_error** error) {
  return guarded(error, [&]() -> Expected<void> {
    const auto any = checked(baked);
    if (!any) return tl::unexpected(any.error());
    return (count == 0 ? Expected<void>() : check_pointer(times, "times"))
        .and_then([&] { return outputs_in(outputs, output_count, order, count); })
        .and_then([&](Outputs wanted) {
          const Times at(std::span(times, count));
          return std::visit([&](const auto& body) { return sample(body, at, order, wanted); }, **any);
        });
  });
}

void orispline_baked_free(orispline_baked* baked) { free_handle(baked); }

orispline_code orispline_bake_text(const orispline_curve* curve, double tolerance, double position_tolerance,
                                   char** text, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(text, "text")
        .and_then([&] { return checked(curve); })
        .and_then([&](const HeldCurve* body) {
          return jobs::check_without_gaps(*body->track).and_then([&] {
            return bake_motion(body->pose(), tolerance, position_tolerance);
          });
        })
        .map([&](const BakedMotion& motion) { *text = text_of_c(baked_json(motion, {})); });
  });
}
