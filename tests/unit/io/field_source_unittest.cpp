#include "flownav/io/field_source.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationStereoImages.h>
#include <mrpt/system/datetime.h>

#include <cmath>
#include <fstream>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>

#include "flownav/math/units.h"
#include "rawlog_files.h"

namespace flownav::io {
namespace {

using namespace flownav::testing;
using Objects = std::vector<mrpt::serialization::CSerializable::ConstPtr>;

struct SourceResult {
    std::vector<Field> fields;
    std::vector<PoseSample> poses;
    InputCounts counts;
    ReadEnd end;
};

SourceResult read_file(const std::filesystem::path& file, const config::CameraConfig& camera = {}) {
    RawlogReader reader(file);
    FieldSource source(reader, camera);
    SourceResult result;
    while (const auto event = source.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) {
            result.fields.push_back(*field);
        } else {
            result.poses.push_back(std::get<PoseSample>(*event));
        }
    }
    result.counts = source.counts();
    result.end = reader.end();
    return result;
}

SourceResult read(const Objects& objects, const config::CameraConfig& camera = {}) {
    const auto file = test_folder() / "input.rawlog";
    write_bytes(file, gz(serialized(objects)));
    return read_file(file, camera);
}

std::string config_error(const Objects& objects, const config::CameraConfig& camera = {}) {
    try {
        read(objects, camera);
    } catch (const config::ConfigError& e) {
        return e.what();
    }
    return "";
}

std::string config_error_of_pose(double x_m, double height_m, double yaw_deg, double pitch_deg,
                                 double roll_deg) {
    auto image = image_at(1);
    image->cameraPose = mrpt::poses::CPose3D(x_m, 0, height_m, yaw_deg * degree_rad, pitch_deg * degree_rad,
                                             roll_deg * degree_rad) +
                        mrpt::poses::CPose3D(0, 0, 0, -90 * degree_rad, 0, -90 * degree_rad);
    return config_error({image});
}

void expect_names(const std::string& message, std::initializer_list<const char*> parts) {
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
}

TEST(FieldSource, HandsOutFieldsAndPosesInTheOrderOfTheFile) {
    const auto result = read(small_recording());
    EXPECT_EQ(result.fields.size(), 8U);
    EXPECT_EQ(result.poses.size(), 16U);
    EXPECT_EQ(result.counts.objects, 24U);
    EXPECT_EQ(result.counts.images, 8U);
    EXPECT_EQ(result.counts.fields, 8U);
    EXPECT_EQ(result.counts.odometry, 8U);
    EXPECT_EQ(result.counts.ground_truth, 8U);
    EXPECT_TRUE(result.counts.rejected.empty());
    EXPECT_TRUE(result.counts.warnings.empty());
    EXPECT_EQ(result.counts.observations.at("CObservationImage CAMERA1"), 8U);
    EXPECT_NEAR(result.fields[3].timestamp_s, 100.12, 1e-6);
    EXPECT_NEAR(result.poses[6].pose.x, 0.03, 1e-9);
}

TEST(FieldSource, TakesCalibrationAndPoseFromTheImage) {
    const CameraModel camera = read({image_at(1)}).fields.at(0).camera;
    EXPECT_EQ(camera.width_px, 64);
    EXPECT_EQ(camera.height_px, 48);
    EXPECT_DOUBLE_EQ(camera.fx_px, 60);
    EXPECT_DOUBLE_EQ(camera.fy_px, 50);
    EXPECT_DOUBLE_EQ(camera.cx_px, 31.5);
    EXPECT_DOUBLE_EQ(camera.cy_px, 23.5);
    EXPECT_NEAR(camera.mount.height_m, 0.5, 1e-12);
    EXPECT_NEAR(camera.mount.pitch_rad, 10 * degree_rad, 1e-12);
    EXPECT_NEAR(camera.mount.roll_rad, 0, 1e-12);
    EXPECT_NEAR(camera.mount.yaw_rad, 0, 1e-12);
    EXPECT_NEAR(camera.mount.forward_m, 0.1, 1e-12);
    EXPECT_NEAR(camera.mount.left_m, 0.02, 1e-12);
}

TEST(FieldSource, IniOverridesTheRecording) {
    config::CameraConfig config;
    config.fx_px = 70;
    config.cy_px = 20;
    config.height_m = 0.8;
    config.pitch_deg = 25;
    config.roll_deg = -2;
    config.yaw_deg = 1.5;
    config.forward_m = 0.3;
    config.distortion = std::array<double, 5>{0.1, 0, 0, 0, 0};
    const CameraModel camera = read({image_at(1)}, config).fields.at(0).camera;
    EXPECT_DOUBLE_EQ(camera.fx_px, 70);
    EXPECT_DOUBLE_EQ(camera.fy_px, 50);
    EXPECT_DOUBLE_EQ(camera.cy_px, 20);
    EXPECT_DOUBLE_EQ(camera.mount.height_m, 0.8);
    EXPECT_NEAR(camera.mount.pitch_rad, 25 * degree_rad, 1e-12);
    EXPECT_NEAR(camera.mount.roll_rad, -2 * degree_rad, 1e-12);
    EXPECT_NEAR(camera.mount.yaw_rad, 1.5 * degree_rad, 1e-12);
    EXPECT_DOUBLE_EQ(camera.mount.forward_m, 0.3);
    EXPECT_NEAR(camera.mount.left_m, 0.02, 1e-12);
    EXPECT_DOUBLE_EQ(camera.distortion[0], 0.1);
}

TEST(FieldSource, GreyImagesAreNotCopied) {
    const auto image = image_at(1);
    const auto file = test_folder() / "input.rawlog";
    write_bytes(file, serialized({image}));
    RawlogReader reader(file);
    FieldSource source(reader, {});
    const auto field = std::get<Field>(source.next().value());
    const auto* owner = static_cast<const mrpt::obs::CObservationImage*>(field.owner.get());
    EXPECT_EQ(field.image.data, owner->image.asCvMatRef().data);
    EXPECT_EQ(field.image.at(5, 7), image->image.asCvMatRef().at<uint8_t>(7, 5));
}

TEST(FieldSource, ColourBecomesGrey) {
    auto image = image_at(1);
    image->image = mrpt::img::CImage(cv::Mat(48, 64, CV_8UC3, cv::Scalar(10, 200, 90)), mrpt::img::DEEP_COPY);
    const auto result = read({image});
    ASSERT_EQ(result.fields.size(), 1U);
    EXPECT_NEAR(result.fields[0].image.at(30, 20), 0.114 * 10 + 0.587 * 200 + 0.299 * 90, 3);
}

TEST(FieldSource, WovenFramesBecomeTwoFieldsHalfAPeriodApart) {
    Objects objects;
    for (int i = 0; i < 4; ++i) objects.push_back(image_at(10 + 0.04 * i, static_cast<unsigned>(i)));
    config::CameraConfig config;
    config.interlaced = config::Interlaced::TopFirst;
    const auto result = read(objects, config);
    ASSERT_EQ(result.fields.size(), 8U);
    EXPECT_EQ(result.counts.images, 4U);
    EXPECT_EQ(result.counts.fields, 8U);
    for (int i = 0; i < 8; ++i)
        EXPECT_NEAR(result.fields[static_cast<size_t>(i)].timestamp_s, 10 + 0.02 * i, 1e-6);
    const auto& recorded = dynamic_cast<const mrpt::obs::CObservationImage&>(*objects[1]).image.asCvMatRef();
    const Field& top = result.fields[2];
    const Field& bottom = result.fields[3];
    EXPECT_EQ(top.image.height_px, 24);
    EXPECT_EQ(bottom.image.height_px, 24);
    EXPECT_EQ(top.image.at(9, 5), recorded.at<uint8_t>(10, 9));
    EXPECT_EQ(bottom.image.at(9, 5), recorded.at<uint8_t>(11, 9));
    EXPECT_EQ(bottom.image.data, top.image.data + top.image.stride_bytes / 2);
}

TEST(FieldSource, BothFieldsSeeTheSameRaysAsTheWovenFrame) {
    const CameraModel frame = read({image_at(1)}).fields.at(0).camera;
    config::CameraConfig config;
    config.interlaced = config::Interlaced::BottomFirst;
    const auto fields = read({image_at(1), image_at(2)}, config).fields;
    const Eigen::Vector2d even = RayMapper(frame).ray({12, 20});
    const Eigen::Vector2d odd = RayMapper(frame).ray({12, 21});
    EXPECT_LT((RayMapper(fields[0].camera).ray({12, 10}) - odd).norm(), 1e-12);
    EXPECT_LT((RayMapper(fields[1].camera).ray({12, 10}) - even).norm(), 1e-12);
}

TEST(FieldSource, SecondFieldStaysBetweenFramesWhenOneIsDroppedOrEarly) {
    Objects objects;
    for (const double t : {0.0, 0.04, 0.08, 0.20, 0.21, 0.25}) objects.push_back(image_at(10 + t));
    config::CameraConfig config;
    config.interlaced = config::Interlaced::TopFirst;
    const auto fields = read(objects, config).fields;
    ASSERT_EQ(fields.size(), 12U);
    for (size_t i = 1; i < fields.size(); ++i) EXPECT_GT(fields[i].timestamp_s, fields[i - 1].timestamp_s);
    EXPECT_NEAR(fields[5].timestamp_s, 10.10, 1e-6);
    EXPECT_NEAR(fields[7].timestamp_s, 10.205, 1e-6);
}

TEST(FieldSource, TimeThatStandsStillOrRunsBackwardsIsRejected) {
    const auto result = read({image_at(1.0), image_at(1.1), image_at(1.1), image_at(1.05), image_at(1.2),
                              odometry_at(1.0, 0), odometry_at(0.9, 0), truth_at(1.0, 0), truth_at(1.0, 0)});
    EXPECT_EQ(result.fields.size(), 3U);
    EXPECT_EQ(result.counts.rejected.at("time_repeated"), 1U);
    EXPECT_EQ(result.counts.rejected.at("time_backwards"), 1U);
    EXPECT_EQ(result.counts.rejected.at("odometry_time_backwards"), 1U);
    EXPECT_EQ(result.counts.rejected.at("ground_truth_time_repeated"), 1U);
}

TEST(FieldSource, InvalidTimeIsRejected) {
    auto image = image_at(1);
    image->timestamp = INVALID_TIMESTAMP;
    const auto result = read({image, image_at(2)});
    EXPECT_EQ(result.fields.size(), 1U);
    EXPECT_EQ(result.counts.rejected.at("time_invalid"), 1U);
}

TEST(FieldSource, PoseThatIsNoNumberIsRejected) {
    const auto result = read({odometry_at(1, std::nan("")), odometry_at(2, 1)});
    EXPECT_EQ(result.poses.size(), 1U);
    EXPECT_EQ(result.counts.rejected.at("odometry_not_finite"), 1U);
}

TEST(FieldSource, EmptyImageIsRejected) {
    auto image = image_at(1);
    image->image = mrpt::img::CImage();
    image->image.resize(0, 0, mrpt::img::CH_GRAY);
    const auto result = read({image, image_at(2)});
    EXPECT_EQ(result.fields.size(), 1U);
    EXPECT_EQ(result.counts.rejected.at("image_empty"), 1U);
}

TEST(FieldSource, ImageOfSixteenBitsIsRejected) {
    auto image = image_at(1);
    image->image.resize(64, 48, mrpt::img::CH_GRAY, mrpt::img::PixelDepth::D16U);
    const auto result = read({image, image_at(2)});
    EXPECT_EQ(result.fields.size(), 1U);
    EXPECT_EQ(result.counts.rejected.at("image_not_8bit"), 1U);
}

TEST(FieldSource, ExternalImagesAreFoundAndMissingOnesRejected) {
    const auto folder = test_folder();
    std::filesystem::create_directories(folder / "drive_Images");
    const cv::Mat pixels(48, 64, CV_8UC1, cv::Scalar(77));
    cv::imwrite((folder / "drive_Images" / "a.png").string(), pixels);
    write_bytes(folder / "drive_Images" / "text.png", "no picture");
    Objects objects;
    double t = 1;
    for (const char* name : {"a.png", "gone.png", "text.png"}) {
        auto image = image_at(t++);
        image->image.setExternalStorage(name);
        objects.push_back(image);
    }
    write_bytes(folder / "drive.rawlog", serialized(objects));
    const auto result = read_file(folder / "drive.rawlog");
    ASSERT_EQ(result.fields.size(), 1U);
    EXPECT_EQ(result.fields[0].image.at(3, 3), 77);
    EXPECT_EQ(result.counts.rejected.at("image_missing"), 1U);
    EXPECT_EQ(result.counts.rejected.at("image_unreadable"), 1U);
    EXPECT_EQ(result.end.kind, ReadEnd::Kind::Clean);
}

TEST(FieldSource, ImageWithoutCalibrationNamesTheKeysToSet) {
    auto image = image_at(1);
    image->cameraParams = mrpt::img::TCamera();
    expect_names(config_error({image}), {"camera.fx_px", "camera.fy_px", "camera.cx_px", "camera.cy_px"});
    image->cameraPose = mrpt::poses::CPose3D();
    expect_names(config_error({image}), {"camera.fx_px", "camera.height_m", "camera.pitch_deg"});
}

TEST(FieldSource, ImageWithoutCalibrationIsFineWhenTheIniHasIt) {
    auto image = image_at(1);
    image->cameraParams = mrpt::img::TCamera();
    image->cameraPose = mrpt::poses::CPose3D();
    config::CameraConfig config;
    config.fx_px = config.fy_px = 55;
    config.cx_px = 31;
    config.cy_px = 23;
    config.height_m = 0.4;
    config.pitch_deg = 12;
    const auto result = read({image}, config);
    ASSERT_EQ(result.fields.size(), 1U);
    EXPECT_NEAR(result.fields[0].camera.mount.pitch_rad, 12 * degree_rad, 1e-12);
    EXPECT_EQ(result.fields[0].camera.mount.roll_rad, 0);
}

TEST(FieldSource, PoseWithoutOpticalRotationAsksForThePitch) {
    auto image = image_at(1);
    image->cameraPose = mrpt::poses::CPose3D(0.1, 0, 0.5, 0, 0, 0);
    expect_names(config_error({image}), {"camera.pitch_deg"});
}

TEST(FieldSource, UnusableCameraPosesAreErrorsThatNameKeyValueAndRange) {
    expect_names(config_error_of_pose(0, 0.5, 0, -20, 0), {"camera.pitch_deg", "-20", "-5 .. 80"});
    expect_names(config_error_of_pose(0, 0.5, 0, 85, 0), {"camera.pitch_deg", "85", "-5 .. 80"});
    expect_names(config_error_of_pose(0, 0.5, 0, 10, 15), {"camera.roll_deg", "15", "-10 .. 10"});
    expect_names(config_error_of_pose(0, 0.5, -30, 10, 0), {"yaw", "-30", "-10 .. 10"});
    expect_names(config_error_of_pose(0.1, 0, 0, 10, 0), {"camera.height_m", "0", "0.01 .. 20"});
    expect_names(config_error_of_pose(0, -0.3, 0, 10, 0), {"camera.height_m", "-0.3", "0.01 .. 20"});
    expect_names(config_error_of_pose(0, std::nan(""), 0, 10, 0), {"no number"});
    EXPECT_EQ(config_error_of_pose(0, 0.5, 5, 10, -5), "");
}

TEST(FieldSource, IntrinsicsThatAreNoPixelsAreErrorsThatAskForThem) {
    const auto error_of = [](double fx, double fy, double cx, double cy) {
        auto image = image_at(1);
        image->cameraParams.setIntrinsicParamsFromValues(fx, fy, cx, cy);
        return config_error({image});
    };
    const auto w = static_cast<double>(image_at(1)->image.getWidth());
    const auto h = static_cast<double>(image_at(1)->image.getHeight());
    expect_names(error_of(1.1, 1.4, 0.5, 0.5), {"camera.fx_px", "1.1", "are these pixels?"});
    expect_names(error_of(w, 1.4, w / 2, h / 2), {"camera.fy_px", "1.4", "are these pixels?"});
    expect_names(error_of(w, w, 4 * w, h / 2), {"camera.cx_px", "are these pixels?"});
    expect_names(error_of(w, w, w / 2, -3 * h), {"camera.cy_px", "are these pixels?"});
    expect_names(error_of(1e6, 1e6, w / 2, h / 2), {"camera.fx_px", "50000"});
    EXPECT_EQ(error_of(0.3 * w, 0.3 * w, w / 2, h / 2), "");
}

TEST(FieldSource, IntrinsicsOfTheIniAreCheckedAgainstTheImageAsWell) {
    config::CameraConfig config;
    config.fx_px = config.fy_px = 2.4;
    expect_names(config_error({image_at(1)}, config), {"camera.fx_px", "2.4", "are these pixels?"});
}

TEST(FieldSource, ADistortionThatBendsNoLensIsAnError) {
    auto image = image_at(1);
    image->cameraParams.setDistortionPlumbBob(1e9, 0, 0, 0, 0);
    expect_names(config_error({image}), {"camera.distortion", "-100 .. 100"});
}

TEST(FieldSource, AnglesAndOffsetsComeBackFromAPose) {
    auto image = image_at(1);
    image->cameraPose =
        mrpt::poses::CPose3D(0.3, -0.1, 0.9, 4 * degree_rad, 25 * degree_rad, -6 * degree_rad) +
        mrpt::poses::CPose3D(0, 0, 0, -90 * degree_rad, 0, -90 * degree_rad);
    const CameraMount mount = read({image}).fields.at(0).camera.mount;
    EXPECT_NEAR(mount.yaw_rad, 4 * degree_rad, 1e-9);
    EXPECT_NEAR(mount.pitch_rad, 25 * degree_rad, 1e-9);
    EXPECT_NEAR(mount.roll_rad, -6 * degree_rad, 1e-9);
    EXPECT_NEAR(mount.left_m, -0.1, 1e-9);
}

TEST(FieldSource, FisheyeLensIsAnErrorUnlessTheIniHasTheDistortion) {
    auto image = image_at(1);
    image->cameraParams.setDistortionKannalaBrandt(0.1, 0, 0, 0);
    expect_names(config_error({image}), {"camera.distortion", "kannala_brandt", "plumb_bob"});
    config::CameraConfig config;
    config.distortion = std::array<double, 5>{};
    EXPECT_EQ(read({image}, config).fields.size(), 1U);
}

TEST(FieldSource, PlumbBobDistortionIsPassedOn) {
    auto image = image_at(1);
    image->cameraParams.setDistortionPlumbBob(-0.3, 0.1, 0.001, 0.002, 0.03);
    const std::array<double, 5> expected{-0.3, 0.1, 0.001, 0.002, 0.03};
    EXPECT_EQ(read({image}).fields.at(0).camera.distortion, expected);
}

TEST(FieldSource, ChangingImageSizeIsPassedOnWithAWarning) {
    auto image = image_at(2);
    image->image.resize(32, 24, mrpt::img::CH_GRAY);
    image->cameraParams.ncols = 32;
    image->cameraParams.nrows = 24;
    const auto result = read({image_at(1), image, image_at(3)});
    EXPECT_EQ(result.fields.size(), 3U);
    EXPECT_EQ(result.counts.warnings.at("image_size_changed"), 2U);
}

TEST(FieldSource, CalibrationOfAnotherImageSizeIsAWarning) {
    auto image = image_at(1);
    image->cameraParams.ncols = 640;
    EXPECT_EQ(read({image}).counts.warnings.at("calibration_of_another_size"), 1U);
}

TEST(FieldSource, IntensityImageOfADepthCameraIsAnImage) {
    auto depth = mrpt::obs::CObservation3DRangeScan::Create();
    depth->timestamp = mrpt::Clock::fromDouble(1.0);
    depth->sensorLabel = "CAMERA1";
    depth->sensorPose = mrpt::poses::CPose3D(0.2, 0, 0.7, 0, 15 * degree_rad, 0);
    depth->hasIntensityImage = true;
    depth->intensityImage = image_at(1)->image;
    depth->cameraParamsIntensity = image_at(1)->cameraParams;
    const auto result = read({depth});
    ASSERT_EQ(result.fields.size(), 1U);
    const CameraModel& camera = result.fields[0].camera;
    EXPECT_DOUBLE_EQ(camera.fx_px, 60);
    EXPECT_NEAR(camera.mount.pitch_rad, 15 * degree_rad, 1e-9);
    EXPECT_NEAR(camera.mount.height_m, 0.7, 1e-9);
    depth->hasIntensityImage = false;
    EXPECT_EQ(read({depth}).counts.ignored, 1U);
}

TEST(FieldSource, TheLeftImageOfAStereoCameraIsAnImage) {
    auto stereo = mrpt::obs::CObservationStereoImages::Create();
    stereo->timestamp = mrpt::Clock::fromDouble(1.0);
    stereo->sensorLabel = "CAMERA1";
    stereo->cameraPose = mrpt::poses::CPose3DQuat(image_at(1)->cameraPose);
    stereo->imageLeft = image_at(1)->image;
    stereo->leftCamera = image_at(1)->cameraParams;
    const auto result = read({stereo});
    ASSERT_EQ(result.fields.size(), 1U);
    EXPECT_DOUBLE_EQ(result.fields[0].camera.fx_px, 60);
    EXPECT_NEAR(result.fields[0].camera.mount.pitch_rad, 10 * degree_rad, 1e-9);
    EXPECT_NEAR(result.fields[0].camera.mount.height_m, 0.5, 1e-9);
}

/// A calibrated image whose intrinsics are all different.
mrpt::obs::CObservationImage::Ptr uneven_image(double timestamp_s) {
    auto image = image_at(timestamp_s);
    image->cameraParams.setIntrinsicParamsFromValues(60, 50, 30, 25);
    image->cameraParams.setDistortionPlumbBob(-0.1, 0.02, 0.003, 0.004, 0.0);
    return image;
}

TEST(FieldSource, ATurnedOrMirroredImageShowsEveryPointUnderTheSameRay) {
    const auto recorded = read({uneven_image(1)}).fields.at(0);
    config::CameraConfig config;
    for (const bool mirror : {false, true}) {
        for (const int rotate_deg : {0, 90, 180, 270}) {
            config.mirror = mirror;
            config.rotate_deg = rotate_deg;
            const Field used = read({uneven_image(1)}, config).fields.at(0);
            CameraModel level = recorded.camera, turned = used.camera;
            level.mount.pitch_rad = turned.mount.pitch_rad = 0.0;
            const Eigen::Vector2i at(11, 17);  // of the recorded image
            Eigen::Vector2d ray = RayMapper(level).ray(at.cast<double>());
            int u = at.x(), v = at.y(), width = 64, height = 48;
            if (mirror) u = width - 1 - u, ray.x() = -ray.x();
            for (int turn = 0; turn < rotate_deg; turn += 90) {
                const int from_u = u;
                u = height - 1 - v;
                v = from_u;
                std::swap(width, height);
                ray = Eigen::Vector2d(-ray.y(), ray.x());
            }
            EXPECT_EQ(used.image.width_px, width);
            EXPECT_EQ(used.image.height_px, height);
            EXPECT_EQ(used.image.at(u, v), recorded.image.at(at.x(), at.y())) << mirror << rotate_deg;
            EXPECT_LT((RayMapper(turned).ray({u, v}) - ray).norm(), 1e-9) << mirror << rotate_deg;
        }
    }
}

TEST(FieldSource, MaskedRowsAtTheBottomOrTopAreCutOff) {
    config::CameraConfig config;
    config.masked_rows = config::RowRange{40, 47};
    const Field upper = read({image_at(1)}, config).fields.at(0);
    EXPECT_EQ(upper.image.height_px, 40);
    EXPECT_EQ(upper.camera.height_px, 40);
    EXPECT_DOUBLE_EQ(upper.camera.cy_px, 23.5);
    config.masked_rows = config::RowRange{0, 9};
    const Field lower = read({image_at(1)}, config).fields.at(0);
    EXPECT_EQ(lower.image.height_px, 38);
    EXPECT_DOUBLE_EQ(lower.camera.cy_px, 13.5);
    EXPECT_EQ(lower.image.at(5, 0), read({image_at(1)}).fields.at(0).image.at(5, 10));
    config.masked_rows = config::RowRange{20, 30};
    expect_names(config_error({image_at(1)}, config), {"camera.mask = 20 30", "47"});
    config.masked_rows = config::RowRange{4, 47};
    expect_names(config_error({image_at(1)}, config), {"camera.mask = 4 47", "4 of 48 rows"});
}

TEST(FieldSource, ACalibrationForAnotherSizeOfTheSameShapeIsScaled) {
    auto image = image_at(1);
    image->cameraParams.ncols = 128;
    image->cameraParams.nrows = 96;
    image->cameraParams.setIntrinsicParamsFromValues(120, 100, 63.5, 47.5);
    const auto result = read({image});
    const CameraModel& camera = result.fields.at(0).camera;
    EXPECT_DOUBLE_EQ(camera.fx_px, 60);
    EXPECT_DOUBLE_EQ(camera.fy_px, 50);
    EXPECT_DOUBLE_EQ(camera.cx_px, 31.5);
    EXPECT_DOUBLE_EQ(camera.cy_px, 23.5);
    EXPECT_EQ(result.counts.warnings.at("calibration_scaled"), 1U);
}

TEST(FieldSource, ACalibrationForAnotherShapeIsAnErrorThatNamesBothSizes) {
    auto image = image_at(1);
    image->cameraParams.ncols = 128;
    image->cameraParams.nrows = 72;
    image->cameraParams.setIntrinsicParamsFromValues(120, 100, 63.5, 35.5);
    expect_names(config_error({image}), {"128 x 72", "64 x 48", "camera.fx_px"});
}

TEST(FieldSource, APrincipalPointOfAnotherSizeIsNoted) {
    auto image = image_at(1);
    image->cameraParams.setIntrinsicParamsFromValues(120, 100, 63.5, 47.5);
    EXPECT_EQ(read({image}).counts.warnings.at("principal_point_off_centre"), 1U);
    EXPECT_EQ(read({image_at(1)}).counts.warnings.count("principal_point_off_centre"), 0U);
}

TEST(FieldSource, APoseWithXForwardIsConverted) {
    auto image = image_at(1);
    image->cameraPose =
        mrpt::poses::CPose3D(0.1, 0.02, 0.5, 2 * degree_rad, 25 * degree_rad, -3 * degree_rad);
    const auto result = read({image});
    const CameraMount& mount = result.fields.at(0).camera.mount;
    EXPECT_NEAR(mount.pitch_rad, 25 * degree_rad, 1e-9);
    EXPECT_NEAR(mount.yaw_rad, 2 * degree_rad, 1e-9);
    EXPECT_NEAR(mount.roll_rad, -3 * degree_rad, 1e-9);
    EXPECT_NEAR(mount.height_m, 0.5, 1e-9);
    EXPECT_EQ(result.counts.warnings.at("pose_x_forward"), 1U);
}

TEST(FieldSource, APoseThatIsUpsideDownNamesTheKeyThatTurnsTheImage) {
    for (const auto& [roll_deg, rotate_deg] : {std::pair{180, 180}, std::pair{92, 90}, std::pair{-91, 270}}) {
        expect_names(config_error_of_pose(0, 0.5, 0, 10, roll_deg),
                     {"camera.rotate = ", std::to_string(rotate_deg).c_str()});
        auto image = image_at(1);
        image->cameraPose = mrpt::poses::CPose3D(0, 0, 0.5, 0, 10 * degree_rad, roll_deg * degree_rad) +
                            mrpt::poses::CPose3D(0, 0, 0, -90 * degree_rad, 0, -90 * degree_rad);
        config::CameraConfig config;
        config.rotate_deg = rotate_deg;
        const CameraMount mount = read({image}, config).fields.at(0).camera.mount;
        EXPECT_NEAR(mount.pitch_rad, 10 * degree_rad, 1e-9);
        EXPECT_LT(std::abs(mount.roll_rad), 3 * degree_rad);
    }
}

TEST(FieldSource, OdometryAndGroundTruthOfOtherLabelsAreReadByTheirKeys) {
    auto wheels = odometry_at(1.0, 0.5);
    wheels->sensorLabel = "wheel odom";
    auto truth = truth_at(1.0, 0.5);
    truth->sensorLabel = "mocap";
    const auto file = test_folder() / "input.rawlog";
    write_bytes(file, gz(serialized({wheels, truth, odometry_at(1.1, 9.0)})));
    RawlogReader reader(file);
    FieldSource source(reader, {}, {"wheel odom", "mocap", 2.0});
    std::vector<PoseSample> poses;
    while (const auto event = source.next()) poses.push_back(std::get<PoseSample>(*event));
    ASSERT_EQ(poses.size(), 2U);
    EXPECT_NEAR(poses[0].timestamp_s, 3.0, 1e-6);  // by the offset of the odometry
    EXPECT_NEAR(poses[1].timestamp_s, 1.0, 1e-6);
    EXPECT_EQ(source.counts().ignored, 1U);
}

TEST(FieldSource, OtherLabelsAreIgnoredAndListed) {
    auto image = image_at(1);
    image->sensorLabel = "REAR";
    const auto result = read({image, image_at(2)});
    EXPECT_EQ(result.fields.size(), 1U);
    EXPECT_EQ(result.counts.ignored, 1U);
    EXPECT_EQ(result.counts.observations.at("CObservationImage REAR"), 1U);
}

TEST(FieldSource, EverythingBeforeACutIsHandedOut) {
    const auto file = test_folder() / "input.rawlog";
    const std::string bytes = serialized(small_recording());
    write_bytes(file, bytes.substr(0, bytes.size() / 2 + 100));
    const auto result = read_file(file);
    EXPECT_GE(result.fields.size(), 3U);
    EXPECT_EQ(result.end.kind, ReadEnd::Kind::Truncated);
}

}  // namespace
}  // namespace flownav::io
