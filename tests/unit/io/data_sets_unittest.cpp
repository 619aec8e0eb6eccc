#include <gtest/gtest.h>

#include <cmath>

#include "flownav/io/data_set_folder.h"
#include "flownav/io/errors.h"
#include "import_samples.h"
#include "rawlog_files.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;
using namespace flownav::testing;

fs::path tum_folder() {
    const fs::path folder = test_folder();
    for (const char* name : {"1305031102.175304", "1305031102.211214", "1305031102.243211"})
        write_sample_picture(folder / "rgb" / (std::string(name) + ".png"), 1);
    write_bytes(folder / "rgb.txt",
                "# color images\n# file: 'rgbd_dataset.bag'\n# timestamp filename\n"
                "1305031102.175304 rgb/1305031102.175304.png\n1305031102.211214 rgb/1305031102.211214.png\n"
                "1305031102.243211 rgb/1305031102.243211.png\n");
    return folder;
}

fs::path euroc_folder() {
    const fs::path folder = test_folder();
    const fs::path camera = folder / "mav0" / "cam0";
    std::string list = "#timestamp [ns],filename\r\n";
    for (const char* name : {"1403636579763555584", "1403636579813555584", "1403636579863555584"}) {
        write_sample_picture(camera / "data" / (std::string(name) + ".png"), 1);
        list += std::string(name) + "," + name + ".png\r\n";
    }
    write_bytes(camera / "data.csv", list);
    return folder;
}

constexpr auto sensor_yaml =
    "# General sensor definitions.\nsensor_type: camera\ncomment: VI-Sensor cam0 (MT9M034)\n\n"
    "# Sensor extrinsics wrt. the body-frame.\nT_BS:\n  cols: 4\n  rows: 4\n"
    "  data: [0.0, -1.0, 0.0, 0.2,\n         1.0, 0.0, 0.0, 0.0,\n         0.0, 0.0, 1.0, 0.0,\n"
    "         0.0, 0.0, 0.0, 1.0]\n\n# Camera specific definitions.\nrate_hz: 20\nresolution: [64, 48]\n"
    "camera_model: pinhole\nintrinsics: [58.5, 57.5, 31, 23] #fu, fv, cu, cv\n"
    "distortion_model: radial-tangential\n"
    "distortion_coefficients: [-0.28, 0.07, 0.0002, 1.76e-05]\n";

config::CameraConfig mount_only() {
    config::CameraConfig camera;
    camera.height_m = 0.5;
    camera.pitch_deg = 0;
    return camera;
}

TEST(DataSets, AreRecognisedByTheirFiles) {
    EXPECT_EQ(data_set_kind(test_folder()), DataSetKind::None);
    EXPECT_EQ(data_set_kind(tum_folder()), DataSetKind::Tum);
    const fs::path euroc = euroc_folder();
    for (const fs::path& folder : {euroc, euroc / "mav0", euroc / "mav0" / "cam0"})
        EXPECT_EQ(data_set_kind(folder), DataSetKind::Euroc) << folder;
}

TEST(DataSets, TumHasTheTimesOfItsList) {
    DataSetFolder sequence(tum_folder(), DataSetKind::Tum, sample_camera(), std::nullopt);
    expect_times(times_of(sequence), {1305031102.175304, 1305031102.211214, 1305031102.243211});
    EXPECT_TRUE(sequence.problems().empty());
}

TEST(DataSets, TumsGroundTruthBecomesThePoseOfTheRobot) {
    const fs::path folder = tum_folder();
    // The camera looks along the world's y axis and moves along it; optical axes in the world: x, -z, y.
    write_bytes(folder / "groundtruth.txt",
                "# ground truth trajectory\n# timestamp tx ty tz qx qy qz qw\n"
                "1305031102.10 1 2.0 0.5 -0.70710678 0 0 0.70710678\n"
                "1305031102.20 1 2.1 0.5 -0.70710678 0 0 0.70710678\n"
                "1305031102.30 1 2.2 0.5 -0.70710678 0 0 0.70710678\n");
    config::CameraConfig camera = sample_camera();
    camera.pitch_deg = 0;
    DataSetFolder sequence(folder, DataSetKind::Tum, camera, std::nullopt);
    const auto first = sequence.next();
    sequence.next();
    const auto last = sequence.next();
    ASSERT_TRUE(first && last && first->T_start_robot && last->T_start_robot);
    EXPECT_NEAR(first->T_start_robot->x_m, 0, 1e-9);
    EXPECT_NEAR(last->T_start_robot->x_m, 0.067907, 1e-5);
    EXPECT_NEAR(last->T_start_robot->y_m, 0, 1e-6);
    EXPECT_NEAR(last->T_start_robot->yaw_rad, 0, 1e-6);
}

TEST(DataSets, EurocHasTheTimesOfItsListAndTheIntrinsicsOfItsSensor) {
    const fs::path folder = euroc_folder();
    write_bytes(folder / "mav0" / "cam0" / "sensor.yaml", sensor_yaml);
    DataSetFolder sequence(folder, DataSetKind::Euroc, mount_only(), std::nullopt);
    const auto frame = sequence.next();
    ASSERT_TRUE(frame);
    EXPECT_NEAR(frame->field.timestamp_s, 1403636579.763555584, 1e-6);
    EXPECT_DOUBLE_EQ(frame->field.camera.fx_px, 58.5);
    EXPECT_DOUBLE_EQ(frame->field.camera.cy_px, 23);
    EXPECT_DOUBLE_EQ(frame->field.camera.distortion[0], -0.28);
    EXPECT_TRUE(some_says(sequence.notes(), {"sensor.yaml", "intrinsics"}));
    DataSetFolder own(folder, DataSetKind::Euroc, sample_camera(), std::nullopt);
    EXPECT_DOUBLE_EQ(own.next()->field.camera.fx_px, 60);
}

TEST(DataSets, EurocsSensorForAnotherSizeIsRefused) {
    const fs::path folder = euroc_folder();
    std::string yaml = sensor_yaml;
    yaml.replace(yaml.find("[64, 48]"), 8, "[752, 480]");
    write_bytes(folder / "mav0" / "cam0" / "sensor.yaml", yaml);
    DataSetFolder sequence(folder, DataSetKind::Euroc, mount_only(), std::nullopt);
    try {
        sequence.next();
        FAIL() << "the sizes differ";
    } catch (const InputError& error) {
        expect_parts(error.what(), {"752 x 480", "64 x 48"});
    }
}

TEST(DataSets, EurocsGroundTruthIsThatOfTheBody) {
    const fs::path folder = euroc_folder();
    const fs::path truth = folder / "mav0" / "state_groundtruth_estimate0";
    fs::create_directories(truth);
    write_bytes(
        truth / "data.csv",
        "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []\n"
        "1403636579763555584,4.0,-1.0,0.5,1,0,0,0,0.1\n1403636579863555584,4.1,-1.0,0.5,1,0,0,0,0.1\n");
    DataSetFolder without(folder, DataSetKind::Euroc, sample_camera(), std::nullopt);
    EXPECT_FALSE(without.next()->T_start_robot);
    EXPECT_TRUE(some_says(without.notes(), {"state_groundtruth_estimate0", "T_BS"}));
    std::string yaml = sensor_yaml;
    // The camera looks along the body's x axis: its optical axes in the body are -y, -z, x.
    const auto begin = yaml.find("[0.0, -1.0");
    yaml.replace(begin, yaml.find(']', begin) + 1 - begin,
                 "[0.0, 0.0, 1.0, 0.2,\n        -1.0, 0.0, 0.0, 0.0,\n         0.0, -1.0, 0.0, 0.0,\n        "
                 " 0.0, 0.0, 0.0, 1.0]");
    write_bytes(folder / "mav0" / "cam0" / "sensor.yaml", yaml);
    DataSetFolder sequence(folder, DataSetKind::Euroc, mount_only(), std::nullopt);
    sequence.next();
    const auto middle = sequence.next();
    ASSERT_TRUE(middle && middle->T_start_robot);
    EXPECT_NEAR(middle->T_start_robot->x_m, 0.05, 1e-6);
    EXPECT_NEAR(middle->T_start_robot->y_m, 0, 1e-6);
}

TEST(DataSets, AnotherFolderIsNamed) {
    try {
        DataSetFolder(euroc_folder(), DataSetKind::Tum, sample_camera(), std::nullopt);
        FAIL() << "it is a EuRoC folder";
    } catch (const InputError& error) {
        expect_parts(error.what(), {"no TUM data set", "rgb.txt"});
    }
}

}  // namespace
}  // namespace flownav::io
