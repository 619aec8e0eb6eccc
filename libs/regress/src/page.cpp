#include "flownav/core/version.h"
#include "flownav/report/html.h"
#include "flownav/report/page_assets.h"
#include "pages.h"

namespace flownav::regress {

std::string page(const std::string& title, const std::string& body, const std::string& data,
                 const PageAssets& assets) {
    const std::string name = report::html::escaped(title);
    return "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'>\n"
           "<meta name='viewport' content='width=device-width, initial-scale=1'>\n"
           "<link rel='icon' href='data:,'>\n<title>" +
           name + "</title>\n<style>\n" + report::dygraphs_style + report::report_style + assets.style +
           "</style>\n</head>\n<body>\n<h1>" + name + "</h1>\n" + body + "<footer>flownav-regress " +
           report::html::escaped(version()) +
           ". What it means: share/doc/regression.md of flownav.</footer>\n"
           "<script type='application/json' id='data'>" +
           report::html::inside_script(data) + "</script>\n<script>" + report::dygraphs_script +
           "</script>\n<script>" + assets.script + "</script>\n</body>\n</html>\n";
}

}  // namespace flownav::regress
