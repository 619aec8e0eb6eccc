#pragma once

#include <string>

namespace flownav::regress {

/// The script and the style sheet of a page, from the folder pages/.
struct PageAssets {
    const char* script;
    const char* style;
};

extern const PageAssets compare_assets;
extern const PageAssets sweep_assets;

/// A whole page that opens offline: title and heading, `body` (HTML), `data` (JSON, in the element `data`),
/// the style sheet that all pages share, dygraphs, then the page's own.
std::string page(const std::string& title, const std::string& body, const std::string& data,
                 const PageAssets& assets);

}  // namespace flownav::regress
