// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/task_request.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/fields/typed_numbers.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// With the name of the option that was wrong.
tl::unexpected<Error> of_option(std::string_view name, Error error) {
  error.option = name;
  return tl::unexpected(std::move(error));
}

/// The smoothing time of the cut-off frequency [Hz] that is stated.
Expected<std::optional<double>> cutoff_time_in(const TaskRequest& request) {
  return positive_in(request, "cutoff", "Hz").map([](std::optional<double> frequency) {
    return frequency ? std::optional(1.0 / (2.0 * std::numbers::pi * *frequency)) : std::nullopt;
  });
}

}  // namespace

bool is_stated(const TaskRequest& request, std::string_view name) {
  const FieldValue* const value = request.stated(name);
  return value && !is_absent(*value);
}

Expected<bool> flag(const TaskRequest& request, std::string_view name) {
  const FieldValue* const value = request.stated(name);
  if (!value) return false;
  if (const bool* const is_set = std::get_if<bool>(value)) return *is_set;
  const std::string text = text_of(*value);
  if (text != "true" && text != "false") return of_option(name, typed::wanted(text, "true or false").value());
  return text == "true";
}

Expected<unsigned> threads_in(const TaskRequest& request) {
  const FieldValue* const value = request.stated("threads");
  if (!value) return 0u;
  const auto count = typed::count(text_of(*value), 0);
  if (!count) return of_option("threads", count.error());
  return static_cast<unsigned>(std::min<std::uint64_t>(*count, std::numeric_limits<unsigned>::max()));
}

Expected<std::optional<double>> positive_in(const TaskRequest& request, std::string_view name, std::string_view unit) {
  const FieldValue* const value = request.stated(name);
  if (!value || is_absent(*value)) return std::nullopt;
  const double* const number = std::get_if<double>(value);
  if (number && *number > 0.0 && std::isfinite(*number)) return std::optional(*number);
  const auto typed = typed::positive(typed::without_unit(text_of(*value), unit));
  if (!typed) return of_option(name, typed.error());
  return std::optional(*typed);
}

Expected<std::optional<std::vector<LabelledMethod>>> methods_in(const TaskRequest& request) {
  if (!request.methods.empty()) return request.methods;
  const std::string* const list = request.option("methods");
  if (!list) return std::nullopt;
  const auto texts = method_texts_in(*list);
  if (!texts) return tl::unexpected(texts.error());
  std::vector<LabelledMethod> methods;
  for (const std::string& text : *texts) {
    auto method = method_from_text(text);
    if (!method) return tl::unexpected(std::move(method.error()));
    methods.push_back({text, std::move(*method)});
  }
  return methods;
}

Expected<SmoothOptions> smoothing_options_in(const TaskRequest& request) {
  if (is_stated(request, "noise") + is_stated(request, "smoothing_time") + is_stated(request, "cutoff") > 1)
    return failure(ErrorCode::bad_argument,
                   "found several of `noise`, `smoothing_time` and `cutoff`, wanted one: each says how smooth");
  auto options = options_in<SmoothOptions>(request);
  if (!options) return options;
  const auto time = cutoff_time_in(request);
  if (!time) return tl::unexpected(time.error());
  if (*time) options->smoothing_time = **time;
  if (request.value("gyro")) options->gyro = true;
  if (auto sound = check(*options); !sound) return tl::unexpected(with_cutoff(request, std::move(sound.error())));
  return options;
}

Error with_cutoff(const TaskRequest& request, Error error) {
  if (!is_stated(request, "cutoff") || error.option != "smoothing_time") return error;
  error.option = "cutoff";
  error.message = formatted("its smoothing time 1/(2 pi f) is out of range: {}", error.message);
  return error;
}

Expected<void> check_unset(const TaskRequest& request, std::initializer_list<std::string_view> names,
                           std::string_view message) {
  for (const std::string_view name : names) {
    const FieldValue* const value = request.stated(name);
    if (value && !is_absent(*value) && text_of(*value) != "false") return bad_option(name, std::string(message));
  }
  return {};
}

}}}  // namespace orispline::jobs
