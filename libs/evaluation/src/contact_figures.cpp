#include "flownav/evaluation/contact_figures.h"

namespace flownav::evaluation {

namespace {

/// Sums over the scanned cycles.
struct Sums {
    std::uint64_t cycles = 0;
    StripCounts strips;
    double fit_share = 0.0;
};

void add(Sums& sums, const ContactRow& contacts) {
    ++sums.cycles;
    sums.strips.free += contacts.strips.free;
    sums.strips.obstacle += contacts.strips.obstacle;
    sums.strips.unknown += contacts.strips.unknown;
    sums.strips.in_view += contacts.strips.in_view;
    sums.strips.decided += contacts.strips.decided;
    for (std::size_t i = 0; i < all_beam_causes.size(); ++i)
        sums.strips.by_cause[i] += contacts.strips.by_cause[i];
    sums.fit_share += contacts.fit_share;
}

std::optional<double> ratio(double part, double whole) {
    if (whole <= 0.0) return std::nullopt;
    return part / whole;
}

std::optional<double> percent(double part, double whole) {
    return ratio(100.0 * part, whole);
}

}  // namespace

ContactFigures contact_figures(const std::vector<FieldRow>& rows) {
    ContactFigures figures;
    Sums sums;
    std::uint64_t finished = 0;
    for (const FieldRow& row : rows) {
        if (row.end_of_cycle) ++finished;
        const ContactRow& contacts = row.contacts;
        if (!contacts.is_new) continue;
        ++figures.scans;
        ++figures.by_gate.at(static_cast<std::size_t>(contacts.gate));
        if (!contacts.is_scanned()) continue;
        figures.rows += static_cast<std::uint64_t>(contacts.strips.free + contacts.strips.obstacle +
                                                   contacts.strips.unknown);
        add(sums, contacts);
        figures.vignetting = contacts.vignetting;
    }
    const auto cycles = static_cast<double>(sums.cycles);
    figures.scanned_percent = percent(cycles, static_cast<double>(finished));
    figures.free_strips = ratio(sums.strips.free, cycles);
    figures.contacts = ratio(sums.strips.obstacle, cycles);
    figures.unknown_strips = ratio(sums.strips.unknown, cycles);
    figures.decided_percent = percent(sums.strips.decided, sums.strips.in_view);
    for (std::size_t i = 0; i < all_beam_causes.size(); ++i)
        figures.by_cause[i] = static_cast<std::uint64_t>(sums.strips.by_cause[i]);
    figures.fit_share = ratio(sums.fit_share, cycles);
    return figures;
}

}  // namespace flownav::evaluation
