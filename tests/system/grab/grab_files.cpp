#include "grab_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace flownav::testing {

namespace fs = std::filesystem;

Contents contents_of(const fs::path& rawlog) {
    Contents contents;
    try {
        io::RawlogReader reader(rawlog);
        while (const auto observation = reader.next()) {
            contents.sightings.emplace_back(observation->sensorLabel,
                                            observation->timestamp.time_since_epoch().count());
        }
        contents.end = reader.end();
    } catch (const io::InputError& error) {
        contents.end.kind = io::ReadEnd::Kind::Corrupt;
        contents.end.message = error.what();
    }
    return contents;
}

std::vector<Sighting> journal_of(const fs::path& journal) {
    std::vector<Sighting> sightings;
    std::ifstream stream(journal);
    Sighting sighting;
    while (stream >> sighting.first >> sighting.second) sightings.push_back(sighting);
    return sightings;
}

std::vector<fs::path> parts_of(const fs::path& rawlog) {
    std::vector<fs::path> parts;
    for (int i = 0;; ++i) {
        std::string number = std::to_string(i);
        number.insert(0, 3 - number.size(), '0');
        const fs::path part =
            i == 0 ? rawlog : rawlog.parent_path() / (rawlog.stem().string() + '_' + number + ".rawlog");
        if (!fs::exists(part)) return parts;
        parts.push_back(part);
    }
}

std::vector<Sighting> missing(std::vector<Sighting> all, std::vector<Sighting> some) {
    std::sort(all.begin(), all.end());
    std::sort(some.begin(), some.end());
    std::vector<Sighting> lacking;
    std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(lacking));
    return lacking;
}

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

std::string two_sensors(const fs::path& journal) {
    return "[FAST]\ndriver = CTestSensor\nprocess_rate = 100\njournal = " + journal.string() +
           "\n[CAMERA]\ndriver = CTestSensor\nprocess_rate = 25\nimage = true\njournal = " +
           journal.string() + "\n";
}

fs::path grab_folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    fs::path folder = fs::path(::testing::TempDir()) / "grab" / test->test_suite_name() / test->name();
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

}  // namespace flownav::testing
