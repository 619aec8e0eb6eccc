#include "flownav/report/html.h"

namespace flownav::report::html {

namespace {

std::string cells_of(const std::vector<Cell>& cells, const std::string& element) {
    std::string html;
    for (const Cell& cell : cells) {
        html += "<" + element + (cell.number ? " class='number'>" : ">");
        if (!cell.mark.empty()) html += "<i style='background:" + escaped(cell.mark) + "'></i>";
        html += escaped(cell.text) + "</" + element + ">";
    }
    return html;
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string inside_script(const std::string& json) {
    std::string text;
    for (const char c : json) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

std::string paragraph(const std::string& text) {
    return "<p>" + escaped(text) + "</p>\n";
}

std::string section(const std::string& title, const std::string& content) {
    return "<section>\n<h2>" + escaped(title) + "</h2>\n" + content + "</section>\n";
}

std::string row(const std::vector<Cell>& cells, const std::string& key) {
    const std::string named = key.empty() ? "" : " data-key='" + escaped(key) + "'";
    return "<tr" + named + ">" + cells_of(cells, "td") + "</tr>\n";
}

std::string table(const std::vector<Cell>& head, const std::string& rows) {
    return "<div class='wide'><table>\n<thead><tr>" + cells_of(head, "th") + "</tr></thead>\n<tbody>\n" +
           rows + "</tbody></table></div>\n";
}

}  // namespace flownav::report::html
