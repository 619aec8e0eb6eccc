#pragma once

namespace flownav::report {

/// What pages carry so that they open offline: dygraphs (charts) with its licence, the style sheet of all
/// pages, and the script of report.html. Made from those files when flownav is built.
extern const char* const dygraphs_script;
extern const char* const dygraphs_style;
extern const char* const report_script;
extern const char* const report_style;

}  // namespace flownav::report
