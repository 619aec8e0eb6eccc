// BARN's worlds from the optional test data.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "flownav/sim/sdf_world.h"

namespace flownav::sim {
namespace {

namespace fs = std::filesystem;

/// The folder of the optional test data.
fs::path data_folder() {
    const char* given = std::getenv("FLOWNAV_DATA");
    return given != nullptr ? given : FLOWNAV_DATA_DIR;
}

/// Unpacks BARN's worlds for the lifetime of the object.
class UnpackedWorlds {
  public:
    explicit UnpackedWorlds(const fs::path& archive)
        : folder_(fs::path(::testing::TempDir()) / ("barn_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
        const std::string command = "tar -xJf '" + archive.string() + "' -C '" + folder_.string() + "'";
        unpacked_ = std::system(command.c_str()) == 0;
    }
    ~UnpackedWorlds() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    UnpackedWorlds(const UnpackedWorlds&) = delete;
    UnpackedWorlds& operator=(const UnpackedWorlds&) = delete;

    bool unpacked() const { return unpacked_; }
    std::vector<fs::path> files() const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder_ / "BARN"))
            if (entry.path().extension() == ".world") files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        return files;
    }
    fs::path file(int number) const {
        return folder_ / "BARN" / ("world_" + std::to_string(number) + ".world");
    }

  private:
    fs::path folder_;
    bool unpacked_ = false;
};

/// Positions of the posts in one of BARN's files, read line by line: the pose is two lines below the name of
/// each model. The state at the end repeats the names.
std::vector<Eigen::Vector2d> posts_by_text(const fs::path& file) {
    std::vector<Eigen::Vector2d> posts_m;
    std::ifstream stream(file);
    int lines_to_pose = 0;
    for (std::string line; std::getline(stream, line) && line.find("<state ") == std::string::npos;) {
        if (line.find("<model name='unit_cylinder") != std::string::npos) {
            lines_to_pose = 2;
        } else if (lines_to_pose > 0 && --lines_to_pose == 0) {
            std::istringstream numbers(line.substr(line.find("''>") + 3));
            Eigen::Vector2d at_m;
            numbers >> at_m.x() >> at_m.y();
            posts_m.push_back(at_m);
        }
    }
    return posts_m;
}

TEST(BarnWorlds, AreReadWithAllTheirPosts) {
    const fs::path archive = data_folder() / "barn" / "worlds.tar.xz";
    if (!fs::exists(archive)) {
        GTEST_SKIP() << "no " << archive << "; set FLOWNAV_DATA to the folder with BARN's worlds";
    }
    const UnpackedWorlds barn(archive);
    ASSERT_TRUE(barn.unpacked());
    EXPECT_EQ(read_sdf_world(barn.file(1)).world.solids.size(), 237U);
    EXPECT_EQ(read_sdf_world(barn.file(250)).world.solids.size(), 365U);
    const std::vector<fs::path> files = barn.files();
    ASSERT_EQ(files.size(), 250U);
    for (std::size_t k = 0; k < files.size(); k += 25) {  // reading one takes half a second
        const fs::path& file = files[k];
        const std::vector<Eigen::Vector2d> posts_m = posts_by_text(file);
        const std::vector<Solid> solids = read_sdf_world(file).world.solids;
        ASSERT_EQ(solids.size(), posts_m.size()) << file;
        for (std::size_t i = 0; i < solids.size(); ++i) {
            const Eigen::Vector2d at_m = solids[i].T_world_solid.translation().head<2>();
            ASSERT_LT((at_m - posts_m[i]).norm(), 1e-9) << file << ", post " << i;
            ASSERT_EQ(std::get<Cylinder>(solids[i].shape).radius_m, 0.075) << file << ", post " << i;
        }
    }
}

}  // namespace
}  // namespace flownav::sim
