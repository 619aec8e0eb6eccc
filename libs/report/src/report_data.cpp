#include "report_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "flownav/evaluation/summary_facts.h"
#include "flownav/report/cause_style.h"
#include "flownav/report/data_uri.h"
#include "flownav/report/label_style.h"
#include "flownav/report/map_picture.h"
#include "report_series.h"

namespace flownav::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_times = 5000;

/// As short as it may be; null when it is no number.
Json rounded(double value, int decimals) {
    if (!std::isfinite(value)) return nullptr;
    const double power = std::pow(10.0, decimals);
    const double result = std::round(value * power) / power + 0.0;  // + 0.0 turns -0 into 0
    if (result == std::floor(result) && std::abs(result) < 1e9) return static_cast<std::int64_t>(result);
    return result;
}

template <typename Values>
Json rounded_all(const Values& values, int decimals) {
    Json array = Json::array();
    for (const double value : values) array.push_back(rounded(value, decimals));
    return array;
}

Json series_json(const ReportSeries& series, int decimals) {
    Json values = Json::array();
    for (const double value : series.values)
        values.push_back(value == ReportSeries::gap ? Json(false) : rounded(value, decimals));
    return {{"name", series.name},      {"colour", series.colour.css()}, {"dashed", series.dashed},
            {"width", series.width_px}, {"connected", series.connected}, {"values", std::move(values)}};
}

Json chart_json(const ReportChart& chart) {
    Json series = Json::array();
    for (const ReportSeries& one : chart.series) series.push_back(series_json(one, chart.decimals));
    return {{"id", chart.id},
            {"title", chart.title},
            {"quantity", chart.quantity},
            {"unit", chart.unit},
            {"note", chart.note},
            {"stacked", chart.stacked},
            {"fromZero", chart.from_zero},
            {"leastSpan", chart.least_span},
            {"t", rounded_all(chart.t_s, 3)},
            {"series", std::move(series)}};
}

Json charts_json(const evaluation::Drive& drive) {
    Json charts = Json::array();
    for (ReportChart& chart : report_charts(drive))
        charts.push_back(chart_json(thinned(std::move(chart), most_times)));
    return charts;
}

/// The ways seen from above; every k-th pose, and the last.
Json tracks_json(const evaluation::Drive& drive) {
    const std::size_t fields = drive.rows.size();
    const std::size_t step = fields / most_times + 1;
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < fields; i += step) chosen.push_back(i);
    if (!chosen.empty() && chosen.back() + 1 != fields) chosen.push_back(fields - 1);
    Json tracks = Json::array();
    for (const ReportTrack& track : report_tracks(drive)) {
        Json t = Json::array(), x = Json::array(), y = Json::array(), heading = Json::array();
        for (const std::size_t i : chosen) {
            const Pose2& pose = track.poses[i];
            t.push_back(rounded(drive.rows[i].timestamp_s - drive.rows.front().timestamp_s, 3));
            x.push_back(rounded(pose.x_m, 4));
            y.push_back(rounded(pose.y_m, 4));
            heading.push_back(rounded(pose.yaw_rad, 4));
        }
        tracks.push_back({{"name", track.look.name},
                          {"colour", track.look.colour.css()},
                          {"dashed", track.look.dashed},
                          {"width", track.look.width_px},
                          {"t", std::move(t)},
                          {"x", std::move(x)},
                          {"y", std::move(y)},
                          {"heading", std::move(heading)}});
    }
    return tracks;
}

/// Of the fields that share a moment of a long drive the worst is shown, lest a single bad one be lost.
int severity(FieldStatus status) {
    constexpr std::array<FieldStatus, 5> from_good_to_bad = {FieldStatus::Ok, FieldStatus::Waiting,
                                                             FieldStatus::NoTexture, FieldStatus::Lost,
                                                             FieldStatus::BadField};
    return static_cast<int>(std::find(from_good_to_bad.begin(), from_good_to_bad.end(), status) -
                            from_good_to_bad.begin());
}

std::size_t index_of(FieldStatus status) {
    return static_cast<std::size_t>(std::find(all_field_statuses.begin(), all_field_statuses.end(), status) -
                                    all_field_statuses.begin());
}

/// [from, to, index of the status] of every stretch of the same status; a field lasts until the next.
Json status_runs(const std::vector<evaluation::FieldRow>& rows) {
    Json runs = Json::array();
    const std::size_t step = rows.size() / most_times + 1;
    std::optional<FieldStatus> running;
    for (std::size_t i = 0; i < rows.size(); i += step) {
        FieldStatus worst = rows[i].status;
        for (std::size_t k = i; k < std::min(i + step, rows.size()); ++k)
            if (severity(rows[k].status) > severity(worst)) worst = rows[k].status;
        const std::size_t next = std::min(i + step, rows.size() - 1);
        const Json until = rounded(rows[next].timestamp_s - rows.front().timestamp_s, 3);
        if (running == worst) {
            runs.back()[1] = until;
        } else {
            runs.push_back(
                {rounded(rows[i].timestamp_s - rows.front().timestamp_s, 3), until, index_of(worst)});
        }
        running = worst;
    }
    return runs;
}

Json status_json(const std::vector<evaluation::FieldRow>& rows) {
    Json kinds = Json::array();
    for (const FieldStatus status : all_field_statuses)
        kinds.push_back({{"name", to_string(status)}, {"colour", colour_of(status).css()}});
    return {{"kinds", std::move(kinds)}, {"runs", status_runs(rows)}};
}

Json map_json(const evaluation::Drive& drive, const mrpt::maps::COccupancyGridMap2D& map) {
    const MapPicture picture = map_picture(map, drive.rows);
    if (picture.cells.empty()) return nullptr;
    return {{"png", png_uri(picture.cells)},     {"x", rounded(picture.left_m, 4)},
            {"y", rounded(picture.bottom_m, 4)}, {"cell", rounded(picture.cell_m, 4)},
            {"columns", picture.cells.cols},     {"rows", picture.cells.rows}};
}

/// [x, y, x, y, colour] of the ends of every contact, right end first.
Json contacts_json(const std::vector<ContactSegment>& segments) {
    Json contacts = Json::array();
    for (const ContactSegment& segment : segments) {
        contacts.push_back({rounded(segment.right_m.x(), 2), rounded(segment.right_m.y(), 2),
                            rounded(segment.left_m.x(), 2), rounded(segment.left_m.y(), 2),
                            colour_of(segment.cause).css()});
    }
    return contacts;
}

/// Strips by content, in the order of the rows of the legend.
Json strips_json(const StripCounts& strips) {
    Json counts = {strips.free};
    for (const CauseStyle& style : cause_styles())
        counts.push_back(strips.by_cause.at(static_cast<std::size_t>(style.cause)));
    counts.push_back(strips.unknown);
    return counts;
}

/// The pictures themselves stand in the page.
Json pictures_json(const ThumbnailStrip& thumbnail_strip, double start_s) {
    Json pictures = Json::array();
    for (const ThumbnailStrip::Picture& picture : thumbnail_strip.pictures()) {
        Json points = Json::array();
        for (const Eigen::Vector2d& point : picture.points_m)
            points.push_back({rounded(point.x(), 2), rounded(point.y(), 2)});
        Json labels = Json::array();
        for (const LabelStyle& style : label_styles())
            labels.push_back(picture.labels.at(static_cast<std::size_t>(style.label)));
        pictures.push_back({{"t", rounded(picture.timestamp_s - start_s, 3)},
                            {"labels", std::move(labels)},
                            {"points", std::move(points)},
                            {"strips", strips_json(picture.strips)},
                            {"contacts", contacts_json(picture.contacts)}});
    }
    return pictures;
}

}  // namespace

std::string report_data(const evaluation::Drive& drive, const ThumbnailStrip& thumbnail_strip,
                        const mrpt::maps::COccupancyGridMap2D& map, const evaluation::Timing* timing) {
    Json data;
    data["input"] = drive.input_name;
    data["charts"] = charts_json(drive);
    data["status"] = status_json(drive.rows);
    data["tracks"] = tracks_json(drive);
    data["map"] = map_json(drive, map);
    data["pictures"] = pictures_json(thumbnail_strip, drive.rows.front().timestamp_s);
    data["timing"] = timing == nullptr ? Json(nullptr) : evaluation::timing_facts(*timing);
    return data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace flownav::report
