#pragma once
#include <string>

namespace flownav::report {

/// The parts of a web page.
struct Page {
    std::string title;   ///< text; the heading as well
    std::string body;    ///< HTML
    std::string footer;  ///< text
    std::string data;    ///< JSON, for the scripts; empty: a page without scripts
    std::string style;   ///< CSS of its own
    std::string script;  ///< JavaScript of its own, after that of all pages
};

/// One HTML file that opens offline, with the palette, the style sheet and the script of all pages, and
/// dygraphs.
std::string page_html(const Page& page);

}  // namespace flownav::report
