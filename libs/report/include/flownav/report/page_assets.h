#pragma once

namespace flownav::report {

/// Scripts and style sheets that pages carry so that they open offline: dygraphs (charts) with its licence,
/// script and style sheet of all pages (src/pages), and the script of report.html (src/report_page).
/// page_script reads the element `data` and stands before the script of a page. Made when flownav is built.
extern const char* const dygraphs_script;
extern const char* const dygraphs_style;
extern const char* const page_script;
extern const char* const page_style;
extern const char* const report_script;

}  // namespace flownav::report
