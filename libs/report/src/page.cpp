#include "flownav/report/page.h"

#include "flownav/report/html.h"
#include "flownav/report/page_assets.h"
#include "flownav/report/palette.h"

namespace flownav::report {

namespace {

std::string script_element(const std::string& script) {
    return "<script>" + script + "</script>\n";
}

}  // namespace

std::string page_html(const Page& page) {
    const std::string title = html::escaped(page.title);
    std::string html =
        "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'>\n"
        "<meta name='viewport' content='width=device-width, initial-scale=1'>\n"
        "<link rel='icon' href='data:,'>\n<title>" +
        title + "</title>\n<style>\n" + dygraphs_style + css_variables() + page_style + page.style +
        "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n" + page.body + "<footer>" +
        html::escaped(page.footer) + "</footer>\n";
    if (!page.data.empty()) {
        html += "<script type='application/json' id='data'>" + html::inside_script(page.data) + "</script>\n";
        for (const std::string& script :
             {std::string(dygraphs_script), std::string(page_script), page.script})
            html += script_element(script);
    }
    return html + "</body>\n</html>\n";
}

}  // namespace flownav::report
