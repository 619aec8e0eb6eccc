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

/// A page of flownav-regress that opens offline: title, body (HTML), data (JSON), and the page's own assets.
std::string page(const std::string& title, const std::string& body, const std::string& data,
                 const PageAssets& assets);

}  // namespace flownav::regress
