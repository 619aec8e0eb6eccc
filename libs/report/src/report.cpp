#include "flownav/report/report.h"

#include <algorithm>
#include <functional>

#include "flownav/cli/number_text.h"
#include "flownav/core/version.h"
#include "flownav/report/cause_style.h"
#include "flownav/report/data_uri.h"
#include "flownav/report/html.h"
#include "flownav/report/label_style.h"
#include "flownav/report/page.h"
#include "flownav/report/page_assets.h"
#include "report_data.h"
#include "report_series.h"
#include "report_tables.h"

namespace flownav::report {

namespace {

constexpr auto mostly_without_motion =
    "The motion is not known for most of the drive: the table of statuses below says why.";
constexpr auto mostly_without_speed =
    "The speed was not measured in most cycles, so way and distances are not to be trusted: the floor near "
    "the "
    "robot shows too little texture, or the robot hardly moved.";

std::string box(bool good, const std::string& text) {
    return std::string("<p class='") + (good ? "good" : "bad") + "'>" + html::escaped(text) + "</p>\n";
}

std::string short_facts(const evaluation::Drive& drive) {
    if (drive.rows.empty()) return html::paragraph("No field could be used, so there is nothing to show.");
    const double duration_s = drive.rows.back().timestamp_s - drive.rows.front().timestamp_s;
    const std::uint64_t ok = evaluation::status_counts(drive.rows).front();
    const double ok_percent = 100.0 * static_cast<double>(ok) / static_cast<double>(drive.rows.size());
    const auto cycles = [&drive](bool evaluation::FieldRow::*member) {
        return std::count_if(drive.rows.begin(), drive.rows.end(), std::mem_fn(member));
    };
    const auto finished = cycles(&evaluation::FieldRow::end_of_cycle);
    const auto with_speed = cycles(&evaluation::FieldRow::v_measured);
    std::string html = html::paragraph(
        std::to_string(drive.rows.size()) + " fields over " + cli::fixed_text(duration_s, 2) +
        " s; the turn rate was measured in " + cli::fixed_text(ok_percent, 1) + " % of them, the speed in " +
        std::to_string(with_speed) + " of " + std::to_string(finished) + " finished cycles, which gave " +
        std::to_string(drive.written.obstacle_points) + " obstacle points.");
    if (ok_percent < 50.0) html += box(false, mostly_without_motion);
    if (2 * with_speed < finished) html += box(false, mostly_without_speed);
    return html;
}

std::string beginning(const evaluation::Drive& drive) {
    std::string html =
        box(std::string(evaluation::end_word(drive)) == "clean", evaluation::end_sentence(drive));
    for (const evaluation::Finding& finding : drive.findings) html += box(false, finding.sentence);
    return html + short_facts(drive);
}

/// The pictures, which the script makes to follow the cursor.
std::string strip(const ThumbnailStrip& thumbnail_strip, double start_s) {
    std::string html = "<div id='strip' tabindex='0'>\n";
    for (const ThumbnailStrip::Picture& picture : thumbnail_strip.pictures()) {
        const std::string time_s = cli::fixed_text(picture.timestamp_s - start_s, 2);
        html += "<figure><img alt='annotated field at ";
        html += time_s;
        html += " s' src='";
        html += data_uri("image/jpeg", picture.jpeg);
        html += "'><figcaption>";
        html += time_s;
        html += " s</figcaption></figure>\n";
    }
    return html + "</div>\n";
}

const char* meaning_of(BlockLabel label) {
    switch (label) {
        case BlockLabel::Unplaced:
            return "";
        case BlockLabel::Sifted:
            return "the match is ambiguous: left out";
        case BlockLabel::Eliminated:
            return "does not point away from where the robot drives to: left out";
        case BlockLabel::Ground:
            return "moves like the floor";
        case BlockLabel::Obstacle:
            return "nearer than the floor behind it, and a neighbour agrees";
        case BlockLabel::Moving:
            return "belongs to something that moves by itself";
        case BlockLabel::Unsupported:
            return "looks like an obstacle, but no neighbour agrees: left out";
        case BlockLabel::Unjudged:
            return "fits the motion, but too far or too vague to be told from floor";
    }
    return "";
}

std::string labels_legend() {
    std::string rows;
    for (auto style = label_styles().rbegin(); style != label_styles().rend(); ++style) {
        html::Cell name(style->name);
        name.mark = style->colour.css();
        rows +=
            html::row({name, {"", true}, {meaning_of(style->label)}}, std::string("label.") + style->name);
    }
    return html::table({{"block"}, {"here", true}, {"meaning"}}, rows);
}

const char* meaning_of(BeamCause cause) {
    switch (cause) {
        case BeamCause::None:
            return "";
        case BeamCause::Blocks:
            return "an obstacle point of blocks stands there";
        case BeamCause::Votes:
            return "pixels above this line do not move as the floor does";
        case BeamCause::Wall:
            return "a surface without edges reaches from above the horizon down to here";
        case BeamCause::Drop:
            return "the floor ends: what is seen there lies below it";
    }
    return "";
}

std::string strips_legend() {
    const auto line = [](const char* name, const std::string& colour, const char* meaning) {
        html::Cell cell(name);
        cell.mark = colour;
        return html::row({cell, {"", true}, {meaning}}, std::string("strip.") + name);
    };
    std::string rows = line("floor", confirmed_floor.css(), "tinted: confirmed as floor");
    for (const CauseStyle& style : cause_styles())
        rows += line(style.name, style.colour.css(), meaning_of(style.cause));
    rows += line("unknown", palette::grey.css(), "neither floor nor contact was told");
    return html::table({{"strip"}, {"here", true}, {"meaning"}}, rows);
}

std::string panel(const ThumbnailStrip& thumbnail_strip, double start_s) {
    return "<aside id='panel'>\n<div id='follow'><p id='readout'></p>\n<img id='large' alt=''></div>\n" +
           strip(thumbnail_strip, start_s) + labels_legend() + strips_legend() +
           "<p class='help'>Arrows are the vectors of the running cycle, from its first field to this one; "
           "they "
           "end where the block is now. Fields of half the lines are shown at their true height.</p>\n"
           "<p class='help keys'>Point at any chart, at the way or at the map: all show that moment. A click "
           "pins "
           "it, a second click or Esc frees it. Arrow keys step from picture to picture, with Shift from "
           "field to "
           "field. Drag in a chart over time to zoom, double-click to see all again.</p>\n</aside>\n";
}

/// Places that the script fills.
std::string curves(const evaluation::Drive& drive) {
    std::string html =
        "<div id='curves'>\n<section>\n<h2>Way and map</h2>\n"
        "<figure class='plan'><canvas id='way'></canvas><figcaption>The way seen from above. Circle: "
        "start; square: end; the arrow head is the robot at the moment shown.</figcaption></figure>\n"
        "<figure class='plan'><canvas id='map'></canvas><figcaption>Map of the drive. White: floor "
        "seen to be free; black: occupied; grey: not known. Orange dots: obstacle points of the "
        "picture shown; lines: its contacts, in the colours of their "
        "causes.</figcaption></figure>\n</section>\n"
        "<section>\n<h2>Over time</h2>\n<div id='charts'></div>\n</section>\n"
        "<section id='timing'>\n<h2>Time per stage</h2>\n<div id='times'></div>\n<p class='help'>";
    html +=
        "How long the computer took differs from run to run, and this page does not: it holds times only "
        "when flownav-replay was asked for them with --timing. Otherwise choose the summary.json that lies "
        "beside this page, or drop it here: <input type='file' id='summary' accept='.json'></p>\n"
        "</section>\n</div>\n";
    return drive.rows.empty() ? "" : html;
}

}  // namespace

std::string report_html(const evaluation::Drive& drive, const ThumbnailStrip& thumbnail_strip,
                        const mrpt::maps::COccupancyGridMap2D& map, const config::Config& config,
                        const evaluation::Timing* timing) {
    Page page;
    page.title = "Replay of " + drive.input_name;
    page.body = beginning(drive);
    if (!drive.rows.empty()) {
        page.body +=
            "<noscript><p class='bad'>The charts need JavaScript, which is switched off here; pictures and "
            "tables show without.</p></noscript>\n<main>\n" +
            curves(drive) + panel(thumbnail_strip, drive.rows.front().timestamp_s) + "</main>\n";
        page.data = report_data(drive, thumbnail_strip, map, timing);
        page.script = report_script;
    }
    page.body += report_tables(drive, config);
    page.footer = std::string("flownav-replay ") + version() +
                  ". Every file and figure: share/doc/outputs.md of flownav.";
    return page_html(page);
}

}  // namespace flownav::report
