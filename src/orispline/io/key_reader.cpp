// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_reader.hpp>

#include <utility>
#include <variant>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/io/format_choice.hpp>
#include <orispline/io/key_input.hpp>
#include <orispline/io/key_rows.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

/// The track of a file of one.
Expected<KeyFile> only_track(TracksSource source, const std::string& path, const ReadOptions& options) {
  auto tracks = source.format->reading.tracks(std::move(source.lines), options);
  if (!tracks) return tl::unexpected(std::move(tracks.error()));
  if (tracks->size() == 1) return std::move(tracks->front());
  return failure(ErrorCode::bad_data, formatted("found {} tracks, wanted a file of one", tracks->size()),
                 {.file = path});
}

}  // namespace

Expected<KeyReader> KeyReader::open(Input input, const ReadOptions& options) {
  return KeyInput::open(std::move(input), options).and_then([&](KeyInput opened) {
    return open(std::move(opened), options);
  });
}

Expected<KeyReader> KeyReader::open(KeyInput input, const ReadOptions& options) {
  if (options.session == all_sessions)
    return bad_option("session", "found all for what takes one recording, wanted the number of one");
  const std::string path = input.path();
  const Recipe recipe = recipe_of(input, options);
  ReadOptions stated = options;
  stated.jumps = recipe.jumps;
  auto reader = open_keys(std::move(input), options).and_then([&](auto source) -> Expected<KeyReader> {
    if (auto* const rows = std::get_if<KeyRowsSource>(&source)) return KeyReader(std::move(*rows), stated);
    return only_track(std::get<TracksSource>(std::move(source)), path, options).map([](KeyFile file) {
      return KeyReader(std::move(file));
    });
  });
  if (reader) reader->recipe_ = recipe;
  return reader;
}

/// Rows that are read one by one, or keys that were read at once.
struct KeyReader::Source {
  struct Table {
    TextTable cells;
    KeyRows rows;
    std::vector<std::string> names;  // of the columns, where the cells are kept
    bool is_at_new_row;              // that was not added yet
  };

  std::variant<Table, KeyFile> keys;

  /// Adds rows until there are that many keys; whether there are no more rows.
  [[nodiscard]] static Expected<bool> fill(Table& table, std::size_t most) {
    while (table.rows.size() < most || table.rows.needs_all()) {
      if (!table.is_at_new_row) {
        const auto more = table.cells.next();
        if (!more) return tl::unexpected(more.error());
        if (!*more) return table.rows.complete().map([] { return true; });
      }
      table.is_at_new_row = false;
      if (auto added = table.rows.add(table.cells); !added) return tl::unexpected(std::move(added.error()));
    }
    return false;
  }
};

KeyReader::KeyReader(KeyRowsSource source, const ReadOptions& options) : format_(source.format) {
  auto& [format, table, layout] = source;
  KeyRows rows(table.path(), *format, std::move(layout.columns), options);
  source_ = std::make_unique<Source>(
      Source{Source::Table{.cells = std::move(table),
                           .rows = std::move(rows),
                           .names = options.keep_table ? std::move(layout.names) : std::vector<std::string>(),
                           .is_at_new_row = layout.first_row == TableLayout::FirstRow::key}});
}

KeyReader::KeyReader(KeyFile file) : format_(file.format) {
  source_ = std::make_unique<Source>(Source{std::move(file)});
}

KeyReader::KeyReader(KeyReader&& other) noexcept = default;
KeyReader& KeyReader::operator=(KeyReader&& other) noexcept = default;
KeyReader::~KeyReader() = default;

const KeyColumns* KeyReader::columns() const noexcept {
  const auto* const table = std::get_if<Source::Table>(&source_->keys);
  return table ? &table->rows.columns() : nullptr;
}

std::size_t KeyReader::bytes_read() const noexcept {
  const auto* const table = std::get_if<Source::Table>(&source_->keys);
  return table ? table->cells.bytes_read() : 0;
}

Expected<bool> KeyReader::holds_two_tracks() {
  auto* const table = std::get_if<Source::Table>(&source_->keys);
  if (!table || is_at_end_ || table->rows.needs_all()) return false;
  const auto at_end = Source::fill(*table, 1);
  if (!at_end) return tl::unexpected(at_end.error());
  is_at_end_ = *at_end;
  return table->rows.are_two_tracks();
}

Expected<KeyFile> KeyReader::next(std::size_t most) {
  if (auto* const file = std::get_if<KeyFile>(&source_->keys)) {
    is_at_end_ = true;
    file->recipe = recipe_;
    return std::exchange(*file, {});
  }
  auto& table = std::get<Source::Table>(source_->keys);
  const auto at_end = is_at_end_ ? Expected<bool>(true) : Source::fill(table, most);
  if (!at_end) return tl::unexpected(at_end.error());
  is_at_end_ = *at_end;
  KeyFile keys = table.rows.take();
  keys.table.names = table.names;
  keys.recipe = recipe_;
  return keys;
}

}}}  // namespace orispline::io
