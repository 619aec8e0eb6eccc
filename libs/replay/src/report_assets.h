#pragma once

namespace flownav {

/// What report.html carries so that it opens offline: dygraphs (for the charts over time) with its licence,
/// and the page's own script and style sheet. Made from those files when flownav is built.
extern const char* const dygraphs_script;
extern const char* const dygraphs_style;
extern const char* const report_script;
extern const char* const report_style;

}  // namespace flownav
