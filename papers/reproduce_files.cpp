// SPDX-License-Identifier: Apache-2.0
#include "papers/reproduce_files.hpp"

#include <filesystem>

#include <orispline/io/output_file.hpp>

#include "output/noted_output.hpp"
#include "output/output_folder.hpp"

namespace orispline::cli {

namespace {

std::size_t files_of(const std::vector<ExperimentReport>& reports) {
  std::size_t files = 0;
  for (const ExperimentReport& report : reports) files += report.picture_files.size() + report.table_files.size();
  return files;
}

/// Writes a file of that name into the folder, behind those of the reports; its path.
Expected<std::string> written(const std::vector<ExperimentReport>& reports, const std::string& folder,
                              const std::string& name, const std::string& text) {
  std::string path = (std::filesystem::path(folder) / name).string();
  return open_output(path)
      .and_then([&](Noted<io::OutputFile> output) {
        return output.file.write(text).and_then([&] { return output.file.finish(); });
      })
      .map([&] { return std::move(path); })
      .map_error([&](Error error) { return with_written(std::move(error), files_of(reports)); });
}

}  // namespace

Expected<void> write_pictures(std::vector<ExperimentReport>& reports, const std::string& folder) {
  if (auto made = make_folder(folder); !made) return made;
  for (ExperimentReport& report : reports)
    for (const Picture& picture : report.findings.pictures) {
      auto path = written(reports, folder, picture.name() + ".svg", picture.drawing.document());
      if (!path) return tl::unexpected(std::move(path.error()));
      report.picture_files.push_back(std::move(*path));
    }
  return {};
}

Expected<void> write_all(std::vector<ExperimentReport>& reports, const std::string& folder) {
  if (auto pictures = write_pictures(reports, folder); !pictures) return pictures;
  for (ExperimentReport& report : reports)
    for (const auto& [extension, text] : {std::pair{".txt", text_of(report)}, std::pair{".json", json_of(report)}}) {
      auto path = written(reports, folder, report.name + extension, text);
      if (!path) return tl::unexpected(std::move(path.error()));
      report.table_files.push_back(std::move(*path));
    }
  return {};
}

}  // namespace orispline::cli
