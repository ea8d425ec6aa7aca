// SPDX-License-Identifier: Apache-2.0
#include "papers/experiment.hpp"

#include <algorithm>
#include <array>

namespace orispline::cli {

namespace {

constexpr std::array list{
    Experiment{"000-figure1", "Tan et al. 2018, figure 1: the quintic blending functions and their sums",
               experiment::blending_functions},
    Experiment{"000-figure2", "Tan et al. 2018, figure 2: the effect of one tension", experiment::one_tension,
               experiment::one_tension_of},
    Experiment{"000-figure3", "Tan et al. 2018, figure 3: rigid motions by four schemes and six tension vectors",
               experiment::rigid_motions, experiment::rigid_motions_of},
    Experiment{"000-figure4", "Tan et al. 2018, figure 4: the quintic beside a C1 cubic Hermite curve",
               experiment::hermite_compared, experiment::hermite_compared_on},
    Experiment{"000-table1", "Tan et al. 2018, table 1: four schemes compared", experiment::schemes_compared,
               experiment::schemes_compared_on},
    Experiment{"000-identities", "Tan et al. 2018, (3.4) and (3.11) to (3.14): the derivatives at the keys",
               experiment::quintic_identities},
    Experiment{"000-theorem1", "Tan et al. 2018, theorem 1 where a tension is 0: corners", experiment::quintic_at_zero,
               experiment::quintic_at_zero_on},
    Experiment{"000-claims", "Tan et al. 2018, claims and future work: other curves approximated, the best tensions",
               experiment::quintic_claims, experiment::quintic_claims_on},
    Experiment{"001-example1", "He et al. 2022, example 1 and figures 1 to 3: a Beta curve, its G1 and G2 residuals",
               experiment::beta_example1, experiment::beta_example1_on},
    Experiment{"001-example2", "He et al. 2022, example 2 and figure 4: the effect of the shape parameter beta2",
               experiment::beta_example2, experiment::beta_example2_on},
    Experiment{"001-local", "He et al. 2022, section 5: which segments a shape parameter moves", experiment::beta_local,
               experiment::beta_local_on},
    Experiment{"001-shapes", "He et al. 2022, the shape parameters: the best beta1 and beta2 by energy and by fit",
               experiment::beta_shapes, nullptr, experiment::beta_shapes_on},
    Experiment{"002-identities", "Eberly, sections 1 to 6: the identities on random quaternions",
               experiment::quaternion_identities},
    Experiment{"002-example", "Eberly, section 6: the angular cubic of squad", experiment::angular_cubic},
    Experiment{"003-table1", "The 6th degree, table 1 and figures 1 to 6: a flight interpolated",
               experiment::flight_compared, nullptr, experiment::flight_compared_on},
    Experiment{"003-figure7", "The 6th degree, figure 7: a sudden turn on uneven knots", experiment::sudden_turn,
               experiment::turns_of},
    Experiment{"003-identities", "The 6th degree, lemmas 1 to 4 and (9): the derivatives at the keys",
               experiment::sextic_identities},
    Experiment{"003-theorem1", "The 6th degree, theorem 1 where a tension is 0: cusps", experiment::sextic_at_zero,
               experiment::sextic_at_zero_on},
    Experiment{"003-claims", "The 6th degree, claims and future work: its time, the best tensions",
               experiment::sextic_claims, nullptr, experiment::sextic_claims_on}};

struct Author {
  std::string_view paper, word;
};
constexpr std::array authors{Author{"000", "tan"}, Author{"001", "he"}, Author{"002", "eberly"},
                             Author{"003", "sextic"}};

}  // namespace

std::span<const Experiment> experiments() noexcept { return list; }

std::string_view author_of(const Experiment& experiment) noexcept {
  return std::ranges::find(authors, experiment.paper(), &Author::paper)->word;
}

std::string name_by_author(const Experiment& experiment) {
  return std::string(author_of(experiment)).append(experiment.name.substr(experiment.paper().size()));
}

}  // namespace orispline::cli
