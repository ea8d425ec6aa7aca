// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <orispline/base/expected.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/report/page.hpp>

#include "options/has_pages.hpp"
#include "options/report_options.hpp"
#include "output/noted_output.hpp"

namespace orispline::cli {

/// The file of `--report`; does nothing where none was asked for.
///
/// It is opened before the work, so that a wrong path is told at once, and takes the place of an older report only when
/// it is finished.
class ReportFile {
 public:
  /// Error: bad_access.
  [[nodiscard]] static Expected<ReportFile> open(const ReportOptions& options);

  /// Makes the page from its head and writes it. Error: bad_access.
  ///
  /// `make_page` takes `auto`, so that a build without pages does not refer to what it lacks.
  template <class MakePage>
  [[nodiscard]] Expected<void> write(MakePage make_page) {
    if constexpr (has_pages)
      if (output_) return made(make_page(head()));
    return {};
  }

  /// Error: bad_access.
  [[nodiscard]] Expected<void> finish();

 private:
  ReportFile() = default;
  [[nodiscard]] pages::PageHead head() const;
  [[nodiscard]] Expected<void> made(const report::Page& page) { return output_->file.write(report::document(page)); }
  [[nodiscard]] Expected<void> made(const Expected<std::string>& html) {
    return html.and_then([this](const std::string& text) { return output_->file.write(text); });
  }

  std::string command_line_;
  std::optional<Noted<io::OutputFile>> output_;
};

}  // namespace orispline::cli
