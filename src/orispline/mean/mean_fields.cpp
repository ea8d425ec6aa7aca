// SPDX-License-Identifier: Apache-2.0
#include <orispline/mean/mean.hpp>

#include <array>

#include <orispline/fields/field_codec.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr Quantity square_angle{"square of an angle", "rad²", "rad2"};
constexpr Quantity square_length{"square of a length", "m²", "m2"};

}  // namespace

template <>
std::span<const FieldInfo> fields_of<MeanOptions>() noexcept {
  static constexpr std::array fields{
      field<&MeanOptions::kind>(
          {.name = "kind",
           .sentence = "Which middle: the mean, the median, which bad rows hardly move, or the chordal mean"}),
      field<&MeanOptions::every>({.name = "every",
                                  .sentence = "Length of windows in time, each with a mean of its own",
                                  .quantity = &quantities::duration,
                                  .range = positive,
                                  .absent = "one mean of all"}),
  };
  return fields;
}

namespace {

constexpr std::array mean_fields{
    field<&Mean::count>({.name = "count", .sentence = "Orientations with a weight above 0"}),
    field<&Mean::weight>({.name = "weight", .sentence = "Sum of the weights; without any each is 1"}),
    field<&sigma_of>({.name = "sigma",
                      .sentence = "One standard deviation of the mean along each axis of its body",
                      .quantity = &quantities::angle,
                      .absent = "where it cannot be told, such as of a single orientation"}),
    field<&Mean::covariance>({.name = "covariance",
                              .sentence = "Covariance of the mean along the axes of its body: xx, yy, zz, xy, xz, yz",
                              .quantity = &square_angle,
                              .absent = "where it cannot be told, such as of a single orientation"}),
    field<&Mean::spread>({.name = "spread",
                          .sentence = "Covariance of one orientation about the mean, along the axes of its body",
                          .quantity = &square_angle,
                          .absent = "of a single orientation"}),
    field<&Mean::rms_distance>({.name = "rms_distance",
                                .sentence = "Root mean square angle from the mean to the orientations, weighted",
                                .quantity = &quantities::angle}),
    field<&Mean::largest_distance>({.name = "largest_distance",
                                    .sentence = "Largest angle from the mean to an orientation",
                                    .quantity = &quantities::angle}),
    field<&Mean::certified>({.name = "certified",
                             .sentence =
                                 "It is proved that no other orientation is as good: by a ball of less than 90° "
                                 "that holds all, or by how far from it they are"}),
    field<&Mean::ball_radius>(
        {.name = "ball_radius",
         .sentence = "Angle round some orientation that holds all of them, the smallest if it is below 90°",
         .quantity = &quantities::angle}),
    field<&Mean::others_within>({.name = "others_within",
                                 .sentence = "Angle from it within which every other orientation is that is as good",
                                 .quantity = &quantities::angle,
                                 .absent = "where that is not known"}),
    field<&Mean::residual>({.name = "residual",
                            .sentence = "What the gradient still asks for: its length for the mean, for the median "
                                        "its length over the largest curvature",
                            .quantity = &quantities::angle}),
    field<&Mean::iterations>({.name = "iterations", .sentence = "Steps of the search"}),
    field<&position_sigma_of>({.name = "position_sigma",
                               .sentence = "One standard deviation of the mean position along each axis of the world",
                               .quantity = &quantities::length,
                               .absent = "without positions"}),
    field<&Mean::position_covariance>({.name = "position_covariance",
                                       .sentence = "Covariance of the mean position along the axes of the world",
                                       .quantity = &square_length,
                                       .absent = "without positions"}),
    field<&Mean::position_spread>(
        {.name = "position_spread",
         .sentence = "Covariance of one position about their mean, along the axes of the world",
         .quantity = &square_length,
         .absent = "without positions"}),
    field<&Mean::position_rms_distance>({.name = "position_rms_distance",
                                         .sentence = "Root mean square distance from the mean position, weighted",
                                         .quantity = &quantities::length,
                                         .absent = "without positions"}),
    field<&Mean::position_largest_distance>({.name = "position_largest_distance",
                                             .sentence = "Largest distance from the mean position",
                                             .quantity = &quantities::length,
                                             .absent = "without positions"}),
};

}  // namespace

template <>
std::span<const FieldInfo> fields_of<Mean>() noexcept {
  return mean_fields;
}

}}  // namespace orispline
