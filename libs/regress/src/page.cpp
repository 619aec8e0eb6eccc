#include "flownav/report/page.h"

#include "flownav/core/version.h"
#include "pages.h"

namespace flownav::regress {

std::string page(const std::string& title, const std::string& body, const std::string& data,
                 const PageAssets& assets) {
    const std::string footer =
        std::string("flownav-regress ") + version() + ". What it means: share/doc/regression.md of flownav.";
    return report::page_html({title, body, footer, data, assets.style, assets.script});
}

}  // namespace flownav::regress
