#include "flownav/evaluation/contact_figures.h"

#include <gtest/gtest.h>

namespace flownav::evaluation {
namespace {

/// The end of a cycle that was scanned: free, obstacle and unknown strips; all of them in view.
FieldRow scanned(int free, int votes, int unknown, double fit_share) {
    FieldRow row;
    row.end_of_cycle = true;
    row.contacts.is_new = true;
    row.contacts.gate = ContactGate::Open;
    StripCounts& strips = row.contacts.strips;
    strips.free = strips.decided = free;
    strips.obstacle = strips.by_cause.at(static_cast<std::size_t>(BeamCause::Votes)) = votes;
    strips.unknown = unknown;
    strips.in_view = free + votes + unknown;
    row.contacts.fit_share = fit_share;
    row.contacts.vignetting = fit_share / 4;
    return row;
}

FieldRow closed(ContactGate gate) {
    FieldRow row;
    row.end_of_cycle = true;
    row.contacts.is_new = true;
    row.contacts.gate = gate;
    return row;
}

TEST(ContactFigures, AreMeansOverTheScannedCycles) {
    const ContactFigures figures = contact_figures(
        {{}, scanned(10, 2, 8, 0.8), {}, scanned(20, 0, 0, 0.6), closed(ContactGate::PoorFloor)});
    EXPECT_EQ(figures.scans, 3U);
    EXPECT_EQ(figures.rows, 40U);
    EXPECT_DOUBLE_EQ(*figures.free_strips, 15.0);
    EXPECT_DOUBLE_EQ(*figures.contacts, 1.0);
    EXPECT_DOUBLE_EQ(*figures.unknown_strips, 4.0);
    EXPECT_DOUBLE_EQ(*figures.decided_percent, 75.0);
    EXPECT_DOUBLE_EQ(*figures.fit_share, 0.7);
    EXPECT_DOUBLE_EQ(*figures.vignetting, 0.15) << "the newest";
    EXPECT_EQ(figures.by_cause.at(static_cast<std::size_t>(BeamCause::Votes)), 2U);
}

TEST(ContactFigures, ShareAndReasonsTellWhyCyclesWereNotScanned) {
    const ContactFigures figures =
        contact_figures({scanned(1, 0, 0, 0.5), closed(ContactGate::NoTravel), closed(ContactGate::NoTravel),
                         closed(ContactGate::PoorFloor)});
    EXPECT_DOUBLE_EQ(*figures.scanned_percent, 25.0);
    EXPECT_EQ(figures.by_gate, (std::array<std::uint64_t, 4>{1, 0, 2, 1}));
}

TEST(ContactFigures, ADriveWithoutAScanHasNoMeans) {
    const ContactFigures figures = contact_figures({{}, closed(ContactGate::NoTravel)});
    EXPECT_FALSE(figures.contacts);
    EXPECT_FALSE(figures.decided_percent);
    EXPECT_FALSE(figures.fit_share);
    EXPECT_FALSE(figures.vignetting);
    EXPECT_DOUBLE_EQ(*figures.scanned_percent, 0.0);
    EXPECT_FALSE(contact_figures({}).scanned_percent);
}

}  // namespace
}  // namespace flownav::evaluation
