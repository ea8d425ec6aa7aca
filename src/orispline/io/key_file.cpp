// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_file.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/format_choice.hpp>
#include <orispline/io/key_input.hpp>
#include <orispline/io/key_reader.hpp>
#include <orispline/io/key_rows.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

Expected<std::vector<KeyFile>> keys_in(KeyRowsSource source, const ReadOptions& options) {
  return KeyReader(std::move(source), options).next().map([](KeyFile file) {
    std::vector<KeyFile> one;
    one.push_back(std::move(file));
    return one;
  });
}

/// Each of the recordings in a file, which is read once for each.
Expected<std::vector<KeyFile>> each_session(const Input& input, ReadOptions options) {
  const auto count = sessions_in(input, options);
  if (!count) return tl::unexpected(count.error());
  std::vector<KeyFile> files;
  for (std::size_t session = 1; session <= *count; ++session) {
    options.session = session;
    auto file = read_keys(input, options);
    if (!file) return tl::unexpected(std::move(file.error()));
    files.push_back(std::move(*file));
  }
  return files;
}

Expected<std::size_t> sessions_in(KeyRowsSource source, ReadOptions options) {
  options.session = 1;
  KeyRows rows(source.table.path(), *source.format, std::move(source.layout.columns), options);
  const bool is_at_key = source.layout.first_row == TableLayout::FirstRow::key;
  for (auto more = is_at_key ? Expected<bool>(true) : source.table.next();; more = source.table.next()) {
    if (!more) return tl::unexpected(std::move(more.error()));
    if (!*more) return rows.sessions();
    if (auto added = rows.add(source.table); !added) return tl::unexpected(std::move(added.error()));
  }
}

Expected<std::vector<KeyFile>> keys_in(TracksSource source, const ReadOptions& options) {
  return source.format->reading.tracks(std::move(source.lines), options);
}

}  // namespace

Expected<std::vector<KeyFile>> read_all_keys(const Input& input, const ReadOptions& options) {
  return KeyInput::open(input, options).and_then([&](KeyInput opened) {
    return read_all_keys(std::move(opened), options);
  });
}

Expected<std::size_t> sessions_in(const Input& input, const ReadOptions& options) {
  if (input.is_standard_input())
    return bad_option("session", "found all with standard input, which can be read once only; wanted a file");
  return KeyInput::open(input, options)
      .and_then([&](KeyInput opened) { return open_keys(std::move(opened), options); })
      .and_then([&](auto source) -> Expected<std::size_t> {
        auto* const rows = std::get_if<KeyRowsSource>(&source);
        return rows ? sessions_in(std::move(*rows), options) : Expected<std::size_t>(1);
      });
}

Expected<std::vector<KeyFile>> read_all_keys(KeyInput input, const ReadOptions& options) {
  if (options.session == all_sessions) return each_session(Input(input.input()), options);
  const Recipe recipe = recipe_of(input, options);
  ReadOptions stated = options;
  stated.jumps = recipe.jumps;
  auto files = open_keys(std::move(input), options).and_then([&](auto source) {
    return std::visit([&](auto&& open) { return keys_in(std::forward<decltype(open)>(open), stated); },
                      std::move(source));
  });
  if (files)
    for (KeyFile& file : *files) file.recipe = recipe;
  return files;
}

Expected<KeyFile> read_keys(const Input& input, const ReadOptions& options) {
  return KeyReader::open(input, options).and_then([](KeyReader reader) { return reader.next(); });
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
