#include "flownav/nav/sensor_watch.h"

#include <gtest/gtest.h>

namespace flownav::nav {
namespace {

using Counts = std::array<int, SensorReport::sectors>;

constexpr double field_s = 0.02;
constexpr Counts all_blocks = {100, 100, 100, 100};
constexpr Counts clear_view = {60, 60, 60, 60};

SensorReport report_at(double time_s, FieldStatus status = FieldStatus::Ok,
                       const Counts& confident = clear_view) {
    SensorReport report;
    report.timestamp_s = time_s;
    report.status = status;
    report.blocks = all_blocks;
    report.confident = confident;
    return report;
}

/// A watch and a clock. Fields come at 50 Hz, and each is followed by a query.
struct Stream {
    SensorWatch watch{SensorWatchParams()};
    double time_s = 0.0;

    /// Feeds fields for `seconds` and returns the fault after the last one.
    Fault feed(double seconds, FieldStatus status = FieldStatus::Ok, const Counts& confident = clear_view) {
        Fault fault;
        for (const double end_s = time_s + seconds; time_s < end_s - field_s / 2;) {
            time_s += field_s;
            watch.sensed(report_at(time_s, status, confident));
            fault = watch.fault(time_s);
        }
        return fault;
    }
    /// Advances by `seconds` without a field.
    Fault wait(double seconds) { return watch.fault(time_s += seconds); }
};

TEST(SensorWatch, SaysStaleBeforeTheFirstField) {
    SensorWatch watch{SensorWatchParams()};
    EXPECT_EQ(watch.fault(0.0).reason, GuardReason::SensorStale);
    EXPECT_FALSE(watch.fault(0.0).why.empty());
}

TEST(SensorWatch, SaysNothingWhileFieldsComeWithAClearView) {
    Stream stream;
    EXPECT_FALSE(stream.feed(1.0));
    EXPECT_FALSE(stream.watch.is_partly_blind());
}

TEST(SensorWatch, SaysStaleWhenNoFieldCameForLongerThanTheLimit) {
    Stream stream;
    stream.feed(1.0);
    EXPECT_FALSE(stream.wait(0.24));
    EXPECT_EQ(stream.wait(0.02).reason, GuardReason::SensorStale);
    EXPECT_FALSE(stream.feed(field_s)) << "the next field ends it";
}

TEST(SensorWatch, SaysStaleWhenFieldsComeWithOldTimeStamps) {
    SensorWatch watch{SensorWatchParams()};
    watch.sensed(report_at(10.0));
    EXPECT_FALSE(watch.fault(10.2));
    watch.sensed(report_at(10.02));
    EXPECT_EQ(watch.fault(10.3).reason, GuardReason::SensorStale);
}

TEST(SensorWatch, AnOlderFieldThatComesLaterIsNoNews) {
    Stream stream;
    stream.feed(1.0);
    stream.watch.sensed(report_at(stream.time_s - 0.3, FieldStatus::BadField));
    EXPECT_FALSE(stream.wait(0.0));
}

TEST(SensorWatch, WhereTimeStampsAreAheadTheArrivalCounts) {
    SensorWatch watch{SensorWatchParams()};
    watch.sensed(report_at(10.08));
    EXPECT_FALSE(watch.fault(10.0));
    EXPECT_FALSE(watch.fault(10.24));
    EXPECT_EQ(watch.fault(10.26).reason, GuardReason::SensorStale);
}

TEST(SensorWatch, TimeStampsMayBeSoFarInTheFutureAndNoFarther) {
    for (const double ahead_s : {0.05, 0.15}) {
        SensorWatch watch{SensorWatchParams()};
        watch.sensed(report_at(10.0 + ahead_s));
        const Fault fault = watch.fault(10.0);
        EXPECT_EQ(fault.reason, ahead_s > 0.1 ? GuardReason::SensorStale : GuardReason::None) << fault.why;
    }
}

TEST(SensorWatch, SaysBlindWhenNoFieldHadAPictureForLongerThanTheLimit) {
    for (const FieldStatus status : {FieldStatus::BadField, FieldStatus::NoTexture}) {
        Stream stream;
        stream.feed(1.0);
        EXPECT_FALSE(stream.feed(0.18, status)) << to_string(status);
        EXPECT_EQ(stream.feed(0.04, status).reason, GuardReason::SensorBlind) << to_string(status);
        EXPECT_FALSE(stream.watch.is_partly_blind());
        EXPECT_FALSE(stream.feed(field_s)) << "the next picture ends it";
    }
}

TEST(SensorWatch, FewerVectorsThanTheLeastAreNoPicture) {
    for (const int vectors : {19, 20}) {
        Stream stream;
        stream.feed(1.0);
        const Fault fault = stream.feed(0.3, FieldStatus::Ok, {vectors - 15, 5, 5, 5});
        EXPECT_EQ(fault.reason, vectors < 20 ? GuardReason::SensorBlind : GuardReason::None) << fault.why;
    }
}

TEST(SensorWatch, SaysLostWhenTheVectorsHaveNoCommonMotionForLongerThanTheLimit) {
    Stream stream;
    stream.feed(1.0);
    EXPECT_FALSE(stream.feed(0.18, FieldStatus::Lost));
    EXPECT_EQ(stream.feed(0.04, FieldStatus::Lost).reason, GuardReason::OmegaLost);
    EXPECT_EQ(stream.feed(2.0, FieldStatus::Lost).reason, GuardReason::OmegaLost) << "vectors are a picture";
    EXPECT_FALSE(stream.feed(field_s));
}

TEST(SensorWatch, ASensorThatStartsAnewIsBlindOnlyAfterTheLongerLimit) {
    Stream stream;
    stream.feed(1.0);
    EXPECT_NE(stream.feed(0.58, FieldStatus::Waiting).reason, GuardReason::SensorBlind);
    EXPECT_EQ(stream.feed(0.06, FieldStatus::Waiting).reason, GuardReason::SensorBlind);
}

TEST(SensorWatch, AStandingCameraIsNotBlind) {
    Stream stream;
    SensorReport still = report_at(0.0);
    still.omega_radps = still.v_mps = 0.0;
    still.repeated = true;
    for (int i = 0; i < 50; ++i) {
        still.timestamp_s += field_s;
        stream.watch.sensed(still);
        EXPECT_FALSE(stream.watch.fault(still.timestamp_s));
    }
}

TEST(SensorWatch, ASectorIsBlindWhenItShowsTooLittleForLongerThanTheLimit) {
    for (int sector = 0; sector < SensorReport::sectors; ++sector) {
        Counts covered = clear_view;
        covered.at(static_cast<std::size_t>(sector)) = 4;  // of 100 blocks; 5 are enough
        Stream stream;
        stream.feed(1.0);
        EXPECT_FALSE(stream.feed(0.1, FieldStatus::Ok, covered));
        const Fault fault = stream.feed(0.04, FieldStatus::Ok, covered);
        EXPECT_EQ(fault.reason, GuardReason::SensorBlind);
        EXPECT_TRUE(stream.watch.is_partly_blind());
        EXPECT_NE(fault.why.find("part " + std::to_string(sector + 1) + " of 4"), std::string::npos)
            << fault.why;
        EXPECT_FALSE(stream.feed(field_s)) << "one clear field ends it";
        EXPECT_FALSE(stream.watch.is_partly_blind());
    }
}

/// Fault after a second of reports that `change` made of a right sector without vectors, while scans run.
template <class Change>
Fault fault_of(const Change& change) {
    SensorWatch watch{SensorWatchParams()};
    Fault fault;
    for (int i = 0; i < 50; ++i) {
        SensorReport report = report_at(i * field_s, FieldStatus::Ok, {60, 60, 60, 0});
        report.scans = report.sees_edges = true;
        change(report);
        watch.sensed(report);
        fault = watch.fault(i * field_s);
    }
    return fault;
}

TEST(SensorWatch, ASectorWithoutVectorsIsBlindOnlyWhenItIsBlackOrNoScansSeePlainThings) {
    EXPECT_FALSE(fault_of([](SensorReport&) {})) << "a blank wall";
    EXPECT_EQ(fault_of([](SensorReport& r) { r.unlit[3] = true; }).reason, GuardReason::SensorBlind);
    EXPECT_FALSE(fault_of([](SensorReport& r) { r.unlit[0] = true; })) << "it has vectors";
    EXPECT_EQ(fault_of([](SensorReport& r) { r.scans = false; }).reason, GuardReason::SensorBlind);
}

TEST(SensorWatch, OnAPlainFloorTheMotionThatWheelsTellIsEnoughWhileScansSeeEdges) {
    const auto plain = [](SensorReport& r) {
        r.status = FieldStatus::NoTexture;
        r.confident = {};
    };
    EXPECT_FALSE(fault_of(plain));
    EXPECT_EQ(fault_of([&](SensorReport& r) {
                  plain(r);
                  r.carried_s = 0.04;
              }).reason,
              GuardReason::SensorBlind)
        << "nobody tells the motion";
    EXPECT_EQ(fault_of([&](SensorReport& r) {
                  plain(r);
                  r.sees_edges = false;
              }).reason,
              GuardReason::SensorBlind)
        << "a cloth over the lens";
}

TEST(SensorWatch, ASectorWithJustEnoughVectorsIsNotBlind) {
    Stream stream;
    EXPECT_FALSE(stream.feed(1.0, FieldStatus::Ok, {5, 60, 60, 60}));
}

TEST(SensorWatch, ASectorWithoutBlocksIsNotBlind) {
    SensorWatch watch{SensorWatchParams()};
    for (int i = 1; i < 50; ++i) {
        const double time_s = i * field_s;
        SensorReport report = report_at(time_s, FieldStatus::Ok, {0, 60, 60, 60});
        report.blocks[0] = 0;
        watch.sensed(report);
        EXPECT_FALSE(watch.fault(time_s));
    }
}

TEST(SensorWatch, AFlickeringSectorIsNotBlind) {
    Stream stream;
    for (int i = 0; i < 10; ++i) {
        EXPECT_FALSE(stream.feed(0.08, FieldStatus::Ok, {60, 60, 60, 0}));
        EXPECT_FALSE(stream.feed(field_s));
    }
}

TEST(SensorWatch, AStaleSensorIsNotPartlyBlind) {
    Stream stream;
    stream.feed(1.0, FieldStatus::Ok, {60, 0, 60, 60});
    EXPECT_TRUE(stream.watch.is_partly_blind());
    EXPECT_EQ(stream.wait(0.3).reason, GuardReason::SensorStale);
    EXPECT_FALSE(stream.watch.is_partly_blind());
}

TEST(SensorWatch, SaysNothingOfASensorThatStartsAnewWithinTheLongerLimit) {
    Stream stream;
    stream.feed(1.0);
    for (int field = 0; field < 29; ++field) {
        const Fault fault = stream.feed(field_s, FieldStatus::Waiting);
        EXPECT_FALSE(fault) << stream.time_s - 1.0 << " s: " << to_string(fault.reason) << ", " << fault.why;
    }
}

TEST(SensorWatch, OneTimeStampFarInTheFutureDoesNotSilenceThoseAfterIt) {
    Stream stream;
    stream.feed(1.0);
    stream.watch.sensed(report_at(stream.time_s + 1000.0));
    stream.watch.fault(stream.time_s);
    EXPECT_FALSE(stream.feed(1.0));
}

}  // namespace
}  // namespace flownav::nav
