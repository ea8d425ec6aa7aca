// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the blocks of C++ that compiled_test.py compiles take as the reader's own: for the Nth of PAGE.md the namespace
// PAGE_N. It is declared and never defined, for they are not linked.

#include <orispline/align.hpp>
#include <orispline/mean.hpp>
#include <orispline/orispline.hpp>
#include <orispline/sampling.hpp>
#include <orispline/streams.hpp>
#include <orispline/tune.hpp>

#include <Eigen/Geometry>

#include <vector>

namespace own {
extern const orispline::Expected<orispline::Keyframes> keys;
Eigen::Quaterniond measured(double time);
}  // namespace own

namespace readme_1 {
extern const Eigen::Quaterniond q1, q2;
}

namespace align_1 {
extern const orispline::Track estimate, truth;
}

namespace align_2 {
extern const orispline::GyroRates rates;
extern const orispline::Track poses;
}  // namespace align_2

namespace closed_1 {
using own::keys;
}

namespace mean_1 {
extern const std::vector<Eigen::Quaterniond> q;
extern const std::vector<double> w;
void use(const Eigen::Quaterniond& middle, const Eigen::Vector3d& sigma);
}  // namespace mean_1

namespace online_1 {
using own::measured;
}

namespace online_2 {
using own::measured;
}

namespace online_3 {
extern const orispline::KeyframeData keys;
}

namespace online_5 {
extern const orispline::TrackColumns keys;
extern std::vector<double> t, x, y, z, w;
}  // namespace online_5

namespace performance_1 {
using own::keys;
extern std::vector<double> orientations;
}  // namespace performance_1

namespace tune_1 {
using own::keys;
}
