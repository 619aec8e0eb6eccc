#include <gtest/gtest.h>

#include "drives.h"

namespace flownav {
namespace {

std::vector<Field> drive_among_things() {
    testing::DriveOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 6;
    options.omega_degps = 12.0;
    return render_fields(testing::drive(options));
}

std::string everything(const std::vector<Field>& fields, int threads) {
    pipeline::Params params = testing::cycles_of(2);
    params.threads = threads;
    std::string all;
    for (const pipeline::Step& step : testing::run(fields, params)) all += testing::fingerprint(step);
    return all;
}

TEST(Determinism, RepetitionAndThreadsChangeNotOneBit) {
    const std::vector<Field> fields = drive_among_things();
    const std::string once = everything(fields, 1);
    EXPECT_GT(once.size(), 1000U);
    EXPECT_EQ(once, everything(fields, 1));
    EXPECT_EQ(once, everything(fields, 2));
}

TEST(Determinism, AStateThatIsMovedGoesOn) {
    std::vector<Field> fields = drive_among_things();
    fields.resize(4);
    pipeline::State first(testing::cycles_of(4));
    pipeline::step(first, fields[0]);
    pipeline::step(first, fields[1]);
    pipeline::State second(std::move(first));
    pipeline::step(second, fields[2]);
    const auto plain = testing::run(fields, testing::cycles_of(4));
    EXPECT_EQ(testing::fingerprint(pipeline::step(second, fields[3])), testing::fingerprint(plain[3]));
}

TEST(Determinism, ACloneGoesOnByItself) {
    const std::vector<Field> fields = drive_among_things();
    const auto plain = testing::run(fields, testing::cycles_of(2));
    for (std::size_t at = 0; at < fields.size(); ++at) {
        pipeline::State first(testing::cycles_of(2));
        for (std::size_t i = 0; i < at; ++i) pipeline::step(first, fields[i]);
        pipeline::State second = first.clone();
        EXPECT_EQ(testing::fingerprint(second.last_step()), testing::fingerprint(first.last_step()));
        pipeline::step(first, testing::grey_field(fields[at], 0, 0.0));
        for (std::size_t i = at; i < fields.size(); ++i) {
            EXPECT_EQ(testing::fingerprint(pipeline::step(second, fields[i])), testing::fingerprint(plain[i]))
                << "cloned at " << at;
        }
    }
}

}  // namespace
}  // namespace flownav
