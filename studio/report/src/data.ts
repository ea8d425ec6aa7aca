// SPDX-License-Identifier: Apache-2.0
// The data of the page, or a sentence where they cannot be shown.
import { readDocument, reportOf, type Report, type ReportDocument } from 'orispline-viewer';

/** The head of a report, with a sentence instead of all else. */
const onlySaying = (warning: string, { title = 'orispline report', date = '', version = '', notes = [] }: ReportDocument = {}): Report =>
  reportOf({ title, date, version, notes, warnings: [warning] });

export function readPage(text: string): Report {
  if (!/["{[]/.test(text)) return onlySaying('This page has no data: it is what orispline writes its reports into.');
  let written: ReportDocument;
  try {
    written = JSON.parse(text);
  } catch (error) {
    return onlySaying(`The data of this page cannot be read, since they are not JSON: ${(error as Error).message}. Make the report again.`);
  }
  if (typeof written !== 'object' || written === null || Array.isArray(written)) return onlySaying('The data of this page are no report. Make it again.');
  try {
    return readDocument(written);
  } catch (error) {
    return onlySaying(`The data of this page cannot be shown: ${(error as Error).message}. Make the report again with one version of orispline.`, written);
  }
}
