// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/sample_writer.hpp>

#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

Expected<SampleWriter> SampleWriter::open(const std::string& path, const SampleColumns& columns, std::size_t rows) {
  if (auto checked = check_columns(columns); !checked) return tl::unexpected(std::move(checked.error()));
  return OutputFile::open(path).and_then([&](OutputFile&& file) -> Expected<SampleWriter> {
    if (auto written = file.write(header_of(columns, rows)); !written)
      return tl::unexpected(std::move(written.error()));
    return SampleWriter(std::move(file), columns, rows);
  });
}

Expected<void> SampleWriter::write(const Decimal& time, const Sample& sample) {
  if (auto appended = pending_.append(time, sample); !appended) return appended;
  return pending_.bytes().size() < written_block ? Expected<void>() : write_pending();
}

Expected<void> SampleWriter::write(const SampleRows& rows) {
  if (auto written = write_pending(); !written) return written;
  if (auto checked = rows.may_follow(pending_); !checked) return checked;
  pending_.continue_after(rows);
  rows_ += rows.size();
  return file_.write(rows.bytes());
}

Expected<void> SampleWriter::write_pending() {
  rows_ += pending_.size();
  auto written = file_.write(pending_.bytes());
  pending_.clear();
  return written;
}

Expected<void> SampleWriter::close() {
  if (auto written = write_pending(); !written) return written;
  if (columns_.format->writing.counts_rows && rows_ != stated_rows_)
    if (auto counted = file_.write_again(header_of(columns_, rows_)); !counted) return counted;
  auto closed = file_.close();
  closed_ = closed.has_value();
  return closed;
}

Expected<void> SampleWriter::finish() {
  if (!closed_)
    if (auto closed = close(); !closed) return closed;
  return file_.finish();
}

}}}  // namespace orispline::io
