#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <string>

#include "flownav/core/contact_scan.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/field_status.h"
#include "flownav/core/flow_vector.h"
#include "flownav/core/sensor_agreement.h"
#include "flownav/core/version.h"

namespace flownav {
namespace {

template <typename Word>
void expect_words_to_differ(Word last) {
    std::set<std::string> words;
    for (int i = 0; i <= static_cast<int>(last); ++i) words.insert(to_string(static_cast<Word>(i)));
    EXPECT_EQ(words.size(), static_cast<std::size_t>(last) + 1);
    EXPECT_EQ(words.count("unknown"), 0U);
}

TEST(Words, EveryStatusHasItsOwn) {
    std::set<std::string> words;
    for (const FieldStatus status : all_field_statuses) words.insert(to_string(status));
    EXPECT_EQ(words, (std::set<std::string>{"ok", "waiting", "lost", "no_texture", "bad_field"}));
}

TEST(Words, EveryFateHasItsOwn) {
    expect_words_to_differ(BlockLabel::Unjudged);
}

TEST(Words, EveryKindOfABeamHasItsOwn) {
    EXPECT_STREQ(to_string(BeamKind::Unknown), "unknown");
    EXPECT_STREQ(to_string(BeamKind::Free), "free");
    EXPECT_STREQ(to_string(BeamKind::Obstacle), "obstacle");
}

TEST(Words, EveryCauseGateAndSourceHasItsOwn) {
    expect_words_to_differ(BeamCause::Drop);
    expect_words_to_differ(ContactGate::PoorFloor);
    expect_words_to_differ(MotionSource::Gyro);
}

TEST(Words, EveryAgreementHasItsOwn) {
    std::set<std::string> words;
    for (const SensorAgreement agreement : all_sensor_agreements) words.insert(to_string(agreement));
    EXPECT_EQ(words,
              (std::set<std::string>{"no_readings", "unchecked", "agrees", "contradicts", "not_in_time"}));
}

TEST(Version, HasThreeNumbers) {
    int major = -1, minor = -1, patch = -1;
    EXPECT_EQ(std::sscanf(version(), "%d.%d.%d", &major, &minor, &patch), 3);
}

}  // namespace
}  // namespace flownav
