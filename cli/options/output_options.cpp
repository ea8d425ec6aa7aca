// SPDX-License-Identifier: Apache-2.0
#include "options/output_options.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/track.hpp>

#include "options/file_places.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view format_option = "output_format";

io::StatedOptions stated_in(const OutputOptions& options) {
  io::StatedOptions stated;
  for (const auto& option : io::writing_options())
    if (const auto typed = options.writing.find(option.name); typed != options.writing.end() && typed->second)
      stated.emplace_back(option.name, *typed->second);
  return stated;
}

/// The error with the option by which the user named the path.
Error naming_output_option(const OutputOptions& options, Error error) {
  if (error.option != "path") return with_flags(std::move(error));
  const std::size_t cure = error.message.rfind("; ");
  if (!options.scenes.empty() && cure != std::string::npos)
    error.message.insert(cure, formatted(", or for a skeleton in {}", endings_of(options.scenes)));
  error.message = formatted("{}: {}", options.option, error.message);
  error.option.clear();
  return with_flags(std::move(error));
}

}  // namespace

std::vector<const scenes::SceneFormat*> scenes_written() {
  std::vector<const scenes::SceneFormat*> written;
  std::ranges::copy_if(scenes::scene_formats(), std::back_inserter(written),
                       [](const scenes::SceneFormat* format) { return format->write != nullptr; });
  return written;
}

std::string endings_of(const std::vector<const scenes::SceneFormat*>& formats) {
  std::vector<std::string_view> endings;
  for (const scenes::SceneFormat* const format : formats)
    endings.insert(endings.end(), format->extensions.begin(), format->extensions.end());
  if (endings.size() < 2) return joined(endings, "");
  const std::string_view last = endings.back();
  endings.pop_back();
  return formatted("{} or {}", joined(endings, ", "), last);
}

const scenes::SceneFormat* scene_format_in(const std::string& word) {
  const scenes::SceneFormat* const named = scenes::scene_format_named(word);
  return named ? named : scenes::scene_format_of("x." + word);
}

Expected<void> check_no_skeleton_format(const OutputOptions& options) {
  const auto typed = options.writing.find(format_option);
  if (typed == options.writing.end() || !typed->second) return {};
  const std::string& word = *typed->second;
  if (!scene_format_in(word)) return {};
  const std::string words = one_of(io::formats_written());
  if (options.scenes.empty()) return wanted({"--output-format", word}, words);
  return wanted({"--output-format", word}, formatted("{}; a file of skeletons goes by its name, which ends in {}",
                                                     words, endings_of(options.scenes)));
}

std::string_view place_of_output(const OutputOptions& options) {
  return options.option == "-o" ? "that of -o" : "the output";
}

Expected<std::string_view> folder_extension(const OutputOptions& options, std::string_view written) {
  if (options.path != io::standard_stream && !options.path.empty())
    return usage_failure(
        formatted("found -o and --output-folder, wanted one of them: a file for the {}, or their folder", written));
  return output_format(options).map([](std::optional<const io::FormatInfo*> format) {
    return format ? (*format)->extensions.front() : std::string_view();
  });
}

std::string formats_that(bool (*are)(const io::FormatInfo&)) {
  auto some = io::formats_written();
  std::erase_if(some, [are](const io::FormatInfo* format) { return !are(*format); });
  return io::any_of(some);
}

Expected<void> check_settings_fit(const Track& keys, const io::SampleColumns& columns, std::string_view output,
                                  std::string_view promise) {
  if (!keys.keys.angular_velocities().empty() && !columns.format->holds.rates)
    return usage_failure(formatted("{}: {} has no columns for the rates of the keys, with which {}, wanted {}", output,
                                   columns.format->file, promise,
                                   formats_that([](const auto& f) { return f.keeps_times() && f.holds.rates; })));
  if (keys.settings.empty() || columns.format->holds.settings) return {};
  return usage_failure(formatted("{}: {} has no column for {}, with which {}, wanted {}", output, columns.format->file,
                                 keys.settings.begin()->first, promise,
                                 formats_that([](const auto& f) { return f.keeps_times() && f.holds.settings; })));
}

Expected<void> check_times_are_kept(const io::FormatInfo& format, std::string_view option, std::string_view promise) {
  if (format.keeps_times()) return {};
  return usage_failure(formatted("{}: {} rounds times, and {} may not hold with rounded times; wanted {}", option,
                                 format.file, promise, formats_that([](const auto& f) { return f.keeps_times(); })));
}

Expected<std::optional<const io::FormatInfo*>> output_format(const OutputOptions& options) {
  const auto typed = options.writing.find(format_option);
  if (typed == options.writing.end()) return std::nullopt;
  if (auto fits = check_no_skeleton_format(options); !fits) return tl::unexpected(std::move(fits.error()));
  return if_given("--output-format", typed->second, [](OptionText o) { return format_in(o, io::formats_written()); });
}

io::SampleColumns columns_like(const io::FormatInfo& input, io::SampleColumns columns, const OutputOptions& options) {
  return io::columns_like(input, std::move(columns), options.path, stated_in(options));
}

Expected<io::SampleColumns> output_columns(const OutputOptions& options) {
  if (options.position_scale)
    return usage_failure(formatted("--position-scale: found an output of one track, wanted a skeleton in {}",
                                   endings_of({&scenes::gltf_format})));
  if (options.compress)
    return usage_failure(formatted("--compress: found an output of one track, wanted a skeleton in {}",
                                   endings_of({&scenes::gltf_format})));
  return check_no_skeleton_format(options).and_then([&] {
    return io::columns_of_output(options.path, stated_in(options)).map_error([&](Error error) {
      return naming_output_option(options, std::move(error));
    });
  });
}

}  // namespace orispline::cli
