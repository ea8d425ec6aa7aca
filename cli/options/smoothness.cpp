// SPDX-License-Identifier: Apache-2.0
#include "options/smoothness.hpp"

#include <orispline/fields.hpp>

namespace orispline::cli {

namespace {

constexpr std::string_view section = "Smoothing";

void add_cutoff(Command& app, TypedFields& fields) {
  app.add_option(
         "--cutoff", fields["cutoff"],
         "Cut-off frequency 1/(2 pi tau) instead of the smoothing time; half of a motion at this frequency is left")
      ->type_name("HZ")
      ->group(std::string(section));
}

}  // namespace

void add_smoothing_options(Command& app, TypedFields& fields) {
  for (const FieldInfo& field : fields_of<orispline::SmoothOptions>()) {
    add_field(app, fields, field, section);
    if (field.name == "smoothing_time") add_cutoff(app, fields);
  }
}

void add_smoothness_options(Command& app, TypedFields& fields) {
  for (const std::string_view name : {"noise", "smoothing_time", "position_noise"})
    add_field(app, fields, field_named(fields_of<orispline::SmoothOptions>(), name), section);
  add_cutoff(app, fields);
}

}  // namespace orispline::cli
