// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_file.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/format_choice.hpp>
#include <orispline/io/key_input.hpp>
#include <orispline/io/key_reader.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

Expected<std::vector<KeyFile>> keys_in(KeyRowsSource source, const ReadOptions& options) {
  return KeyReader(std::move(source), options).next().map([](KeyFile file) {
    std::vector<KeyFile> one;
    one.push_back(std::move(file));
    return one;
  });
}

Expected<std::vector<KeyFile>> keys_in(TracksSource source, const ReadOptions& options) {
  return source.format->reading.tracks(std::move(source.lines), options);
}

}  // namespace

Expected<std::vector<KeyFile>> read_all_keys(const std::string& path, const ReadOptions& options) {
  return KeyInput::open(path, options).and_then([&](KeyInput input) {
    return read_all_keys(std::move(input), options);
  });
}

Expected<std::vector<KeyFile>> read_all_keys(KeyInput input, const ReadOptions& options) {
  const Recipe recipe = input.recipe();
  auto files = open_keys(std::move(input), options).and_then([&](auto source) {
    return std::visit([&](auto&& open) { return keys_in(std::move(open), options); }, std::move(source));
  });
  if (files)
    for (KeyFile& file : *files) file.recipe = recipe;
  return files;
}

Expected<KeyFile> read_keys(const std::string& path, const ReadOptions& options) {
  return KeyReader::open(path, options).and_then([](KeyReader reader) { return reader.next(); });
}

Expected<KeyFile> read_keys(KeyInput input, const ReadOptions& options) {
  return KeyReader::open(std::move(input), options).and_then([](KeyReader reader) { return reader.next(); });
}

Error located(const KeyFile& file, Error error) {
  error.where.file = file.path;
  if (error.where.key && *error.where.key < file.lines.size()) error.where.line = file.lines[*error.where.key];
  return error;
}

}}}  // namespace orispline::io
