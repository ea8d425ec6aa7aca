// SPDX-License-Identifier: Apache-2.0
#include <nanobind/nanobind.h>

#include <orispline/base/version.hpp>

#include "keys.hpp"
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
  orispline::python::add_scenes(module);
  orispline::python::add_tasks(module);
}
