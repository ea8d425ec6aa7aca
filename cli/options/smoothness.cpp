// SPDX-License-Identifier: Apache-2.0
#include "options/smoothness.hpp"

#include <numbers>

#include <orispline/base/formatted.hpp>
#include <orispline/fields.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view section = "Smoothing";

void add_cutoff(Command& app, SmoothnessOptions& o) {
  app.add_option(
         "--cutoff", o.cutoff,
         "Cut-off frequency 1/(2 pi tau) instead of the smoothing time; half of a motion at this frequency is left")
      ->type_name("HZ")
      ->group(std::string(section));
}

}  // namespace

std::string first_given(const SmoothnessOptions& options) {
  for (const std::string_view name : {"noise", "smoothing_time", "position_noise"})
    if (is_given(options.fields, name)) return flag_of(name);
  return options.cutoff ? "--cutoff" : "";
}

Expected<orispline::SmoothOptions> smoothing_in(const SmoothnessOptions& options) {
  if (is_given(options.fields, "noise") + is_given(options.fields, "smoothing_time") + options.cutoff.has_value() > 1)
    return usage_failure("found several of --noise, --smoothing-time and --cutoff, wanted one: each says how smooth");
  FirstError checked;
  auto smoothing = checked(options_in<orispline::SmoothOptions>(options.fields));
  if (const auto cutoff = checked(
          if_given("--cutoff", options.cutoff, [](OptionText o) { return positive_in(without_unit(o, "Hz")); })))
    smoothing.smoothing_time = 1.0 / (2.0 * std::numbers::pi * *cutoff);
  return std::move(checked).or_else(smoothing).and_then([&](const orispline::SmoothOptions& read) {
    return check(read).map([&] { return read; }).map_error([&](Error error) {
      return said_of_cutoff(options, std::move(error));
    });
  });
}

Error said_of_cutoff(const SmoothnessOptions& options, Error error) {
  if (!options.cutoff || error.option != "smoothing_time") return error;
  error.option = "cutoff";
  error.message = formatted("its smoothing time 1/(2 pi f) is out of range: {}", error.message);
  return error;
}

void add_smoothing_options(Command& app, SmoothnessOptions& o) {
  for (const FieldInfo& field : fields_of<orispline::SmoothOptions>()) {
    add_field(app, o.fields, field, section);
    if (field.name == "smoothing_time") add_cutoff(app, o);
  }
}

void add_smoothness_options(Command& app, SmoothnessOptions& o) {
  for (const std::string_view name : {"noise", "smoothing_time", "position_noise"})
    add_field(app, o.fields, field_named(fields_of<orispline::SmoothOptions>(), name), section);
  add_cutoff(app, o);
}

}  // namespace orispline::cli
