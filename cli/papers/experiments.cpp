// SPDX-License-Identifier: Apache-2.0
#include "papers/experiment.hpp"

#include <array>

namespace orispline::cli {
namespace {

constexpr std::array list{
    Experiment{"000-figure1", "Tan et al. 2018, figure 1: the quintic blending functions and their sums",
               experiment::blending_functions},
    Experiment{"000-figure2", "Tan et al. 2018, figure 2: the effect of one tension", experiment::one_tension},
    Experiment{"000-figure3", "Tan et al. 2018, figure 3: rigid motions by four schemes and six tension vectors",
               experiment::rigid_motions},
    Experiment{"000-table1", "Tan et al. 2018, table 1: four schemes compared", experiment::schemes_compared},
    Experiment{"001-example1", "He et al. 2022, example 1: control points of a Beta curve, its G1 and G2 residuals",
               experiment::beta_example1},
    Experiment{"001-example2", "He et al. 2022, example 2 and figure 4: the effect of the shape parameter beta2",
               experiment::beta_example2},
    Experiment{"002-identities", "Eberly, sections 1 to 6: the identities on random quaternions",
               experiment::quaternion_identities},
    Experiment{"002-example", "Eberly, section 6: the angular cubic of squad", experiment::angular_cubic},
    Experiment{"003-table1", "The 6th degree, table 1 and figures 2 to 6: a flight interpolated",
               experiment::flight_compared},
    Experiment{"003-figure7", "The 6th degree, figure 7: a sudden turn on uneven knots", experiment::sudden_turn}};

}  // namespace

std::span<const Experiment> experiments() noexcept { return list; }

}  // namespace orispline::cli
