// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include <orispline/families/atbi.hpp>
#include <orispline/families/auto.hpp>
#include <orispline/families/averages.hpp>
#include <orispline/families/barry_goldman.hpp>
#include <orispline/families/beta.hpp>
#include <orispline/families/beta_g2.hpp>
#include <orispline/families/beta_through.hpp>
#include <orispline/families/bezier.hpp>
#include <orispline/families/biarcs.hpp>
#include <orispline/families/blend.hpp>
#include <orispline/families/bspline.hpp>
#include <orispline/families/bspline_through.hpp>
#include <orispline/families/global_c2.hpp>
#include <orispline/families/hermite.hpp>
#include <orispline/families/hermite_cumulative.hpp>
#include <orispline/families/least/least.hpp>
#include <orispline/families/measured.hpp>
#include <orispline/families/monotone.hpp>
#include <orispline/families/nu.hpp>
#include <orispline/families/quintic.hpp>
#include <orispline/families/rational.hpp>
#include <orispline/families/rotation_spline.hpp>
#include <orispline/families/sextic.hpp>
#include <orispline/families/shoemake.hpp>
#include <orispline/families/slerp.hpp>
#include <orispline/families/squad.hpp>
#include <orispline/families/tcb.hpp>
#include <orispline/families/timed.hpp>
#include <orispline/families/uniform.hpp>
#include <orispline/families/xing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// THE list of families: the registry, the command line, the docs table and the contract tests all read it.
using Families =
    std::tuple<families::Auto, families::Auto5, families::Slerp, families::Squad, families::SquadTimed,
               families::Shoemake, families::Tcb, families::BarryGoldman, families::Circular, families::LogParabola,
               families::Quintic, families::Sextic, families::TimedC1, families::TimedC2, families::TimedC3,
               families::TimedSextic, families::Monotone, families::XingQuartic, families::XingQuintic,
               families::UniformFamily, families::Atbi, families::HermiteC1, families::HermiteC2, families::HermiteC3,
               families::HermiteCumulative, families::GlobalC2, families::Rational, families::RotationSpline,
               families::Nu, families::NuExact, families::Biarcs, families::Bezier, families::BSpline,
               families::BSplineThrough, families::Averages, families::Beta, families::BetaThrough, families::BetaG2,
               families::Least, families::Measured>;

}}  // namespace orispline
