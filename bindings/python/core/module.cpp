// SPDX-License-Identifier: Apache-2.0
#include <nanobind/nanobind.h>

#include <orispline/base/version.hpp>

#include "keys.hpp"
#include "tasks.hpp"
#include "text.hpp"

NB_MODULE(_core, module) {
  module.attr("version") = std::string(orispline::version);
  orispline::python::add_keys(module);
  orispline::python::add_curve(module);
  orispline::python::add_methods(module);
  orispline::python::add_blending(module);
  orispline::python::add_online(module);
  orispline::python::add_stack(module);
  orispline::python::add_tracks(module);
  orispline::python::add_files(module);
  orispline::python::add_fields(module);
  orispline::python::add_smooth(module);
  orispline::python::add_reduce(module);
  orispline::python::add_retime(module);
  orispline::python::add_tune(module);
  orispline::python::add_mean(module);
  orispline::python::add_compare(module);
  orispline::python::add_align(module);
  orispline::python::add_align_rates(module);
  orispline::python::add_scenes(module);
}
