#include "flownav/replay/report.h"

#include <mrpt/system/string_utils.h>

#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "flownav/core/version.h"
#include "flownav/replay/annotated_field.h"
#include "flownav/replay/curves.h"
#include "flownav/replay/map_picture.h"
#include "flownav/replay/number_text.h"
#include "report_style.h"

namespace flownav {

namespace {

constexpr std::size_t pictures = 6;
constexpr int jpeg_quality = 82;

std::string section(const std::string& title, const std::string& content) {
    return "<section>\n<h2>" + html_text(title) + "</h2>\n" + content + "</section>\n";
}

std::string paragraph(const std::string& text) {
    return "<p>" + html_text(text) + "</p>\n";
}

/// A cell of a table; numbers stand to the right.
struct Cell {
    std::string text;
    bool number = false;
    const char* mark = nullptr;  ///< colour of a small square before the text
};

std::string row(const std::vector<Cell>& cells, const std::string& element = "td") {
    std::string html = "<tr>";
    for (const Cell& cell : cells) {
        html += "<" + element + (cell.number ? " class='number'>" : ">");
        if (cell.mark != nullptr) html += std::string("<i style='background:") + cell.mark + "'></i>";
        html += html_text(cell.text) + "</" + element + ">";
    }
    return html + "</tr>\n";
}

std::string table(const std::vector<Cell>& head, const std::string& rows) {
    return "<div class='wide'><table>\n<thead>" + row(head, "th") + "</thead>\n<tbody>\n" + rows +
           "</tbody></table></div>\n";
}

Cell number(std::uint64_t count) {
    return {std::to_string(count), true, nullptr};
}

std::string image(const cv::Mat& picture, const char* format, const std::vector<int>& options,
                  const std::string& description) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(std::string(".") + format, picture, bytes, options);
    std::string text;
    mrpt::system::encodeBase64(bytes, text);
    return "<img alt='" + html_text(description) + "' src='data:image/" +
           (std::string(format) == "jpg" ? "jpeg" : format) + ";base64," + text + "'>\n";
}

// ---- what was read, and how it ended

std::string ending(const Drive& drive) {
    const bool clean = std::string(end_word(drive)) == "clean";
    return std::string("<p class='") + (clean ? "good" : "bad") + "'>" + html_text(end_sentence(drive)) +
           "</p>\n";
}

std::string camera_warnings(const CameraCheck& check) {
    std::string html;
    for (const std::string& warning : check.warnings)
        html += "<p class='bad'>" + html_text(warning) + "</p>\n";
    return html;
}

std::string short_facts(const Drive& drive) {
    if (drive.rows.empty()) return paragraph("No field could be used, so there is nothing to show.");
    const double duration_s = drive.rows.back().timestamp_s - drive.rows.front().timestamp_s;
    const std::uint64_t ok = status_counts(drive.rows).front();
    const double ok_percent = 100.0 * static_cast<double>(ok) / static_cast<double>(drive.rows.size());
    return paragraph(std::to_string(drive.rows.size()) + " fields over " + fixed_text(duration_s, 2) +
                     " s; the motion was measured in " + fixed_text(ok_percent, 1) + " % of them. " +
                     std::to_string(drive.written.cycles) + " finished cycles gave " +
                     std::to_string(drive.written.obstacle_points) + " obstacle points.");
}

// ---- figures

Cell figure_cell(const Errors& errors, const Figure& figure) {
    const auto& value = errors.*figure.value;
    return {value ? fixed_text(*value, 3) : "-", true, nullptr};
}

std::string figures(const Drive& drive) {
    if (!drive.ground_truth_errors && !drive.odometry_errors) {
        return paragraph(
            "The recording has neither odometry nor ground truth to compare the flow odometry with.");
    }
    std::vector<Cell> head = {{"figure"}};
    if (drive.ground_truth_errors) head.push_back({"ground truth", true, nullptr});
    if (drive.odometry_errors) head.push_back({"odometry", true, nullptr});
    head.insert(head.end(), {{"unit"}, {"flow odometry compared with these, meaning"}});
    std::string rows;
    for (const Figure& figure : error_figures()) {
        std::vector<Cell> cells = {{figure.name}};
        if (drive.ground_truth_errors) cells.push_back(figure_cell(*drive.ground_truth_errors, figure));
        if (drive.odometry_errors) cells.push_back(figure_cell(*drive.odometry_errors, figure));
        cells.insert(cells.end(), {{figure.unit}, {figure.meaning}});
        rows += row(cells);
    }
    return table(head, rows) + paragraph(
                                   "A dash stands for a figure that could not be computed. Poses of the "
                                   "other track are interpolated at the "
                                   "times of the fields; the first " +
                                   std::to_string(Errors::settling_fields) +
                                   " fields, in which the sensor finds its first prediction, are left out of "
                                   "the figures of turn rate and speed.");
}

// ---- status and counts

std::string statuses(const Drive& drive) {
    const auto counts = status_counts(drive.rows);
    std::string rows;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const FieldStatus status = all_field_statuses.at(i);
        rows += row({{to_string(status), false, colour_of(status)}, number(counts[i]), {explain(status)}});
    }
    return table({{"status"}, {"fields", true, nullptr}, {"meaning"}}, rows);
}

std::string read_and_rejected(const Drive& drive) {
    const InputCounts& read = drive.read;
    std::string rows;
    rows += row({{"objects in the file"}, number(read.objects), {"read"}});
    rows += row({{"images of the camera"}, number(read.images), {"read"}});
    rows += row({{"fields"}, number(read.fields), {"used; a woven frame makes two"}});
    rows += row({{"odometry"}, number(read.odometry), {"used for comparison only"}});
    rows += row({{"ground truth"}, number(read.ground_truth), {"used for comparison only"}});
    rows += row({{"other observations"}, number(read.ignored), {"ignored: other labels or classes"}});
    for (const auto& [reason, count] : read.rejected) {
        rows += row({{reason}, number(count), {"rejected for this reason"}});
    }
    for (const auto& [warning, count] : read.warnings) {
        rows += row({{warning}, number(count), {"noticed, used all the same"}});
    }
    const std::string none = read.rejected.empty() ? paragraph("Nothing was rejected.") : "";
    return table({{"what"}, {"count", true, nullptr}, {"what became of it"}}, rows) + none;
}

// ---- pictures

std::string picture_caption(const Drive& drive, const pipeline::Step& step) {
    return "t = " + fixed_text(step.timestamp_s - drive.rows.front().timestamp_s, 2) +
           " s: " + to_string(step.status) + ", " + std::to_string(step.obstacles.size()) +
           " obstacle points";
}

std::string annotated(const Drive& drive) {
    auto chosen = drive.cycle_ends.spread(pictures);
    if (chosen.size() < pictures) chosen = drive.any_fields.spread(pictures);
    if (chosen.empty()) return paragraph("There is no field to show.");
    std::string html = paragraph(
                           "Arrows are the measured vectors of the cycle, from the reference field to this "
                           "one, ending where "
                           "the block is now. Fields with half the lines are shown at their true height.") +
                       "<div class='pictures'>\n";
    for (const auto* picture : chosen) {
        const std::string caption = picture_caption(drive, picture->step);
        html += "<figure>" +
                image(annotated_field(picture->field, picture->step), "jpg",
                      {cv::IMWRITE_JPEG_QUALITY, jpeg_quality}, caption) +
                "<figcaption>" + html_text(caption) + "</figcaption></figure>\n";
    }
    return html + "</div>\n";
}

std::string map_section(const Drive& drive, const mrpt::maps::COccupancyGridMap2D& map) {
    const cv::Mat picture = map_picture(map, drive.rows);
    if (picture.empty()) return paragraph("Nothing was mapped.");
    return paragraph(
               "White is floor seen to be free, black is occupied, grey is unknown. x points right and y up, "
               "as "
               "in the trajectory. Blue: the path driven, from the green to the orange dot.") +
           image(picture, "png", {cv::IMWRITE_PNG_COMPRESSION, 9}, "map of the drive");
}

std::string curves(const Drive& drive) {
    std::string html;
    for (const Chart& chart : charts_of(drive)) html += "<figure>" + svg_chart(chart) + "</figure>\n";
    return html + "<figure>" + status_band(drive.rows) + "</figure>\n";
}

}  // namespace

std::string report_html(const Drive& drive, const mrpt::maps::COccupancyGridMap2D& map) {
    const std::string title = "Replay of " + drive.input_name;
    std::string html =
        "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'>\n"
        "<meta name='viewport' content='width=device-width, initial-scale=1'>\n<title>" +
        html_text(title) + "</title>\n<style>\n" + report_style + "</style>\n</head>\n<body>\n";
    html += "<h1>" + html_text(title) + "</h1>\n" + ending(drive) + camera_warnings(drive.camera_check) +
            short_facts(drive);
    html += section("Flow odometry compared", figures(drive));
    if (!drive.rows.empty()) {
        html += section("Curves", curves(drive));
        html += section("Map", map_section(drive, map));
        html += section("Annotated fields", annotated(drive));
    }
    html += section("Status of the fields", statuses(drive));
    html += section("What was read and rejected", read_and_rejected(drive));
    return html + "<footer>flownav-replay " + html_text(version()) +
           ". Configuration and timing: summary.json beside this file.</footer>\n</body>\n</html>\n";
}

}  // namespace flownav
