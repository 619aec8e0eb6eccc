#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <string>

#include "flownav/cli/number_text.h"
#include "flownav/evaluation/csv_files.h"
#include "flownav/evaluation/trajectory_file.h"
#include "flownav/io/output_file.h"
#include "rawlog_files.h"
#include "step_samples.h"

namespace flownav::evaluation {
namespace {

using testing::content;
using testing::test_folder;

std::string failure(const std::function<void()>& action) {
    try {
        action();
    } catch (const io::OutputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(NumberText, HasFixedDecimalsAndNoNegativeZero) {
    EXPECT_EQ(cli::fixed_text(1.5, 3), "1.500");
    EXPECT_EQ(cli::fixed_text(-0.0004, 3), "0.000");
    EXPECT_EQ(cli::fixed_text(-0.0, 0), "0");
    EXPECT_EQ(cli::fixed_text(-10.0, 0), "-10");
    EXPECT_EQ(cli::time_text(1767225600.04), "1767225600.040000");
}

TEST(NumberText, WhatIsNotFiniteIsEmpty) {
    EXPECT_EQ(cli::fixed_text(std::numeric_limits<double>::quiet_NaN(), 3), "");
    EXPECT_EQ(cli::fixed_text(std::numeric_limits<double>::infinity(), 3), "");
    EXPECT_EQ(cli::fixed_text(std::numeric_limits<double>::max(), 0).size(), 309U);
}

TEST(OutputFile, FullDiskIsAnErrorThatNamesTheFileAndTheReason) {
    const std::string message = failure([] {
        io::OutputFile file("/dev/full");
        file.write("text");
        file.close();
    });
    EXPECT_EQ(message, "cannot write /dev/full: No space left on device");
}

TEST(OutputFile, FullDiskIsNoticedAtTheLatestWhenAGzFileIsClosed) {
    const std::string message = failure([] {
        io::GzOutputFile file("/dev/full");
        file.Write("text", 4);
        file.close();
    });
    EXPECT_EQ(message, "cannot write /dev/full: No space left on device");
}

TEST(OutputFile, FullDiskIsNoticedWhileALongGzFileIsWritten) {
    const std::string noise = [] {
        std::string bytes(1U << 22U, ' ');
        std::uint32_t state = 1;
        for (char& c : bytes) c = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24U);
        return bytes;
    }();
    io::GzOutputFile file("/dev/full");
    EXPECT_THROW(file.Write(noise.data(), noise.size()), io::OutputError);
}

TEST(OutputFile, MissingFolderIsAnError) {
    const auto folder = test_folder();
    const std::string message = failure([&] { io::OutputFile file(folder / "none" / "file"); });
    EXPECT_EQ(message, "cannot write " + (folder / "none" / "file").string() + ": No such file or directory");
}

TEST(OutputFile, FolderThatCannotBeMadeIsAnError) {
    const auto folder = test_folder();
    io::write_file(folder / "file", "");
    EXPECT_NE(failure([&] { io::make_output_folder(folder / "file" / "below"); }).find("Not a directory"),
              std::string::npos);
    EXPECT_NE(failure([&] { io::make_output_folder(folder / "file"); }).find((folder / "file").string()),
              std::string::npos);
    io::make_output_folder(folder / "new" / "deep");
    EXPECT_TRUE(std::filesystem::is_directory(folder / "new" / "deep"));
}

TEST(OutputFile, GzFilesOfTheSameContentHaveTheSameBytes) {
    const auto folder = test_folder();
    for (const char* name : {"a", "b"}) {
        io::GzOutputFile file(folder / name);
        file.Write("content", 7);
        file.close();
    }
    const std::string bytes = content(folder / "a");
    EXPECT_EQ(bytes, content(folder / "b"));
    EXPECT_EQ(bytes.substr(4, 4), std::string(4, '\0')) << "the time in the gz header";
}

TEST(TrajectoryFile, WritesTimePositionAndQuaternionWithTheScalarLast) {
    const auto file = test_folder() / "t.tum";
    TrajectoryFile trajectory(file);
    trajectory.write(1000.04, Pose2{1.0, -0.5, M_PI / 2});
    trajectory.close();
    EXPECT_EQ(content(file),
              "1000.040000 1.000000 -0.500000 0.000000 0.000000000 0.000000000 0.707106781 0.707106781\n");
}

TEST(EgomotionCsv, HasTheDocumentedColumns) {
    const auto file = test_folder() / "e.csv";
    EgomotionCsv csv(file);
    csv.write(testing::step_at(0));
    pipeline::Step later = testing::step_at(4);
    later.carried = {0.25, 0.03, 0.004};
    csv.write(later);
    csv.close();
    EXPECT_EQ(
        content(file),
        "timestamp,status,omega_radps,pitch_rate_radps,v_mps,v_measured,image_of_cycle,placed,confident,"
        "inliers,ground_window,obstacles,carried_s,carried_sigma_m,carried_sigma_rad,omega_source,"
        "forward_source,contact_gate,floor_fit,vignetting,strips_free,strips_obstacle,strips_unknown\n"
        "1000.000000,waiting,,,,0,0,0,0,0,0,0,0.000000,0.0000,0.00000,,,,,,,,\n"
        "1000.160000,ok,0.200000,-0.001000,0.400000,1,4,350,320,300,20,2,0.250000,0.0300,0.00400,flow,"
        "wheels,open,0.8100,0.2000,2,3,1\n");
}

TEST(EgomotionCsv, ATurnThatAnotherSensorToldHasItsSource) {
    const auto file = test_folder() / "e.csv";
    pipeline::Step step = testing::step_at(1);
    step.status = FieldStatus::NoTexture;
    step.motion.omega_source = MotionSource::Gyro;
    step.motion.forward_source = MotionSource::Wheels;
    EgomotionCsv csv(file);
    csv.write(step);
    csv.close();
    const std::string text = content(file);
    EXPECT_NE(text.find("\n1000.040000,no_texture,0.200000,,0.400000,0,1,"), std::string::npos) << text;
    EXPECT_NE(text.find(",gyro,wheels,"), std::string::npos) << text;
}

TEST(EgomotionCsv, ATurnThatWasNotMeasuredAndNumbersThatAreNoneAreEmptyCells) {
    const auto file = test_folder() / "e.csv";
    pipeline::Step step = testing::step_at(1);
    step.status = FieldStatus::NoTexture;
    step.motion = {};
    step.v_mps = std::numeric_limits<double>::quiet_NaN();
    EgomotionCsv csv(file);
    csv.write(step);
    csv.close();
    EXPECT_NE(content(file).find("\n1000.040000,no_texture,,,,0,1,"), std::string::npos);
}

TEST(EgomotionCsv, AClosedGateIsNamedAndHasNoFigures) {
    const auto file = test_folder() / "e.csv";
    pipeline::Step step = testing::step_at(4);
    step.contacts = {};
    step.contacts.gate = ContactGate::NoTravel;
    EgomotionCsv csv(file);
    csv.write(step);
    csv.close();
    EXPECT_NE(content(file).find(",flow,wheels,no_travel,,,,,\n"), std::string::npos) << content(file);
}

TEST(EgomotionCsv, APoorFloorTellsHowLittleOfItFits) {
    const auto file = test_folder() / "e.csv";
    pipeline::Step step = testing::step_at(4);
    step.contacts.gate = ContactGate::PoorFloor;
    step.contacts.floor.fit_share = 0.3;
    EgomotionCsv csv(file);
    csv.write(step);
    csv.close();
    EXPECT_NE(content(file).find(",poor_floor,0.3000,0.2000,,,\n"), std::string::npos) << content(file);
}

TEST(EgomotionCsv, AFieldWithoutANewContactScanHasNoneInItsRow) {
    const auto file = test_folder() / "e.csv";
    pipeline::Step step = testing::step_at(4);
    step.new_contacts = false;
    EgomotionCsv csv(file);
    csv.write(step);
    csv.close();
    EXPECT_NE(content(file).find(",flow,wheels,,,,,,\n"), std::string::npos) << content(file);
}

TEST(ContactsCsv, HasARowForEachStripWithThePlaceOfAContact) {
    const auto file = test_folder() / "c.csv";
    ContactsCsv csv(file);
    csv.write(testing::step_at(3));
    csv.write(testing::step_at(4));
    csv.close();
    EXPECT_EQ(
        content(file),
        "timestamp,tangent_right,bearing_rad,kind,seen,cause,free_m,contact_m,near_m,far_m,score,x_m,y_m\n"
        "1000.160000,-0.2500,0.2450,obstacle,1,votes,1.2000,1.5000,1.4000,1.7000,210.0,1.6000,0.4250\n"
        "1000.160000,-0.1500,0.1489,free,1,,3.0000,,,,,,\n"
        "1000.160000,-0.0500,0.0500,unknown,0,,0.0000,,,,,,\n"
        "1000.160000,0.0500,-0.0500,free,1,,2.5000,,,,,,\n"
        "1000.160000,0.1500,-0.1489,obstacle,1,wall,1.8000,2.0000,1.9000,2.2000,0.0,2.1000,-0.2500\n"
        "1000.160000,0.2500,-0.2450,obstacle,1,drop,0.9000,1.0000,1.0000,1.2000,12.0,1.1000,-0.2000\n");
}

TEST(ContactsCsv, ACycleBehindAClosedGateHasNoRows) {
    const auto file = test_folder() / "c.csv";
    pipeline::Step step = testing::step_at(4);
    step.contacts.gate = ContactGate::PoorFloor;
    ContactsCsv csv(file);
    csv.write(step);
    csv.close();
    EXPECT_EQ(content(file).find('\n'), content(file).size() - 1) << "the names only";
}

TEST(ContactsCsv, AContactOnTheRightHasANegativeYAndANegativeBearing) {
    const auto file = test_folder() / "c.csv";
    pipeline::Step step = testing::step_at(4);
    step.contacts.strips.erase(step.contacts.strips.begin(), step.contacts.strips.begin() + 4);
    step.contacts.first = 1;
    ContactsCsv csv(file);
    csv.write(step);
    csv.close();
    EXPECT_NE(content(file).find(",0.1500,-0.1489,obstacle,"), std::string::npos) << content(file);
    EXPECT_NE(content(file).find(",2.1000,-0.2500\n"), std::string::npos) << content(file);
}

TEST(ContactsCsv, PlacesAreInTheFrameOfTheRowAlthoughTheScanIsOfAnEarlierPose) {
    const auto file = test_folder() / "c.csv";
    pipeline::Step step = testing::step_at(4);
    step.contacts.T_robot_scan = {-0.3, 0.0, 0.0};  // the robot has driven on by 0.3 m
    ContactsCsv csv(file);
    csv.write(step);
    csv.close();
    EXPECT_NE(content(file).find(",1.3000,0.4250\n"), std::string::npos) << content(file);
}

TEST(ObstaclesCsv, HasARowForEachPoint) {
    const auto file = test_folder() / "o.csv";
    ObstaclesCsv csv(file);
    csv.write(testing::step_at(3));
    csv.write(testing::step_at(4));
    csv.close();
    EXPECT_EQ(content(file),
              "timestamp,x_m,y_m,z_m,sigma_m,u_px,v_px\n"
              "1000.160000,2.0000,0.5000,0.3000,0.0500,104.00,62.00\n"
              "1000.160000,3.0000,-0.2500,0.6000,0.1000,600.50,20.25\n");
}

}  // namespace
}  // namespace flownav::evaluation
