#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <string>

#include "flownav/core/field_status.h"
#include "flownav/core/flow_vector.h"
#include "flownav/core/version.h"

namespace flownav {
namespace {

TEST(Words, EveryStatusHasItsOwn) {
    std::set<std::string> words;
    for (const FieldStatus status : all_field_statuses) words.insert(to_string(status));
    EXPECT_EQ(words, (std::set<std::string>{"ok", "waiting", "lost", "no_texture", "bad_field"}));
}

TEST(Words, EveryFateHasItsOwn) {
    std::set<std::string> words;
    for (int i = 0; i <= static_cast<int>(BlockLabel::Unjudged); ++i)
        words.insert(to_string(static_cast<BlockLabel>(i)));
    EXPECT_EQ(words.size(), 8U);
    EXPECT_EQ(words.count("unknown"), 0U);
}

TEST(Version, HasThreeNumbers) {
    int major = -1, minor = -1, patch = -1;
    EXPECT_EQ(std::sscanf(version(), "%d.%d.%d", &major, &minor, &patch), 3);
}

}  // namespace
}  // namespace flownav
