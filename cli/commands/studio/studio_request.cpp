// SPDX-License-Identifier: Apache-2.0
#include "commands/studio/studio_request.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/io/line_reader.hpp>
#include <orispline/io/track_file.hpp>

#include "options/method_options.hpp"
#include "options/scene_input.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  std::optional<Method> method, beside;
};

Expected<Method> second_method(OptionText option) { return method_request(option.text, {}, option.option); }

Expected<Request> request_in(const StudioArguments& options) {
  InputOptions input = options.reading;
  input.path = *options.keys;
  FirstError checked;
  Request request{.input = checked(input_request(input)),
                  .method = checked(named_method(options.method, {})),
                  .beside = checked(if_given("--beside", options.beside, second_method))};
  return std::move(checked).or_else(std::move(request));
}

/// In memory, where what is checked is what the page gets; a file of skeletons, which may name others, as it is.
Expected<io::Input> whole_input(const InputRequest& request) {
  if (is_scene(request)) return io::Input(request.path);
  return io::LineReader::open(request.path)
      .and_then([](io::LineReader reader) { return std::move(reader).bytes(); })
      .map([&](std::string bytes) { return io::Input::in_memory(request.path, std::move(bytes)); });
}

/// `for --columns changes how they are read`; empty where the page reads the file itself as it was read here.
std::string why_written_anew(const StudioArguments& options, const io::TrackFile& file) {
  const auto& reading = options.reading.reading;
  const auto given = std::ranges::find_if(reading, [](const auto& option) { return option.second.are_given(); });
  if (given != reading.end()) return formatted("for {} changes how they are read", flag_of(given->first));
  if (!file.format->reading.layout) return formatted("for it cannot read {}", file.format->file);
  return {};
}

/// The keys as a CSV file with all that it has room for.
Expected<std::string> csv_of(const Track& keys) {
  io::SampleColumns columns;
  columns.positions = !keys.keys.positions().empty();
  columns.derivatives = 3;  // as many as the keys have
  io::OutputFile file = io::OutputFile::in_memory(keys.name);
  return io::write_tracks(file, {&keys, 1}, columns).map([&] { return std::move(file).bytes(); });
}

/// The file that the page edits.
struct EditedFile {
  std::string name, bytes;
};

Expected<EditedFile> edited_file(const StudioArguments& options, const io::Input& whole, const io::TrackFile& file) {
  const std::string& path = whole.name();
  const std::string name =
      io::is_stream(path) ? formatted("keys{}", file.format->extensions.front()) : std::string(file_name_of(path));
  const std::string why = why_written_anew(options, file);
  if (why.empty()) return EditedFile{name, std::string(whole.bytes())};
  warn({{.code = "written_anew",
         .message = formatted("the page has the keys as a CSV file, {}", why),
         .where = {.file = path}}});
  return csv_of(file.track).map([&](std::string bytes) {
    const std::string_view stem = std::string_view(name).substr(0, name.size() - extension_of(name).size());
    return EditedFile{formatted("{}{}", stem, io::csv_format.extensions.front()), std::move(bytes)};
  });
}

}  // namespace

Expected<jobs::StudioRequest> studio_request(const StudioArguments& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  const auto whole = whole_input(request->input);
  if (!whole) return tl::unexpected(whole.error());
  auto input = io::KeyInput::open(*whole, request->input.read);
  if (!input) return tl::unexpected(std::move(input.error()));
  auto chosen = chosen_method(request->method, {}, *input, {default_method});
  if (!chosen) return tl::unexpected(std::move(chosen.error()));
  std::vector<Method> methods{chosen->method};
  if (request->beside) methods.push_back(*request->beside);
  io::ReadOptions read = read_for(methods, std::move(request->input.read));
  read.keep_exact_times = read.keep_as_read = true;
  auto file = io::read_track(std::move(*input), read, request->input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  warn(file->warnings);
  auto edited = edited_file(options, *whole, *file);
  if (!edited) return tl::unexpected(std::move(edited.error()));
  return jobs::StudioRequest{.name = std::move(edited->name),
                             .bytes = std::move(edited->bytes),
                             .keys = std::make_shared<const Track>(std::move(file->track)),
                             .method = std::move(*chosen),
                             .beside = std::move(request->beside)};
}

}  // namespace orispline::cli
