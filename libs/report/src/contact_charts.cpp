#include "contact_charts.h"

#include <algorithm>

#include "flownav/report/cause_style.h"

namespace flownav::report {

namespace {

bool is_scan(const evaluation::FieldRow& row) {
    return row.contacts.is_new;
}

/// A gap where the value is not of an open gate.
template <typename Value>
ReportSeries series_of_scans(const char* name, const Colour& colour, const ChartRows& shown,
                             const Value& value) {
    ReportSeries series = {name, colour, false, 1.4, false, {}};
    for (const evaluation::FieldRow* row : shown)
        series.values.push_back(row->contacts.is_scanned() ? value(row->contacts) : ReportSeries::gap);
    return series;
}

ReportChart strips_chart(const evaluation::Drive& drive) {
    ChartRows shown;
    ReportChart chart = chart_of_rows(drive, shown, is_scan);
    chart.id = "contacts";
    chart.title = "Strips of the contact scan";
    chart.quantity = "strips";
    chart.note =
        "Stacked, once a cycle. A strip ends at a contact, is free as far as its floor was confirmed, or is "
        "unknown. Gaps: the gate was closed.";
    chart.stacked = true;
    chart.decimals = 0;
    chart.series.push_back(series_of_scans("unknown", palette::grey, shown,
                                           [](const auto& contacts) { return contacts.strips.unknown; }));
    chart.series.push_back(series_of_scans("free", confirmed_floor, shown,
                                           [](const auto& contacts) { return contacts.strips.free; }));
    for (const CauseStyle& style : cause_styles()) {
        if (style.cause == BeamCause::Blocks) continue;
        chart.series.push_back(series_of_scans(style.name, style.colour, shown, [&](const auto& contacts) {
            return contacts.strips.by_cause.at(static_cast<std::size_t>(style.cause));
        }));
    }
    return chart;
}

ReportChart floor_chart(const evaluation::Drive& drive) {
    ChartRows shown;
    ReportChart chart = chart_of_rows(drive, shown, is_scan);
    chart.id = "floor";
    chart.title = "Fit of the floor";
    chart.quantity = "share";
    chart.note =
        "Share of the informative pixels of the near floor that move as a floor does, and the learnt "
        "fall-off "
        "of brightness towards the corners.";
    chart.least_span = 0.5;
    chart.series.push_back(series_of_scans("floor that fits", palette::green, shown,
                                           [](const auto& contacts) { return contacts.fit_share; }));
    chart.series.push_back(series_of_scans("vignetting", palette::purple, shown,
                                           [](const auto& contacts) { return contacts.vignetting; }));
    return chart;
}

}  // namespace

ReportChart chart_of_rows(const evaluation::Drive& drive, ChartRows& shown,
                          bool (*is_shown)(const evaluation::FieldRow&)) {
    ReportChart chart;
    chart.from_zero = true;
    for (const evaluation::FieldRow& row : drive.rows) {
        const bool is_border = &row == &drive.rows.front() || &row == &drive.rows.back();
        if (!is_shown(row) && !is_border) continue;
        chart.t_s.push_back(row.timestamp_s - drive.rows.front().timestamp_s);
        shown.push_back(&row);
    }
    return chart;
}

std::vector<ReportChart> contact_charts(const evaluation::Drive& drive) {
    if (std::none_of(drive.rows.begin(), drive.rows.end(), is_scan)) return {};
    return {strips_chart(drive), floor_chart(drive)};
}

}  // namespace flownav::report
