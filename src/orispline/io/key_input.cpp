// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_input.hpp>

#include <utility>

#include <orispline/io/key_columns.hpp>
#include <orispline/io/line_reader.hpp>
#include <orispline/io/recipe_line.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::size_t most_comments = std::size_t{1} << 20;  // [bytes] read ahead for a recipe

/// The comments before the first row. A line that is no text is left to whoever reads the keys.
Expected<Recipe> recipe_above_rows(LineReader& lines) {
  Recipe found;
  while (lines.bytes_read() <= most_comments) {
    const auto line = lines.next();
    if (!line || !*line) break;
    const std::size_t text = (*line)->find_first_not_of(" \t");
    if (text == std::string_view::npos) continue;
    if ((**line)[text] != '#') break;
    auto recipe = recipe_in((*line)->substr(text));
    const Where here{lines.path(), lines.line()};
    if (!recipe) {
      recipe.error().where = here;
      return tl::unexpected(std::move(recipe.error()));
    }
    if (!*recipe) continue;
    if (found.line != 0)
      return mended_by("recipe", "a second comment names the method of the keys, wanted one at most", here);
    found = std::move(**recipe);
    found.line = lines.line();
  }
  return found;
}

}  // namespace

Expected<KeyInput> KeyInput::open(Input input, const ReadOptions& options) {
  if (auto checked = check(options.frames); !checked) return tl::unexpected(std::move(checked.error()));
  return LineReader::open(std::move(input)).and_then([&](LineReader lines) -> Expected<KeyInput> {
    if (options.recipe == RecipeUse::ignored) return KeyInput(std::move(lines), {});
    lines.keep();
    auto recipe = recipe_above_rows(lines);
    if (!recipe) return tl::unexpected(std::move(recipe.error()));
    lines.rewind();
    return KeyInput(std::move(lines), in_frames(std::move(*recipe), NewFrames(options.frames)));
  });
}

KeyInput::KeyInput(LineReader lines, Recipe recipe)
    : lines_(std::make_unique<LineReader>(std::move(lines))), recipe_(std::move(recipe)) {}
KeyInput::KeyInput(KeyInput&&) noexcept = default;
KeyInput& KeyInput::operator=(KeyInput&&) noexcept = default;
KeyInput::~KeyInput() = default;

const Input& KeyInput::input() const noexcept { return lines_->input(); }

const std::string& KeyInput::path() const noexcept { return lines_->path(); }

std::vector<std::string> KeyInput::header() {
  lines_->keep();
  TextTable table(std::move(*lines_));
  const auto more = table.next();
  std::vector<std::string> names;
  if (more && *more)
    for (const std::string_view name : header_of(table)) names.emplace_back(name);
  *lines_ = std::move(table).from_its_beginning();
  return names;
}

LineReader KeyInput::lines() && noexcept { return std::move(*lines_); }

Recipe recipe_of(const KeyInput& input, const ReadOptions& options) {
  Recipe recipe = input.recipe();
  if (options.gap) recipe.gap = options.gap;
  recipe.jumps = recipe.jumps || options.jumps;
  recipe.counts_turns = options.count_turns;
  return recipe;
}

}}}  // namespace orispline::io
