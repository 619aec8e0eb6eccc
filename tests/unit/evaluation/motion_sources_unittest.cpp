#include "flownav/evaluation/motion_sources.h"

#include <gtest/gtest.h>

namespace flownav::evaluation {
namespace {

/// Ten fields a second; the wheels contradict the flow from field `from` on.
std::vector<FieldRow> rows_with_contradiction(int from) {
    std::vector<FieldRow> rows(20);
    for (int i = 0; i < 20; ++i) {
        FieldRow& row = rows[static_cast<std::size_t>(i)];
        row.timestamp_s = 0.1 * i;
        row.omega_source = MotionSource::Flow;
        row.forward_source = i < 5 ? MotionSource::Wheels : MotionSource::Flow;
        const bool wrong = i >= from;
        row.other_sensors.wheels_way = {wrong ? SensorAgreement::Contradicts : SensorAgreement::Agrees,
                                        wrong ? -1.0 : 1.0};
    }
    return rows;
}

TEST(MotionSources, CountsFieldsBySourceAndTheTimeOfAContradiction) {
    const MotionSources sources = motion_sources(rows_with_contradiction(10));
    EXPECT_EQ(sources.turn, (SourceCounts{0, 20, 0, 0}));
    EXPECT_EQ(sources.way, (SourceCounts{0, 15, 5, 0}));
    EXPECT_NEAR(sources.wheels_way.contradicted_s, 1.0, 1e-9);
    EXPECT_EQ(sources.wheels_way.last.agreement, SensorAgreement::Contradicts);
    EXPECT_EQ(sources.gyro.last.agreement, SensorAgreement::NoReadings);
}

TEST(MotionSources, AContradictionIsASentenceWithTimeRatioAndKey) {
    const auto findings = sensor_findings(rows_with_contradiction(10));
    ASSERT_EQ(findings.size(), 1U);
    for (const char* part : {"the way of the wheels", "1.0 s", "-1.00", "motion.wheels = off"})
        EXPECT_NE(findings[0].sentence.find(part), std::string::npos)
            << part << " in: " << findings[0].sentence;
}

TEST(MotionSources, ReadingsOfAnotherClockAreASentence) {
    std::vector<FieldRow> rows = rows_with_contradiction(20);
    for (FieldRow& row : rows) row.other_sensors.gyro.agreement = SensorAgreement::NotInTime;
    const auto findings = sensor_findings(rows);
    ASSERT_EQ(findings.size(), 1U);
    for (const char* part : {"the gyro", "1.9 s", "one clock", "motion.gyro = off"})
        EXPECT_NE(findings[0].sentence.find(part), std::string::npos)
            << part << " in: " << findings[0].sentence;
}

TEST(MotionSources, SensorsThatAgreeAreNoSentence) {
    EXPECT_TRUE(sensor_findings(rows_with_contradiction(20)).empty());
    EXPECT_TRUE(sensor_findings({}).empty());
}

}  // namespace
}  // namespace flownav::evaluation
