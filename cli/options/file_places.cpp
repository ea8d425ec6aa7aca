// SPDX-License-Identifier: Apache-2.0
#include "options/file_places.hpp"

#include <algorithm>
#include <filesystem>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/file_system.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

namespace {

namespace fs = std::filesystem;

/// Where a file is, or would be; as it stands where that cannot be said.
fs::path place_of(const std::string& path) {
  std::error_code unknown;
  auto place = fs::weakly_canonical(fs::absolute(io::behind_links(path), unknown), unknown);
  return unknown ? fs::path(path) : place;
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

/// Whether a .gltf file names it.
bool is_part_of(const std::string& path, const std::string& scene) {
  std::error_code unknown;
  const fs::path part = fs::path(path);
  if (!has_extension(scene, ".gltf") || !fs::is_regular_file(part, unknown) ||
      place_of(path).parent_path() != place_of(scene).parent_path())
    return false;
  const auto text = scenes::bytes_of_file(scene);
  return text && text->find(formatted("\"{}\"", part.filename().string())) != std::string::npos;
}

}  // namespace

bool is_same_file(const std::string& a, const std::string& b) {
  if (io::is_stream(a) || io::is_stream(b)) return false;
  std::error_code unknown;  // such as a file that is not there
  return place_of(a) == place_of(b) || fs::equivalent(a, b, unknown);
}

std::string lost_with(const std::string& path, const std::vector<OtherFile>& others) {
  for (const OtherFile& other : others) {
    if (is_same_file(path, other.path)) return std::string(other.name);
    if (is_part_of(path, other.path)) return formatted("a part of {}", other.name);
  }
  return {};
}

Expected<void> check_output_apart(std::string_view option, const std::string& output,
                                  const std::vector<OtherFile>& read) {
  std::string lost = lost_with(output, read);
  std::error_code unknown;  // such as systems without that name
  for (const OtherFile& other : read)
    if (other.path == io::standard_stream && !io::is_stream(output) && fs::equivalent("/dev/stdin", output, unknown))
      lost = other.name;
  if (lost.empty()) return {};
  return wanted({option, output}, formatted("another file than {}, which would be lost", lost));
}

bool has_extension(const std::string& path, std::string_view extension) {
  return in_small_letters(fs::path(path).extension().string()) == extension;
}

bool has_name_of(bool (io::FormatInfo::*is_so)() const noexcept, const std::string& path) {
  const io::FormatInfo* const format = io::format_of_extension(path);
  return has_extension(path, any_text) || (format && (format->*is_so)());
}

Expected<void> check_extension(std::string_view option, const std::string& output,
                               std::vector<std::string_view> extensions, std::string_view cure) {
  const std::string extension = in_small_letters(fs::path(output).extension().string());
  if (io::is_stream(output) || extension.empty() || std::ranges::find(extensions, extension) != extensions.end())
    return {};
  const std::string_view last = extensions.back();
  extensions.pop_back();
  return wanted({option, output}, formatted("a name that ends in {}{}{}{}{}", joined(extensions, ", "),
                                            extensions.empty() ? "" : " or ", last, cure.empty() ? "" : "; ", cure));
}

}  // namespace orispline::cli
