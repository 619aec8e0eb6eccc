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

}  // namespace
}  // namespace flownav
