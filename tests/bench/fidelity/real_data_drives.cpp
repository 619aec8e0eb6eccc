#include <array>
#include <fstream>
#include <sstream>

#include "flownav/config/make_state.h"
#include "flownav/evaluation/metrics.h"
#include "flownav/io/image_folder.h"
#include "flownav/io/kitti.h"
#include "flownav/math/units.h"
#include "markdown.h"
#include "real_data.h"
#include "statistics.h"

namespace flownav::fidelity {
namespace {

namespace fs = std::filesystem;

constexpr auto odometry_text = R"(
### KITTI odometry, sequence 00: 84 m from a cold start

100 images at 10 Hz, up to 1.06 m and 2.1 deg from image to image; `ini/kitti.ini`.

)";

constexpr auto gyro_text = R"(
### DonkeyCar: turn rate against a gyro

370 images of 160x120 at 20 Hz through a wide-angle lens, not calibrated; a smooth floor and motion blur;
`ini/donkeycar.ini`. Each image whose turn is known is compared with the gyro over the interval that ends with it:
with the camera alone, and with the gyro as an input (`motion.gyro`), where the rest is what the flow differs from it.

)";

config::Config config_of(const std::string& ini) {
    config::Config config;
    config::load_config_file(config, std::string(FLOWNAV_INI_DIR) + '/' + ini);
    return config;
}

std::vector<evaluation::FieldRow> drive_through(io::ImageSequence& images, const config::Config& config,
                                                evaluation::PoseTrack& truth) {
    pipeline::State state = config::make_state(config);
    const std::vector<GyroRate> gyro = images.gyro();
    std::size_t noted = 0;
    std::vector<evaluation::FieldRow> rows;
    while (const auto frame = images.next()) {
        // Up to the first reading that is not before the image.
        while (noted < gyro.size() && (noted == 0 || gyro[noted - 1].timestamp_s < frame->field.timestamp_s))
            pipeline::note_gyro(state, gyro[noted++]);
        rows.push_back(evaluation::row_of(pipeline::step(state, frame->field)));
        if (!frame->T_start_robot) continue;
        const Pose2& pose = *frame->T_start_robot;
        truth.add(frame->field.timestamp_s, {pose.x_m, pose.y_m, 0.0, pose.yaw_rad, 0.0, 0.0});
    }
    truth.finish();
    return rows;
}

Share ok_share(const std::vector<evaluation::FieldRow>& rows) {
    Share ok;
    for (std::size_t i = 1; i < rows.size(); ++i) ok.add(rows[i].status == FieldStatus::Ok);
    return ok;
}

int first_ok(const std::vector<evaluation::FieldRow>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].status == FieldStatus::Ok) return static_cast<int>(i);
    return -1;
}

/// Reads the column gyro_z_degps, row by row.
std::vector<double> gyro_degps(const fs::path& log) {
    std::ifstream in(log);
    std::vector<double> values;
    std::string line;
    for (std::getline(in, line); std::getline(in, line);) {
        const auto first = line.find(',');
        const auto second = line.find(',', first + 1);
        values.push_back(std::stod(line.substr(second + 1)));
    }
    return values;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    Moments ma, mb;
    double products = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ma.add(a[i]);
        mb.add(b[i]);
        products += a[i] * b[i];
    }
    return (products / static_cast<double>(a.size()) - ma.mean() * mb.mean()) /
           (ma.deviation() * mb.deviation());
}

}  // namespace

OdometryScore odometry_score(const fs::path& folder) {
    const config::Config config = config_of("kitti.ini");
    io::KittiOdometry images(folder, "00", io::kitti_mount("00"));
    evaluation::PoseTrack truth;
    const auto rows = drive_through(images, config, truth);
    return {ok_share(rows), first_ok(rows), evaluation::compare(rows, truth)};
}

std::string odometry_part(const fs::path& folder) {
    if (!fs::exists(folder)) return std::string(odometry_text) + "Not measured: no KITTI odometry data.\n";
    const OdometryScore score = odometry_score(folder);
    const auto value = [](const std::optional<double>& v) { return v.value_or(nothing_measured); };
    Table table{{"images ok", "first ok", "omega rms, deg/s", "v bias, %", "v sd, %", "end position, %",
                 "heading at the end, deg"},
                {}};
    table.rows.push_back({cell(score.ok.percent(), 0) + " %", cell(score.first_ok, 0, below(3)),
                          cell(value(score.errors.omega_rms_degps), 2),
                          cell(value(score.errors.v_bias_percent), 1),
                          cell(value(score.errors.v_sd_percent), 1),
                          cell(value(score.errors.end_position_percent), 2, below(4.0)),
                          cell(value(score.errors.heading_end_deg), 2, below(1.0))});
    return odometry_text + to_markdown(table);
}

GyroScore gyro_score(const fs::path& folder, pipeline::SensorUse use) {
    config::Config config = config_of("donkeycar.ini");
    config.pipeline.other_sensors.gyro = use;
    io::FrameTimes times;
    times.file = folder / "log.csv";
    io::ImageFolder images(folder / "images", config.camera, times);
    evaluation::PoseTrack none;
    const auto rows = drive_through(images, config, none);
    const std::vector<double> gyro = gyro_degps(folder / "log.csv");
    GyroScore score;
    score.ok = ok_share(rows);
    std::vector<double> flow, same, magnitudes;
    for (std::size_t i = 1; i < rows.size() && i <= gyro.size(); ++i) {
        score.known.add(rows[i].omega_source != MotionSource::Prediction);
        if (rows[i].omega_source == MotionSource::Prediction) continue;
        flow.push_back(deg(rows[i].omega_radps));
        same.push_back(gyro[i - 1]);
        score.difference_degps.add(flow.back() - same.back());
        magnitudes.push_back(std::abs(flow.back() - same.back()));
    }
    score.correlation = correlation(flow, same);
    score.median_difference_degps = median(magnitudes);
    return score;
}

std::string gyro_part(const fs::path& folder) {
    if (!fs::exists(folder)) return std::string(gyro_text) + "Not measured: no DonkeyCar data.\n";
    Table table{{"gyro as input", "images ok", "turn known", "correlation", "rms difference, deg/s",
                 "median difference, deg/s", "mean difference, deg/s"},
                {}};
    const std::array<std::pair<const char*, pipeline::SensorUse>, 3> uses = {
        {{"off", pipeline::SensorUse::Off},
         {"fallback", pipeline::SensorUse::Fallback},
         {"prior", pipeline::SensorUse::Prior}}};
    for (const auto& [name, use] : uses) {
        const GyroScore score = gyro_score(folder, use);
        table.rows.push_back({name, cell(score.ok.percent(), 0) + " %", cell(score.known.percent(), 0) + " %",
                              cell(score.correlation, 3, above(0.9)), cell(score.difference_degps.rms(), 1),
                              cell(score.median_difference_degps, 1),
                              cell(score.difference_degps.mean(), 1)});
    }
    return gyro_text + to_markdown(table);
}

}  // namespace flownav::fidelity
