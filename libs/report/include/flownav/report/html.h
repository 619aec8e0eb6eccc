#pragma once
#include <string>
#include <vector>

/// Small pieces of web pages.
namespace flownav::report::html {

/// Text with the characters replaced that mean something in HTML.
std::string escaped(const std::string& text);

/// JSON that cannot end the script element around it, nor open a comment there: '<', which may stand in
/// strings only, becomes its number.
std::string inside_script(const std::string& json);

std::string paragraph(const std::string& text);

/// Content, which is HTML, under a heading.
std::string section(const std::string& title, const std::string& content);

/// A cell of a table; numbers stand to the right.
struct Cell {
    Cell(std::string content = "", bool is_number = false) : text(std::move(content)), number(is_number) {}
    std::string text;
    bool number = false;
    std::string mark;  ///< colour of a small square before the text
};

/// `key` tells programs which figure the row holds; may be empty.
std::string row(const std::vector<Cell>& cells, const std::string& key = "");

/// `rows` is HTML.
std::string table(const std::vector<Cell>& head, const std::string& rows);

}  // namespace flownav::report::html
