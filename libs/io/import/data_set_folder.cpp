#include "flownav/io/data_set_folder.h"

#include <utility>

#include "flownav/io/camera_conversion.h"
#include "flownav/io/errors.h"
#include "import_files.h"
#include "pose_track.h"
#include "sensor_yaml.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;

/// Files of a data set.
struct Place {
    fs::path images, list, truth, sensor;
};

Place tum_place(const fs::path& directory) {
    return {directory / "rgb", directory / "rgb.txt", directory / "groundtruth.txt", {}};
}

/// Folder cam0 of a EuRoC data set; empty when there is none.
fs::path euroc_camera(const fs::path& directory) {
    for (const fs::path& folder : {directory / "mav0" / "cam0", directory / "cam0", directory})
        if (fs::is_regular_file(folder / "data.csv") && fs::is_directory(folder / "data")) return folder;
    return {};
}

Place euroc_place(const fs::path& directory) {
    const fs::path camera = euroc_camera(directory);
    const fs::path mav = fs::weakly_canonical(camera).parent_path();
    return {camera / "data", camera / "data.csv", mav / "state_groundtruth_estimate0" / "data.csv",
            camera / "sensor.yaml"};
}

}  // namespace

DataSetKind data_set_kind(const fs::path& directory) {
    if (fs::is_regular_file(directory / "rgb.txt") && fs::is_directory(directory / "rgb"))
        return DataSetKind::Tum;
    if (!euroc_camera(directory).empty()) return DataSetKind::Euroc;
    return DataSetKind::None;
}

struct DataSetFolder::Parts {
    Parts(const Place& of, const config::CameraConfig& camera, std::optional<TimeUnit> unit)
        : place(of), folder(of.images, camera, {of.list, std::nullopt, 25.0, unit}) {}

    Place place;
    ImageFolder folder;
    std::vector<SpacePose> poses;
    Eigen::Isometry3d T_body_camera = Eigen::Isometry3d::Identity();
    SensorYaml sensor;
    std::optional<PoseTrack> track;  ///< made when the camera's mount is known
    std::optional<Pose2> T_first_world;
    std::size_t notes_taken = 0;
    std::size_t problems_taken = 0;
};

DataSetFolder::DataSetFolder(const fs::path& directory, DataSetKind kind, config::CameraConfig camera,
                             std::optional<TimeUnit> unit) {
    require_directory(directory);
    const DataSetKind found = data_set_kind(directory);
    if (kind != found) {
        throw InputError(directory.string() + (kind == DataSetKind::Tum
                                                   ? ": is no TUM data set (rgb.txt and rgb)"
                                                   : ": is no EuRoC data set (mav0/cam0/data.csv and data)"));
    }
    const Place place = kind == DataSetKind::Tum ? tum_place(directory) : euroc_place(directory);
    SensorYaml sensor;
    bool filled = false;
    if (!place.sensor.empty() && fs::exists(place.sensor)) {
        sensor = read_sensor_yaml(place.sensor);
        filled = fill_open_keys(sensor, camera);
    }
    parts_ = std::make_unique<Parts>(place, camera, unit);
    parts_->sensor = sensor;
    if (filled) add_note(place.sensor.string() + ": gives the intrinsics of the camera and its distortion");
    if (!filled) parts_->sensor.width_px = 0;
    if (!fs::exists(place.truth)) return;
    if (kind == DataSetKind::Euroc && !sensor.T_body_camera) {
        add_note(place.truth.string() + ": is not used, there is no T_BS in " + place.sensor.string());
        return;
    }
    if (sensor.T_body_camera) parts_->T_body_camera = *sensor.T_body_camera;
    parts_->poses = kind == DataSetKind::Tum ? read_tum_poses(place.truth) : read_euroc_poses(place.truth);
    add_note(place.truth.string() + ": becomes the ground truth, projected on the ground");
}

DataSetFolder::~DataSetFolder() = default;

std::size_t DataSetFolder::size() const {
    return parts_->folder.size();
}

const std::string& DataSetFolder::times_source() const {
    return parts_->folder.times_source();
}

std::optional<SequenceFrame> DataSetFolder::next() {
    auto frame = parts_->folder.next();
    const auto& notes = parts_->folder.notes();
    const auto& problems = parts_->folder.problems();
    while (parts_->notes_taken < notes.size()) add_note(notes[parts_->notes_taken++]);
    while (parts_->problems_taken < problems.size()) add_problem(problems[parts_->problems_taken++]);
    if (!frame) return frame;
    const CameraModel& camera = frame->field.camera;
    const SensorYaml& sensor = parts_->sensor;
    if (sensor.width_px > 0 && (sensor.width_px != camera.width_px || sensor.height_px != camera.height_px)) {
        throw InputError(parts_->place.sensor.string() + ": is for images of " +
                         std::to_string(sensor.width_px) + " x " + std::to_string(sensor.height_px) +
                         " pixels, these have " + std::to_string(camera.width_px) + " x " +
                         std::to_string(camera.height_px) + "; set camera.fx_px, fy_px, cx_px and cy_px");
    }
    if (!parts_->track) parts_->track = robot_track(parts_->poses, parts_->T_body_camera, camera.mount);
    const auto T_world_robot = parts_->track->at(frame->field.timestamp_s);
    if (!T_world_robot) return frame;
    if (!parts_->T_first_world) parts_->T_first_world = inverse(*T_world_robot);
    frame->T_start_robot = compose(*parts_->T_first_world, *T_world_robot);
    return frame;
}

}  // namespace flownav::io
